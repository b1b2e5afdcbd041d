"""The program on a pseudo terminal: what a person at a keyboard sees."""
import fcntl, os, pty, re, select, struct, subprocess, termios, time

ESCAPE = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")
REDRAWN = "\r\x1b[K"


def on_terminal(command, folder, columns=80, seconds=60, env=None):
    """-> exit code, stdout (a pipe), and what the terminal at stderr was sent"""
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    environment = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
    environment.update({"TERM": "xterm"}, **(env or {}))
    running = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=theirs)
    os.close(theirs)
    shown, end = b"", time.monotonic() + seconds
    try:
        while time.monotonic() < end:
            if not select.select([ours], [], [], 1)[0]:
                continue
            try:
                part = os.read(ours, 65536)
            except OSError:  # Linux says so when the last writer has gone
                break
            if not part:
                break
            shown += part
        out = running.communicate(timeout=10)[0]
    finally:
        if running.poll() is None:
            running.kill()
            running.communicate()
        os.close(ours)
    return running.returncode, out, shown.decode()


def bars(shown):
    """The bars as they were drawn, without colours."""
    return [ESCAPE.sub("", part.split("\r\n")[0]) for part in shown.split(REDRAWN)[1:]]
