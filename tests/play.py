#!/usr/bin/env python3
"""Opens the page to play with in a headless Chromium, makes four pictures of it, and kicks 200 balls at 10 per second.

    tests/play.py PAGE DIR [KICKS]

Prints one line a check; exit code 1 at the first that fails. An error or a warning on the console and a promise that nobody
handles fail it. Speaks the DevTools protocol over a pipe, so it needs only Python.
"""
import base64
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading
import time

BROWSERS = ["chromium-headless-shell", "chromium", "chromium-browser", "google-chrome"]
PATIENCE = 120


class Failed(Exception):
    pass


class Page:
    """A page in a browser of its own."""

    def __init__(self, address, width, height, dark, touch):
        browser = next((found for found in map(shutil.which, BROWSERS) if found), None)
        if browser is None:
            raise Failed("no Chromium: apt-get install chromium-headless-shell")
        self.errors, self.answers, self.session, self.number = [], {}, None, 0
        self.news = threading.Condition()
        self.profile = tempfile.mkdtemp()
        to_browser, self.to = os.pipe()
        self.back, from_browser = os.pipe()
        command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe",
                   "--host-resolver-rules=MAP * ~NOTFOUND", f"--user-data-dir={self.profile}", "about:blank"]
        # The browser reads from descriptor 3 and writes to 4.
        self.process = subprocess.Popen(["bash", "-c", f'exec "$@" 3<&{to_browser} 4>&{from_browser}', "bash", *command],
                                        pass_fds=(to_browser, from_browser), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        threading.Thread(target=self.listen, daemon=True).start()
        target = next(item for item in self.send("Target.getTargets")["targetInfos"] if item["type"] == "page")
        self.session = self.send("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.send(domain + ".enable")
        self.send("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=touch)
        self.send("Emulation.setTouchEmulationEnabled", enabled=touch, maxTouchPoints=5 if touch else 1)
        self.send("Page.navigate", url=address)
        self.until("document.body && (document.body.dataset.ready || document.body.dataset.failed)")
        if self.run("document.body.dataset.failed"):
            raise Failed(self.run("document.body.dataset.failed"))

    def listen(self):
        rest = b""
        while part := os.read(self.back, 1 << 20):
            *messages, rest = (rest + part).split(b"\0")
            for message in map(json.loads, messages):
                with self.news:
                    self.take(message)
                    self.news.notify_all()

    def take(self, message):
        method, values = message.get("method"), message.get("params", {})
        if "id" in message:
            self.answers[message["id"]] = message
        elif method == "Runtime.exceptionThrown":
            details = values["exceptionDetails"]
            self.errors.append(details["text"] + " " + details.get("exception", {}).get("description", ""))
        elif method == "Runtime.consoleAPICalled" and values["type"] in ("error", "warning", "assert"):
            self.errors.append(" ".join(str(item.get("value", item.get("description"))) for item in values["args"]))
        elif method == "Log.entryAdded" and values["entry"]["level"] == "error":
            self.errors.append(values["entry"]["text"])

    def send(self, method, **values):
        with self.news:
            self.number += 1
            number = self.number
            message = {"id": number, "method": method, "params": values}
            if self.session:
                message["sessionId"] = self.session
            os.write(self.to, json.dumps(message).encode() + b"\0")
            if not self.news.wait_for(lambda: number in self.answers, PATIENCE):
                raise Failed(f"no answer to {method}")
            answer = self.answers.pop(number)
        if "error" in answer:
            raise Failed(f"{method}: {answer['error']['message']}")
        return answer["result"]

    def run(self, script):
        answer = self.send("Runtime.evaluate", expression=script, returnByValue=True)
        if "exceptionDetails" in answer:
            raise Failed(f"{script}: {answer['exceptionDetails']['exception']['description']}")
        return answer["result"].get("value")

    def until(self, script):
        end = time.monotonic() + PATIENCE
        while not self.run(script):
            if time.monotonic() > end:
                raise Failed(f"never: {script}")
            time.sleep(0.05)

    def press(self, key):
        self.send("Input.dispatchKeyEvent", type="keyDown", key=key)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=key)

    def click(self, place):
        x, y = self.run(f"playground.stage.camera.project([{place}])")[:2]
        for kind, buttons in (("mousePressed", 1), ("mouseReleased", 0)):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=buttons, clickCount=1)

    def picture(self, path):
        pathlib.Path(path).write_bytes(base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"]))

    def check(self, what, holds):
        if self.errors:
            raise Failed(f"{what}: on the console: {self.errors[0]} (and {len(self.errors) - 1} more)")
        if not holds:
            raise Failed(what)

    def close(self):
        try:
            self.send("Browser.close")
            self.process.wait(20)
        except (Failed, OSError, subprocess.TimeoutExpired):
            self.process.kill()
        shutil.rmtree(self.profile, ignore_errors=True)


def pictures(address, folder):
    for width, height in ((1280, 900), (390, 844)):
        for dark in (False, True):
            name = f"play-{width}-{'dark' if dark else 'light'}"
            page = Page(address, width, height, dark, touch=width < 600)
            try:
                page.check(f"{name}: nothing beyond the edge", page.run("document.documentElement.scrollWidth") == width)
                page.check(f"{name}: the theme", page.run("playground.stage.dark") == dark)
                page.until("playground.stage.ahead.length > 5 && document.getElementById('stage').dataset.drawn")
                time.sleep(0.3)
                page.picture(f"{folder}/{name}.png")
            finally:
                page.close()
    print(f"ok    play: 1280 and 390 pixels wide, light and dark: {folder}/play-*.png", flush=True)


def kicks(address, count):
    """Kicks by the key, the button and clicks in the goal, each ten a second, so that every kick interrupts the one before it."""
    page = Page(address, 1280, 900, dark=False, touch=False)
    try:
        begun = time.monotonic()
        late = 0
        for i in range(count):
            if i % 10 == 9:
                page.click("2.5, 1.5, -22")
            if i % 3 == 2:
                page.run("document.getElementById('kick').click()")
            else:
                page.press(" ")
            left = begun + 0.1 * (i + 1) - time.monotonic()
            late += left < -0.1
            time.sleep(max(0, left))
        seconds = time.monotonic() - begun
        page.until("playground.flights.length > 0 && playground.flights.every(f => f.isOver)")
        page.until("document.body.dataset.verdict")
        counted = int(page.run("document.getElementById('kicks').textContent"))
        page.check(f"{count} kicks: the page counted {counted}", counted == count)
        print(f"ok    play: {count} kicks in {seconds:.1f} s ({late} late), each before the last was over; no error on the console", flush=True)
    finally:
        page.close()


def main():
    address, folder = pathlib.Path(sys.argv[1]).resolve().as_uri(), sys.argv[2]
    pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
    try:
        pictures(address, folder)
        kicks(address, int(sys.argv[3]) if len(sys.argv) > 3 else 200)
    except Failed as why:
        print(f"FAIL  play: {why}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
