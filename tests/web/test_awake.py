"""Pages with more live pictures than a browser gives contexts: only those near the screen hold one."""

from __future__ import annotations

from pathlib import Path

import pytest

from glsim.study.export import live
from glsim.web.live import code, element
from tests.browser import Browser

pytestmark = pytest.mark.slow
COUNT, MOST = 24, 8
STATES = "return [...document.querySelectorAll('glsim-live')].map((live) => live.dataset.state)"
READY = "return document.querySelectorAll('glsim-live')[{}].dataset.state === 'ready'"
SEEN = "return document.querySelectorAll('glsim-live')[0].picture.toDataURL()"
CONTEXTS = """window.given = new Set();
const get = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, ...options) {
  const context = get.call(this, kind, ...options);
  if (kind === 'webgl2') given.add(context);
  return context;
};"""
HELD = "return [...given].filter((context) => !context.isContextLost()).length"


def opened(browser: Browser, path: Path, count: int, apart: int, height: int) -> None:
    """Small live pictures, so many pixels apart, on a screen of this height."""
    one = element(live("sphere:8", size=48, controls="camera"), script=False)
    pictures = f"<p style='height: {apart}px'></p>".join([one] * count)
    path.write_text(f"<!doctype html><script>{CONTEXTS}</script>{pictures}{code()}", encoding="utf-8")
    browser.open(path, 400, height)
    browser.until(READY.format(0))


@pytest.fixture(params=[20, 400])
def page(request: pytest.FixtureRequest, browser: Browser, tmp_path: Path) -> Browser:
    opened(browser, tmp_path / "page.html", COUNT, request.param, 500)
    return browser


def test_only_pictures_near_the_screen_hold_a_context(page: Browser) -> None:
    first = page.js(SEEN)
    for number in (*range(0, COUNT, 2), COUNT - 1):
        page.js(f"document.querySelectorAll('glsim-live')[{number}].scrollIntoView({{block: 'center'}})")
        page.until(READY.format(number))
        assert page.js(HELD) <= MOST
    assert page.js(STATES)[0] == "asleep"
    assert page.js(SEEN) == first  # a copy of the picture stays
    page.js("scrollTo(0, 0)")
    page.until(READY.format(0))
    assert page.js(SEEN) == first
    assert page.js(HELD) <= MOST


def test_what_was_changed_stays_while_a_picture_sleeps(page: Browser) -> None:
    before = page.js(SEEN)
    page.js("document.querySelector('glsim-live').orbit({yaw: 40})")
    page.until(f"return document.querySelector('glsim-live').picture.toDataURL() !== '{before}'")
    turned = page.js(SEEN)
    page.js("scrollTo(0, document.body.scrollHeight)")
    page.until("return document.querySelector('glsim-live').dataset.state === 'asleep'")
    page.js("scrollTo(0, 0)")
    page.until(READY.format(0))
    assert page.js(SEEN) == turned != before


def test_what_never_came_near_was_never_started(page: Browser) -> None:
    assert page.js(STATES)[-1] is None
    assert page.js("return document.querySelectorAll('glsim-live')[23].tape") is None


def test_of_many_that_are_near_those_on_the_screen_are_shown(browser: Browser, tmp_path: Path) -> None:
    """When the page is scrolled, none comes near or goes far: all are near all the time."""
    opened(browser, tmp_path / "page.html", 12, 20, 800)
    bottom = browser.js("return document.querySelectorAll('glsim-live')[11].getBoundingClientRect().bottom")
    assert 800 < bottom < 1600
    browser.js("scrollTo(0, document.body.scrollHeight)")
    for number in (10, 11):
        browser.until(READY.format(number))
    assert browser.js(HELD) <= MOST
