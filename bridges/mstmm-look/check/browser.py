"""A headless Chromium that is driven by its DevTools protocol."""

import base64
import json
import shutil
import subprocess
import tempfile
import time
import urllib.request
from pathlib import Path

import websocket

NAMES = ("chromium", "chromium-browser", "google-chrome")
SOFTWARE = ("--headless=new", "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader",
            "--ignore-gpu-blocklist", "--hide-scrollbars", "--no-first-run", "--remote-debugging-port=0",
            "--remote-allow-origins=*", "--disable-background-networking", "--force-color-profile=srgb")


def program():
    """Returns the path of Chromium, or None."""
    return next((path for path in map(shutil.which, NAMES) if path), None)


class Browser:
    """One page of a separate browser, rendered by software."""

    def __init__(self, width=1280, height=860):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.process = subprocess.Popen(
            [program(), *SOFTWARE, f"--user-data-dir={self.folder.name}", f"--window-size={width},{height}", "about:blank"],
            stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        port = self._port()
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/json", timeout=20) as answer:
            page = next(it for it in json.load(answer) if it["type"] == "page")
        self.socket = websocket.create_connection(page["webSocketDebuggerUrl"], timeout=120)
        self.number, self.errors, self.requests = 0, [], []
        for domain in ("Page", "Runtime", "Network"):
            self.send(f"{domain}.enable")

    def _port(self):
        file = Path(self.folder.name) / "DevToolsActivePort"
        for _ in range(300):
            if self.process.poll() is not None:
                raise RuntimeError(f"Chromium ended with code {self.process.returncode}")
            if file.exists() and file.read_text().strip():
                return file.read_text().split()[0]
            time.sleep(0.1)
        raise RuntimeError("Chromium did not start")

    def close(self):
        self.socket.close()
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def send(self, method, **parameters):
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            message = json.loads(self.socket.recv())
            if message.get("method") == "Runtime.exceptionThrown":
                self.errors.append(message["params"]["exceptionDetails"])
            if message.get("method") == "Network.requestWillBeSent":
                self.requests.append(message["params"]["request"]["url"])
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]

    def ask(self, expression):
        """Returns the value of an expression in the page."""
        found = self.send("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in found:
            raise RuntimeError(f"{expression}: {found['exceptionDetails']}")
        return found["result"].get("value")

    def wait(self, expression, seconds=60):
        """Waits until an expression is true."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.ask(expression):
                return
            time.sleep(0.05)
        raise AssertionError(f"not true after {seconds} s: {expression}; {self.errors}")

    def open(self, path, width=1280, height=860, dark=False):
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=width < 600)
        self.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.requests.clear()
        self.send("Page.navigate", url=Path(path).resolve().as_uri())
        self.wait("document.readyState === 'complete' && 'recording' in window")
        self.frames()

    def frames(self, count=3):
        """Waits until the page has drawn some frames."""
        self.ask(f"new Promise(done => {{ let left = {count}; const next = () => left-- ? requestAnimationFrame(next) : done(); next(); }})")

    def middle(self, selector, x=0.5, y=0.5):
        """Returns a pixel of an element, from shares of its width and height."""
        box = self.ask(f"(() => {{ const it = document.querySelector({json.dumps(selector)}); it.scrollIntoView({{ block: 'nearest' }});"
                       " const { left, top, width, height } = it.getBoundingClientRect(); return [left, top, width, height]; })()")
        return box[0] + x * box[2], box[1] + y * box[3]

    def mouse(self, kind, x, y, **more):
        self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def click(self, selector=None, at=None):
        x, y = at or self.middle(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)
        self.frames()

    def drag(self, start, by, modifiers=0):
        x, y = start
        self.mouse("mousePressed", x, y, button="left", buttons=1, clickCount=1, modifiers=modifiers)
        for step in range(1, 9):
            self.mouse("mouseMoved", x + by[0] * step / 8, y + by[1] * step / 8, button="left", buttons=1, modifiers=modifiers)
        self.mouse("mouseReleased", x + by[0], y + by[1], button="left", clickCount=1, modifiers=modifiers)
        self.frames()

    def key(self, key, code, text=""):
        self.send("Input.dispatchKeyEvent", type="keyDown", key=key, code=code, text=text)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=key, code=code)
        self.frames()

    def screenshot(self, path):
        Path(path).write_bytes(base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"]))
