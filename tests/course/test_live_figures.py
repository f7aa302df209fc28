"""Live figures of lessons, on pages and in notebooks: each starts, fits, and is a still picture on paper."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from selenium.webdriver.common.keys import Keys

from glsim.course.cells import lesson
from glsim.course.notebook import LARGEST_PAGE, notebook
from glsim.course.outputs import LIVE, Output, execute
from glsim.course.site import Page, write_site
from tests.browser import Browser
from tests.course.test_site import DRIVER

pytestmark = pytest.mark.slow
LESSONS = {"lambert": 1, "blinn_torrance": 1, "gouraud": 2, "special_cases": 2}  # how many live figures each has
MOST = 600_000  # bytes of a page


@pytest.fixture(scope="module")
def pages() -> list[Page]:
    return [Page(one, execute(one)) for one in map(lesson, LESSONS)]


@pytest.fixture(scope="module")
def site(pages: list[Page], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    _, *written = write_site(tmp_path_factory.mktemp("site"), pages)
    return dict(zip(LESSONS, written, strict=True))


def scrolled_to(browser: Browser, number: int) -> None:
    """Scroll to a live figure, as soon as what asks for an answer is answered, and wait until it is drawn."""
    browser.js("document.querySelector('.predict button')?.click();"
               f"document.querySelectorAll('glsim-live')[{number}].scrollIntoView({{block: 'center'}})")  # fmt: skip
    browser.until(f"return document.querySelectorAll('glsim-live')[{number}].dataset.state === 'ready'")


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("name", LESSONS)
def test_each_figure_starts_when_it_is_near_and_fits(
    name: str, width: int, site: dict[str, Path], browser: Browser
) -> None:
    assert site[name].stat().st_size < MOST
    browser.open(site[name], width)
    assert browser.js("return document.querySelectorAll('glsim-live').length") == LESSONS[name]
    for number in range(LESSONS[name]):
        scrolled_to(browser, number)
        assert browser.js("return document.documentElement.scrollWidth") <= width
    assert [words for words in browser.messages() if not DRIVER.search(words)] == []
    assert not [url for url in browser.requests() if not url.startswith("file:")]


CONTROLS = {  # a control that the lesson speaks of, and what the copied source then says
    "lambert": ("[data-name='light.0.diffuse'] input", "#ff8000", "glLightfv(GL_LIGHT0, GL_DIFFUSE, [1, 0.502, 0, 1])"),
    "blinn_torrance": ("[data-name='material.0.front.shininess'] input", "5", "glMaterialf(GL_FRONT, GL_SHININESS, 5)"),
    "gouraud": ("[data-name='light.0.position'] input", "0.3", "glLightfv(GL_LIGHT0, GL_POSITION, [0.3, 0, 1, 1])"),
    "special_cases": ("[data-name='light.0.position'] input", "2", "glLightfv(GL_LIGHT0, GL_POSITION, [2, 0.7, 1, 0])"),
}


@pytest.mark.parametrize("name", LESSONS)
def test_a_control_changes_the_picture_and_writes_the_call(name: str, site: dict[str, Path], browser: Browser) -> None:
    selector, value, line = CONTROLS[name]
    browser.open(site[name])
    scrolled_to(browser, 0)
    if name == "gouraud":  # where the lamp is of no matter as long as no vertex is near
        browser.js("document.querySelector('glsim-live').show({mode: 'phong'})")
    if name == "special_cases":  # the inside of the bowl is dark
        browser.act().send_keys("2").perform()
    picture = "return document.querySelector('glsim-live').picture.toDataURL()"
    before = browser.js(picture)
    browser.js(
        "const input = document.querySelector('glsim-live').shadowRoot.querySelector(arguments[0]);"
        "input.value = arguments[1]; input.dispatchEvent(new Event('input'));",
        selector,
        value,
    )
    browser.until(f"return document.querySelector('glsim-live').picture.toDataURL() !== '{before}'")
    assert line in browser.js("return document.querySelector('glsim-live').source.textContent")


def test_digits_choose_the_picture(site: dict[str, Path], browser: Browser) -> None:
    browser.open(site["gouraud"])
    scrolled_to(browser, 0)
    pressed = ("return [...document.querySelector('glsim-live').shadowRoot.querySelectorAll('[aria-pressed=true]')]"
               ".map((button) => button.textContent)")  # fmt: skip
    assert browser.js(pressed) == ["cuts = 1", "gouraud"]
    browser.act().send_keys("4").perform()
    browser.until("return document.querySelector('glsim-live').look.frame === 3")
    browser.until(f"return (() => {{ {pressed} }})()[0] === 'cuts = 8'")
    browser.js("document.querySelector('glsim-live').shadowRoot.querySelector('input[type=number]').focus()")
    browser.act().send_keys("1").perform()  # a number is typed
    assert browser.js("return document.querySelector('glsim-live').look.frame") == 3


def test_a_change_stays_unless_the_next_picture_sets_the_value_itself(site: dict[str, Path], browser: Browser) -> None:
    browser.open(site["gouraud"])
    position = """const live = document.querySelectorAll('glsim-live')[arguments[0]];
      live.set('light.0.position', [0.3, 0, 1, 1]);
      live.choose(2);
      return live.scene.value('light.0.position');"""
    assert browser.js(position, 0) == [0.3, 0, 1, 1]  # cut finer, under the same lamp
    assert browser.js(position, 1) == pytest.approx([0.075, 0, 1, 1])  # the picture of another lamp


def test_paper_and_readers_without_javascript_get_the_still_picture(site: dict[str, Path], browser: Browser) -> None:
    browser.open(site["gouraud"])
    scrolled_to(browser, 0)
    seen = ("const live = document.querySelector('glsim-live'), image = live.querySelector('img');"
            "return [image.offsetHeight > 0, live.stage.offsetHeight > 0, image.naturalWidth]")  # fmt: skip
    still, stage, width = browser.js(seen)
    assert (still, stage) == (False, True)
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        browser.until(f"return String((() => {{ {seen} }})()) === 'true,false,{width}'")
    finally:
        browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})
    assert width > 5 * 230  # the whole sheet: five columns


def test_a_live_figure_is_shown_on_a_slide(site: dict[str, Path], browser: Browser) -> None:
    browser.open(site["lambert"])
    browser.find("button.slides").click()
    browser.act().send_keys(Keys.END).perform()
    for _ in range(20):
        if browser.js("return Boolean(document.querySelector('.current glsim-live'))"):
            break
        browser.act().send_keys(Keys.ARROW_LEFT).perform()
    browser.until("return document.querySelector('.current glsim-live').dataset.state === 'ready'")
    bottom = browser.js("return document.querySelector('.current glsim-live').stage.getBoundingClientRect().bottom")
    assert bottom <= 900
    browser.js("document.querySelector('.current glsim-live').stage.focus()")
    browser.act().send_keys(Keys.ARROW_LEFT).perform()  # turns the camera, not the page
    assert browser.js("return document.querySelector('.current glsim-live').scene.orbit.yaw") != 0


def test_notebooks_have_the_figure_in_a_frame_and_the_still_picture(pages: list[Page]) -> None:
    cells = json.loads(notebook(pages[0].lesson, pages[0].outputs))["cells"]
    data = [out["data"] for cell in cells for out in cell.get("outputs", []) if "data" in out]
    found = [one for one in data if "&lt;glsim-live&gt;" in one.get("text/html", "")]
    assert len(found) == LESSONS["lambert"]
    assert found[0]["text/html"].startswith("<iframe ")
    assert "image/png" in found[0]
    assert LIVE not in found[0]


def test_notebooks_leave_out_what_is_too_large() -> None:
    one = lesson("lambert")
    page = "x" * (LARGEST_PAGE + 1)
    large = Output(shown={LIVE: "<glsim-live>", "text/html": page, "image/png": "aaaa", "text/plain": "."})
    cells = json.loads(notebook(one, [large] * len(one.cells)))["cells"]
    data = next(out["data"] for cell in cells for out in cell.get("outputs", []))
    assert sorted(data) == ["image/png", "text/plain"]
