"""Running renderers, measuring them, reading pictures, and the folder that keeps what is costly."""
import hashlib, json, os, tempfile
from collections import namedtuple
import numpy as np

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))

Run = namedtuple("Run", "picture cpu stats")


def run(command, folder, nice=0):
    """-> (user + system CPU seconds of the process and its threads, what it printed). Raises where it fails."""
    with tempfile.TemporaryFile() as said:
        child = os.fork()
        if child == 0:
            try:
                os.chdir(folder)
                os.nice(nice)
                os.dup2(said.fileno(), 1)
                os.dup2(said.fileno(), 2)
                os.execvp(command[0], command)
            finally:
                os._exit(127)
        _, status, used = os.wait4(child, 0)
        said.seek(0)
        text = said.read().decode(errors="replace")
    if status != 0:
        raise RuntimeError("%s\nin %s ended with status %d:\n%s" % (" ".join(command), folder, status, text[-2000:]))
    return used.ru_utime + used.ru_stime, text


def read_pfm(path):
    """(h, w, 3), the first row on top"""
    with open(path, "rb") as f:
        if f.readline().strip() != b"PF":
            raise ValueError(path + " is no colour PFM")
        width, height = map(int, f.readline().split())
        order = "<f4" if float(f.readline()) < 0 else ">f4"
        return np.frombuffer(f.read(), order).reshape(height, width, 3)[::-1].astype(np.float64)


def read_ppm(path):
    """16-bit PPM as POV-Ray writes it, values 0 to 1"""
    with open(path, "rb") as f:
        data = f.read()
    fields, at = [], 0
    while len(fields) < 4:
        line_end = data.index(b"\n", at)
        fields += data[at:line_end].split(b"#")[0].split()
        at = line_end + 1
    if fields[0] != b"P6" or fields[3] != b"65535":
        raise ValueError("%s is no PPM of 16 bits: %r" % (path, fields))
    width, height = int(fields[1]), int(fields[2])
    return np.frombuffer(data, ">u2", 3 * width * height, at).reshape(height, width, 3) / 65535.0


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def clipped_error(picture, truth):
    """RMSE over all channels of values clipped to [0, 1]"""
    return rms(np.clip(picture, 0, 1) - np.clip(truth, 0, 1))


def float_error(picture, truth):
    """RMSE as --error means it for a file of floats: |difference| / max(1, |value|). Never below clipped_error."""
    return rms((picture - truth) / np.maximum(1.0, np.abs(picture)))


def render(project, script, size, *options, nice=0):
    """One run of the program -> Run, with the statistics of its one picture"""
    folder, name = os.path.split(script)
    with tempfile.TemporaryDirectory(prefix="bench-") as out:
        picture, stats = os.path.join(out, "p.pfm"), os.path.join(out, "s.json")
        cpu, _ = run([project, name, "-q", "--size", "%dx%d" % tuple(size), "-o", picture, "--stats", stats, *options],
                     folder, nice)
        with open(stats) as f:
            return Run(read_pfm(picture), cpu, json.load(f)["renders"][0])


def digest(*parts):
    h = hashlib.sha256()
    for part in parts:
        h.update(repr(part).encode() + b"\0")
    return h.hexdigest()[:16]


def write_if_changed(path, text):
    if os.path.exists(path):
        with open(path) as f:
            if f.read() == text:
                return
    with open(path, "w") as f:
        f.write(text)


def read_json(path, default):
    if not os.path.exists(path):
        return default
    with open(path) as f:
        return json.load(f)


def write_json(path, value):
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path + ".part", "w") as f:
        json.dump(value, f, indent=1)
        f.write("\n")
    os.replace(path + ".part", path)


def add_arguments(parser):
    parser.add_argument("--project", default=os.path.join(TOP, "Project"), help="the program")
    parser.add_argument("--cache", default=os.path.join(TOP, "build", "bench"),
                        help="scenes, converged pictures and POV-Ray's results are kept here (build/bench)")
    parser.add_argument("--fresh", action="store_true", help="make the converged pictures again")
    parser.add_argument("--nice", type=int, default=10)
