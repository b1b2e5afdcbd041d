"""send_signal.py WORDS DELAY SIGNALS MOST COMMAND...: runs a command; DELAY seconds after it has said the first of
WORDS on stderr, sends it the first of the signals, and each further one when its word is said, or at once where
there is none. Ends with the command's exit code, 97 if it took over MOST seconds to end then, 96 if it died of
a signal.
"""
import os, signal, subprocess, sys, time


def wait_for(word, said, child):
    while word not in said:
        got = os.read(child.stderr.fileno(), 4096)
        if not got:
            break
        said += got


def main():
    words, delay, most = sys.argv[1].encode().split(b","), float(sys.argv[2]), float(sys.argv[4])
    child = subprocess.Popen(sys.argv[5:], stderr=subprocess.PIPE)
    said = bytearray()
    wait_for(words[0], said, child)
    time.sleep(delay)
    began = time.monotonic()
    for i, number in enumerate(sys.argv[3].split(",")):
        if i > 0 and i < len(words):
            wait_for(words[i], said, child)
        child.send_signal(int(number))
        if i >= len(words) - 1:
            time.sleep(0.02)
    said += child.communicate()[1]
    took = time.monotonic() - began
    sys.stderr.write(said.decode(errors="replace"))
    if took > most:
        sys.stderr.write("took %.2f s to end\n" % took)
        return 97
    return child.returncode if child.returncode >= 0 else 96


if __name__ == "__main__":
    sys.exit(main())
