"""send_signal.py WORD DELAY SIGNALS MOST COMMAND...: runs a command; DELAY seconds after it has said WORD on
stderr, sends it the signals. Ends with the command's exit code, 97 if it took over MOST seconds to end then,
96 if it died of a signal.
"""
import os, signal, subprocess, sys, time


def main():
    word, delay, most = sys.argv[1].encode(), float(sys.argv[2]), float(sys.argv[4])
    child = subprocess.Popen(sys.argv[5:], stderr=subprocess.PIPE)
    said = b""
    while word not in said:
        got = os.read(child.stderr.fileno(), 4096)
        if not got:
            break
        said += got
    time.sleep(delay)
    began = time.monotonic()
    for number in sys.argv[3].split(","):
        child.send_signal(int(number))
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
