# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
"""A headless Chromium, told what to do by its debugging protocol over two pipes."""
import base64
import itertools
import json
import os
import select
import subprocess
import tempfile
import time


class Browser:
    """Chromium with one page; a context manager."""

    def __init__(self, program="chromium", timeout=120):
        self.timeout = timeout
        self.folder = tempfile.TemporaryDirectory(prefix="tensortopo-browser-")
        to_browser, self.write_end = os.pipe()
        self.read_end, from_browser = os.pipe()

        def take_pipes():
            # First out of the way of each other.
            a, b = os.dup(to_browser), os.dup(from_browser)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [program, "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--remote-debugging-pipe", "--no-first-run",
             "--disable-gpu-sandbox", "--disable-dev-shm-usage", "--window-size=1300,1000",
             f"--user-data-dir={self.folder.name}", "about:blank"],
            preexec_fn=take_pipes, close_fds=False, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(to_browser)
        os.close(from_browser)
        self.numbers = itertools.count(1)
        self.pending = b""
        self.events = []
        self.session = None
        (page,) = [t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page"]
        self.session = self.call(
            "Target.attachToTarget", targetId=page["targetId"], flatten=True
        )["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self.write_end)
        os.close(self.read_end)
        for _ in range(20):  # its children may still write there
            try:
                self.folder.cleanup()
                return
            except OSError:
                time.sleep(0.2)

    def message(self, deadline):
        while b"\0" not in self.pending:
            ready, _, _ = select.select([self.read_end], [], [], max(0, deadline - time.time()))
            if not ready:
                raise TimeoutError("the browser does not answer")
            data = os.read(self.read_end, 1 << 20)
            if not data:
                raise ConnectionError("the browser has ended")
            self.pending += data
        text, self.pending = self.pending.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **params):
        """Calls a method of the protocol; events that come meanwhile are kept."""
        number = next(self.numbers)
        request = {"id": number, "method": method, "params": params}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.write_end, json.dumps(request).encode() + b"\0")
        deadline = time.time() + self.timeout
        while True:
            message = self.message(deadline)
            if message.get("id") == number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
            if "method" in message:
                self.events.append(message)

    def evaluate(self, expression):
        """The value of an expression, or of what it promises."""
        answer = self.call(
            "Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True
        )
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def open(self, url, ready):
        """Opens a page, and waits until an expression is true."""
        self.call("Page.navigate", url=url)
        deadline = time.time() + self.timeout
        while time.time() < deadline:
            try:
                if self.evaluate(ready):
                    return
            except RuntimeError:
                pass  # it is not there yet
            time.sleep(0.1)
        raise TimeoutError(f"{url}: {ready} stays false")

    def requests(self):
        """The addresses that were asked for."""
        return [e["params"]["request"]["url"] for e in self.events
                if e["method"] == "Network.requestWillBeSent"]  # fmt: skip

    def complaints(self):
        """Errors in the page and its log."""
        texts = [e["params"]["exceptionDetails"]["text"] for e in self.events
                 if e["method"] == "Runtime.exceptionThrown"]  # fmt: skip
        return texts + [e["params"]["entry"]["text"] for e in self.events
                        if e["method"] == "Log.entryAdded"
                        and e["params"]["entry"]["level"] == "error"]  # fmt: skip

    def picture(self, file):
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=True)["data"]
        with open(file, "wb") as stream:
            stream.write(base64.b64decode(data))
