"""A real browser for tests of pages: headless Chromium, which may not use the network.

Chromium and its driver are the system's own (Debian: chromium, chromium-driver); nothing is downloaded.
"""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from typing import Any

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.remote.webelement import WebElement
from selenium.webdriver.support.ui import WebDriverWait

WAIT = 20  # seconds: how long a page may take to become what is expected


class NoBrowserError(RuntimeError):
    """Chromium or its driver is not installed."""


class Browser:
    """One Chromium.  Raises NoBrowserError if there is none."""

    def __init__(self) -> None:
        program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
        driver = shutil.which("chromedriver")
        if not program or not driver:
            raise NoBrowserError(
                "chromium and chromedriver are needed; on Debian: apt install chromium chromium-driver"
            )
        os.environ["SE_OFFLINE"] = "true"
        options = Options()
        options.binary_location = program
        for flag in (
            "headless=new",
            "no-sandbox",
            "disable-dev-shm-usage",
            "hide-scrollbars",
            "force-device-scale-factor=1",
        ):
            options.add_argument(f"--{flag}")
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        self.driver = webdriver.Chrome(options=options, service=Service(driver))

    def quit(self) -> None:
        self.driver.quit()

    def open(self, path: Path, width: int = 1280, height: int = 900, **media: str) -> None:
        """Show a file.  media: features such as prefers_color_scheme="dark"."""
        self.messages(), self.requests()  # of the page before
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        features = [{"name": name.replace("_", "-"), "value": value} for name, value in media.items()]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        self.driver.get(path.as_uri())

    def js(self, code: str, *arguments: Any) -> Any:
        """What a function body in JavaScript returns."""
        return self.driver.execute_script(code, *arguments)

    def until(self, code: str, *arguments: Any) -> Any:
        """Wait until a function body in JavaScript returns something true."""
        return WebDriverWait(self.driver, WAIT, 0.02).until(lambda _: self.js(code, *arguments), code)

    def find(self, selector: str) -> WebElement:
        """An element of the page itself."""
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def act(self) -> ActionChains:
        """A chain of pointer and keyboard actions that takes no time between them."""
        return ActionChains(self.driver, duration=0)

    def messages(self) -> list[str]:
        """What was written to the console since the last call."""
        return [entry["message"] for entry in self.driver.get_log("browser")]

    def requests(self) -> list[str]:
        """The addresses that were asked for since the last call, without pictures that are data in the page."""
        events = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        sent = [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]
        return [url for url in sent if not url.startswith("data:")]

    def screenshot(self, path: Path) -> None:
        self.driver.save_screenshot(str(path))
