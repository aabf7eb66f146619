"""Opens the page of a running tree in Chromium and looks at what it shows.

usage: page_test.py COPPICE FOLDER_OF_THE_PAGE [PICTURE.png]
"""
import base64
import fcntl
import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.request

TIMEOUT = 120
RUNNING = (0xF0, 0xAA, 0x28)  # of the dark palette
TREE = """<root BTCPP_format="4"><BehaviorTree ID="Watched"><Sequence name="top">
<Delay delay_msec="300"><AlwaysSuccess name="first"/></Delay>
<KeepRunningUntilFailure><Sequence name="work"><Sleep name="rest" msec="800"/>
<Script code="rounds := 1"/></Sequence></KeepRunningUntilFailure></Sequence></BehaviorTree></root>"""


class Browser:
    """Chromium without a window, talked to through a pipe (Chrome DevTools Protocol)."""

    def __init__(self, folder):
        read_here, write_there = os.pipe()
        read_there, write_here = os.pipe()

        def connect():
            # Not in the place of each other: 3 or 4 may be one of these two.
            reader = fcntl.fcntl(read_there, fcntl.F_DUPFD, 10)
            writer = fcntl.fcntl(write_there, fcntl.F_DUPFD, 10)
            os.dup2(reader, 3)
            os.dup2(writer, 4)
        self.process = subprocess.Popen(
            [shutil.which("chromium"), "--headless", "--no-sandbox", "--disable-gpu",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-first-run",
             "--disable-quic", "--disable-background-networking", "--disable-component-update",
             "--disable-sync", "--user-data-dir=" + folder, "--remote-debugging-pipe", "about:blank"],
            preexec_fn=connect, close_fds=False, stderr=subprocess.DEVNULL)
        os.close(read_there)
        os.close(write_there)
        self.reader, self.writer = os.fdopen(read_here, "rb"), write_here
        self.number, self.session = 0, None
        targets = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in targets if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"],
                                 flatten=True)["sessionId"]

    def read(self):
        message = b""
        while True:
            byte = self.reader.read(1)
            if byte == b"\0":
                return json.loads(message)
            if not byte:
                raise EOFError("the browser has ended")
            message += byte

    def call(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.writer, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.read()
            if answer.get("id") == self.number:
                assert "error" not in answer, answer
                return answer["result"]

    def evaluate(self, script):
        result = self.call("Runtime.evaluate", expression=script, awaitPromise=True,
                           returnByValue=True)
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def close(self):
        self.process.terminate()
        self.process.wait(TIMEOUT)


# Right after a frame was drawn, while its pixels are still there.
COUNT = """new Promise(resolve => {
  Module.onFrame = () => {
    Module.onFrame = () => {};
    const copy = document.createElement("canvas");
    copy.width = Module.canvas.width;
    copy.height = Module.canvas.height;
    const context = copy.getContext("2d");
    context.drawImage(Module.canvas, 0, 0);
    const pixels = context.getImageData(0, 0, copy.width, copy.height).data;
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4)
      count += pixels[i] == %d && pixels[i + 1] == %d && pixels[i + 2] == %d;
    resolve(count);
  };
  dispatchEvent(new MouseEvent("mousemove", {clientX: 600 + performance.now() %% 7, clientY: 300}));
})"""


def wait_for(what, question):
    deadline = time.monotonic() + TIMEOUT
    while time.monotonic() < deadline:
        answer = question()
        if answer:
            return answer
        time.sleep(0.1)
    raise AssertionError("never happened: " + what)


# The text of a file as the browser keeps it, or nothing.
KEPT = """new Promise(resolve => {
  const opening = indexedDB.open("/trees");
  opening.onerror = () => resolve("");
  opening.onsuccess = () => {
    const files = opening.result.transaction("FILE_DATA").objectStore("FILE_DATA");
    const getting = files.get("/trees/mine.xml");
    getting.onsuccess = () => {
      opening.result.close();
      resolve(getting.result ? new TextDecoder().decode(getting.result.contents) : "");
    };
  };
})"""


def visit(browser, address):
    browser.call("Page.navigate", url="about:blank")
    browser.call("Page.navigate", url=address)
    return wait_for("a first frame", lambda: browser.evaluate(
        "performance.getEntriesByName('first frame').map(mark => mark.startTime)[0] || 0"))


def keeps_files(browser, address):
    browser.evaluate("FS.writeFile('/trees/mine.xml', %s); show('/trees/mine.xml')" %
                     json.dumps(TREE))
    wait_for("a file kept by the browser", lambda: browser.evaluate(KEPT) == TREE)
    visit(browser, address)
    again = wait_for("the file of the last visit", lambda: browser.evaluate(
        "opened && FS.readFile(opened, {encoding: 'utf8'})"))
    assert again == TREE, again


KEY_CODES = {"Tab": 9, "Enter": 13, "ArrowDown": 40}
CTRL = 2


def press(browser, key, modifiers=0):
    """A key as the keyboard sends it; letters type themselves unless Ctrl is held."""
    code = KEY_CODES.get(key) or ord(key.upper())
    types = len(key) == 1 and not modifiers
    about = {"key": key, "windowsVirtualKeyCode": code, "modifiers": modifiers}
    browser.call("Input.dispatchKeyEvent", type="keyDown" if types else "rawKeyDown",
                 **(dict(about, text=key) if types else about))
    browser.call("Input.dispatchKeyEvent", type="keyUp", **about)


def chord(browser, key):
    control = {"key": "Control", "windowsVirtualKeyCode": 17}
    browser.call("Input.dispatchKeyEvent", type="rawKeyDown", modifiers=CTRL, **control)
    press(browser, key, CTRL)
    browser.call("Input.dispatchKeyEvent", type="keyUp", **control)


def click(browser, selector):
    place = browser.evaluate("(() => { const r = document.querySelector(%s).getBoundingClientRect();"
                             "return [r.x + r.width / 2, r.y + r.height / 2]; })()" %
                             json.dumps(selector))
    for kind in ("mousePressed", "mouseReleased"):
        browser.call("Input.dispatchMouseEvent", type=kind, x=place[0], y=place[1], button="left",
                     clickCount=1)


MINE = """<root BTCPP_format="4">
  <BehaviorTree ID="Mine">
    <Sequence name="all">
      <AlwaysSuccess/>
    </Sequence>
  </BehaviorTree>
</root>
"""


def is_edited_and_taken_back(browser, scratch):
    """A file of this computer is opened, gets a node by keys alone, is saved and downloaded."""
    path, downloads = scratch + "/edited.xml", scratch + "/downloads"
    os.mkdir(downloads)
    with open(path, "w") as file:
        file.write(MINE)
    browser.call("Browser.setDownloadBehavior", behavior="allow", downloadPath=downloads)
    field = browser.call("Runtime.evaluate", expression="chooser")["result"]["objectId"]
    browser.call("DOM.setFileInputFiles", files=[path], objectId=field)
    wait_for("the chosen file", lambda: browser.evaluate("opened") == "/trees/edited.xml")
    click(browser, "#canvas")
    asked = browser.evaluate("window.left = 0; addEventListener('keydown', event => {"
                             "left += event.ctrlKey && !event.defaultPrevented; }); left")
    assert asked == 0
    for key in ["ArrowDown", "Tab", *"forcefail", "Enter"]:
        press(browser, key)
    chord(browser, "s")

    def saved():
        return browser.evaluate("FS.readFile(opened, {encoding: 'utf8'})")
    wait_for("the node that was typed, saved", lambda: "<ForceFailure" in saved())
    assert browser.evaluate("left") <= 1, "the browser would save the page, too"  # Control itself
    click(browser, "#download")
    there = downloads + "/edited.xml"
    wait_for("the file in the downloads", lambda: os.path.exists(there) and
             open(there).read() == saved())
    assert saved().replace("      <ForceFailure/>\n", "") == MINE, saved()


def is_sent_compressed(address):
    """The program of the page, as a browser asks for it."""
    where = address.split("#")[0] + "index.wasm"
    plain = urllib.request.urlopen(where).read()
    asked = urllib.request.Request(where, headers={"Accept-Encoding": "gzip"})
    with urllib.request.urlopen(asked) as answer:
        assert answer.headers["Content-Encoding"] == "gzip", answer.headers
        packed = answer.read()
    assert gzip.decompress(packed) == plain
    print("the program: %d bytes, sent as %d" % (len(plain), len(packed)))


def look(browser, address, picture):
    browser.call("Emulation.setDeviceMetricsOverride", width=1280, height=800,
                 deviceScaleFactor=1, mobile=False)
    print("first frame after %.0f ms" % visit(browser, address))
    wait_for("a running node in its colour",
             lambda: browser.evaluate(COUNT % RUNNING) > 100)
    shot = browser.call("Page.captureScreenshot", format="png")["data"]
    if picture:
        with open(picture, "wb") as file:
            file.write(base64.b64decode(shot))


def main(coppice, folder, picture=None):
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as scratch:
        with open(scratch + "/tree.xml", "w") as file:
            file.write(TREE)
        robot = subprocess.Popen(
            [coppice, "run", scratch + "/tree.xml", "--forever", "--quiet", "--live-port", "0",
             "--web-port", "0", "--web-folder", folder], stderr=subprocess.PIPE, text=True)
        browser = None
        try:
            address = None
            while not address:
                line = robot.stderr.readline()
                assert line and not line.startswith("no page"), "there is no page: " + line
                address = re.search(r"in a browser: (\S+)", line)
            is_sent_compressed(address.group(1))
            browser = Browser(scratch + "/profile")
            look(browser, address.group(1), picture)
            is_edited_and_taken_back(browser, scratch)
            keeps_files(browser, address.group(1))
        finally:
            if browser:
                browser.close()
            robot.terminate()
            robot.wait(TIMEOUT)


if __name__ == "__main__":
    main(*sys.argv[1:])
