#!/usr/bin/env python3
"""preview.py PROJECT [PICTURES]: the page of --preview in a real browser (Debian's chromium, headless).

A scene is written while the page is looked at: it refines, shows maps and values, zooms, shows an error
of the script beside the last picture, and stops. PICTURES is a folder for screenshots.
"""
import base64, json, os, re, shutil, subprocess, sys, tempfile, time

SCENE = """
local root = gr.node('root')
root:add_child(gr.sphere('ball'), gr.material({0.8, 0.4, 0.2}, {0.5, 0.5, 0.5}, 30))
root:add_child(gr.nh_box('floor', {-5, -2, -5}, {10, 1, 10}), gr.material({0.5, 0.5, 0.6}, {0, 0, 0}, 0))
gr.render(root, 'ball.png', 640, 400, {0, 1, 5}, {0, -0.2, -1}, {0, 1, 0}, 45, {0.2, 0.2, 0.2},
          {gr.light({5, 8, 5}, {0.8, 0.8, 0.8}, {1, 0, 0}, 1)})
"""


class Browser:
    """Chromium by its debugging pipe: JSON messages that end with a zero byte."""

    def __init__(self, folder):
        to_child, self.commands = os.pipe()
        self.answers, from_child = os.pipe()

        def wire():
            # Away from 3 and 4 first, which may be among the ends themselves.
            os.dup2(to_child, 20), os.dup2(from_child, 21)
            os.dup2(20, 3), os.dup2(21, 4)

        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--window-size=1000,760",
             "--user-data-dir=" + os.path.join(folder, "browser"), "about:blank"],
            pass_fds=(3, 4, to_child, from_child), preexec_fn=wire, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_child), os.close(from_child)
        self.number, self.buffer, self.problems = 0, b"", []
        pages = [t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page"]
        self.session = self.ask("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        for domain in "Page", "Runtime", "Log", "Network":
            self.ask(domain + ".enable")

    session = None

    def ask(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.commands, json.dumps(message).encode() + b"\0")
        while True:
            while b"\0" not in self.buffer:
                part = os.read(self.answers, 1 << 16)
                assert part, "the browser has gone"
                self.buffer += part
            line, self.buffer = self.buffer.split(b"\0", 1)
            answer = json.loads(line)
            if answer.get("id") == self.number:
                assert "error" not in answer, answer
                return answer["result"]
            if answer.get("method") in ("Runtime.exceptionThrown", "Log.entryAdded"):
                self.problems.append(answer["params"])

    def value(self, expression):
        return self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)["result"].get("value")

    def wait(self, expression, seconds=60):
        end = time.monotonic() + seconds
        while not self.value(expression):
            assert time.monotonic() < end, expression + "\n" + str(self.value("document.body.innerText"))
            time.sleep(0.1)

    def mouse(self, kind, x, y, **more):
        self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, selector):
        box = self.value("JSON.stringify(document.querySelector(%r).getBoundingClientRect())" % selector)
        box = json.loads(box)
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        for kind in "mousePressed", "mouseReleased":
            self.mouse(kind, x, y, button="left", clickCount=1)

    def screenshot(self, path):
        with open(path, "wb") as f:
            f.write(base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"]))

    def close(self):
        self.process.terminate()
        self.process.wait(timeout=20)


def write(folder, text):
    with open(os.path.join(folder, "scene.lua"), "w") as f:
        f.write(text)


def look(browser, folder, pictures, address):
    browser.ask("Page.navigate", url=address)
    browser.wait("picture && status.version > 0")
    browser.screenshot(os.path.join(pictures, "1_refining.png"))
    assert browser.value("status.running"), "the scene is to take longer"
    browser.wait("status.error !== null")
    assert "left" in browser.value("document.getElementById('state').innerText")

    # Values under the pointer: the ball is orange in the middle of the image.
    box = json.loads(browser.value("JSON.stringify(document.querySelector('canvas').getBoundingClientRect())"))
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    browser.mouse("mouseMoved", x, y)
    browser.wait("/samples/.test(document.getElementById('pixel').innerText)")
    shown = re.search(r"\((\d+), (\d+)\)\s+([\d.]+)\s+([\d.]+)\s+([\d.]+)", browser.value("document.getElementById('pixel').innerText"))
    assert abs(int(shown[1]) - 320) <= 2 and abs(int(shown[2]) - 200) <= 2, shown.groups()
    assert float(shown[3]) > float(shown[5]), shown.groups()

    browser.wait("status.largestError > 0")
    for name, number in (("error", 2), ("samples", 3)):
        browser.click("[data-map=%s]" % name)
        browser.wait("shown.startsWith('%s')" % name)
        browser.screenshot(os.path.join(pictures, "%d_%s.png" % (number, name)))
    browser.click("[data-map=image]")
    browser.wait("shown.startsWith('image')")
    fitted = browser.value("place()")
    for _ in range(6):
        browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=-100)
    browser.wait("zoom > 3 * %g" % fitted)
    browser.screenshot(os.path.join(pictures, "4_zoomed.png"))
    browser.click("#fit")
    browser.wait("place() === %r" % fitted)

    write(folder, SCENE + "error('a wall is missing')")
    browser.wait("/scene.lua:\\d+: error: a wall is missing/.test(document.getElementById('messages').innerText)")
    assert browser.value("picture !== null"), "the last picture has gone"
    browser.screenshot(os.path.join(pictures, "5_error.png"))
    write(folder, SCENE.replace("0.8, 0.4, 0.2", "0.2, 0.8, 0.3"))
    browser.wait("status.running && !status.messages.length")
    browser.wait("status.version > 0 && status.error !== null")
    browser.click("#stop")
    browser.wait("!status.running && document.getElementById('stop').disabled")
    browser.screenshot(os.path.join(pictures, "6_stopped.png"))
    assert os.path.exists(os.path.join(folder, "ball.partial.png"))
    assert not browser.problems, browser.problems


def main():
    if sys.argv[1:2] in ([], ["--help"]):
        sys.exit(__doc__)
    folder = tempfile.mkdtemp(prefix="rt-browser-")
    pictures = sys.argv[2] if len(sys.argv) > 2 else folder
    os.makedirs(pictures, exist_ok=True)
    write(folder, SCENE)
    project = subprocess.Popen([os.path.abspath(sys.argv[1]), "scene.lua", "--watch", "--preview", "--preview-port", "0", "--error",
                                "1e-6"], cwd=folder, stderr=subprocess.PIPE, text=True)
    browser = None
    try:
        address = re.match(r"Preview: (http://127.0.0.1:\d+/)\n", project.stderr.readline())[1]
        with open(os.path.join(folder, "said"), "w") as said:  # what is not read would fill the pipe
            drain = subprocess.Popen(["cat"], stdin=project.stderr, stdout=said)
        browser = Browser(folder)
        look(browser, folder, pictures, address)
    finally:
        project.kill()
        project.wait()
        if browser:
            browser.close()
        drain.wait()
        shutil.rmtree(folder, ignore_errors=True)
    print("the page works")


if __name__ == "__main__":
    main()
