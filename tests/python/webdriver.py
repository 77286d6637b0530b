# SPDX-License-Identifier: BSD-3-Clause
"""A headless Chromium, driven through chromedriver's WebDriver protocol (W3C) with what Python brings along."""

import base64
import json
import re
import subprocess
import time
import urllib.error
import urllib.request

# No GPU where tests run: WebGL by software. No sandbox: containers forbid Chromium's.
ARGUMENTS = [
    "--headless=new",
    "--no-sandbox",
    "--disable-dev-shm-usage",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--force-prefers-reduced-motion",
]
KEYS = {"space": " ", "right": "\ue014", "home": "\ue011", "end": "\ue010"}
PATIENCE = 60  # seconds; the machine may be busy


class Browser:
    """Use with `with`: the browser ends with it."""

    def __enter__(self):
        self._driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        try:
            self._base = f"http://127.0.0.1:{self._port()}"
            options = {"args": ARGUMENTS}
            wanted = {"browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
            session = self._call("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})
            self._session = "/session/" + session["sessionId"]
            self._command("Browser.setDownloadBehavior", {"behavior": "deny"})  # not into somebody's home
        except BaseException:
            self._driver.kill()
            raise
        return self

    def __exit__(self, *_):
        try:
            self._call("DELETE", self._session)
        finally:
            self._driver.terminate()
            self._driver.wait(PATIENCE)

    def _port(self):
        for line in self._driver.stdout:
            found = re.search(r"successfully on port (\d+)", line)
            if found:
                return found[1]
        raise RuntimeError("chromedriver did not start")

    def _call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self._base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=2 * PATIENCE) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from error

    def _command(self, name, parameters):
        """One of Chromium's own."""
        self._call("POST", self._session + "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def open(self, address):
        self._call("POST", self._session + "/url", {"url": address})

    def script(self, code, *arguments):
        """What a script returns; it sees its arguments as arguments[0], ..."""
        return self._call("POST", self._session + "/execute/sync", {"script": code, "args": list(arguments)})

    def wait(self, code, *arguments):
        """Until a script returns something true. \\return that"""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            value = self.script(code, *arguments)
            if value:
                return value
            time.sleep(0.05)
        raise AssertionError(f"never came true: {code}")

    def find(self, selector):
        found = self._call("POST", self._session + "/element", {"using": "css selector", "value": selector})
        return next(iter(found.values()))

    def click(self, selector):
        """A click as a reader's: the element must be there to be seen."""
        self.script(
            "document.querySelector(arguments[0]).scrollIntoView({block: 'center', behavior: 'instant'})", selector
        )
        self._call("POST", f"{self._session}/element/{self.find(selector)}/click", {})

    def type(self, selector, text):
        self._call("POST", f"{self._session}/element/{self.find(selector)}/value", {"text": text})

    def press(self, key):
        """One key, to whatever has the focus."""
        value = KEYS.get(key, key)
        strokes = [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]
        actions = [{"type": "key", "id": "keyboard", "actions": strokes}]
        self._call("POST", self._session + "/actions", {"actions": actions})

    def point(self, selector, x, y):
        """Moves the pointer to a place of an element, from its middle."""
        self.script(
            "document.querySelector(arguments[0]).scrollIntoView({block: 'center', behavior: 'instant'})", selector
        )
        origin = {"element-6066-11e4-a52e-4f735466cecf": self.find(selector)}
        move = {"type": "pointerMove", "duration": 0, "origin": origin, "x": x, "y": y}
        self._call(
            "POST", self._session + "/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": [move]}]}
        )

    def size(self, width, height):
        size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self._command("Emulation.setDeviceMetricsOverride", size)

    def complaints(self):
        """What the console has got since the last call, other than information."""
        entries = self._call("POST", self._session + "/se/log", {"type": "browser"})
        return [entry["message"] for entry in entries if entry["level"] in ("SEVERE", "WARNING")]

    def screenshot(self, file):
        file.write_bytes(base64.b64decode(self._call("GET", self._session + "/screenshot")))
