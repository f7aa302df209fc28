"""<glsim-compare> in real Chromium, driven by keys, mouse and fingers."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.remote.webelement import WebElement

from glsim.web.page import Picture, Strip, element, page
from tests.browser import Browser

pytestmark = pytest.mark.slow

WIDTH, HEIGHT = 48, 32
RNG = np.random.default_rng(7)
FLAT = RNG.integers(0, 256, (HEIGHT, WIDTH, 3), np.uint8)
GOURAUD = np.clip(FLAT.astype(int) + RNG.integers(-9, 10, FLAT.shape), 0, 255).astype(np.uint8)
PHONG = RNG.integers(0, 256, (HEIGHT, WIDTH, 4), np.uint8)  # every alpha, and colours where alpha is 0
PHONG[20, 30] = 200, 100, 50, 0
EVIL = "</script><script>throw 1</script><img src=x onerror='throw 2'>"
EQUATIONS = {(x, y): f"I({x}, {y}) = k_d (N·L)" for x in range(4, 20, 8) for y in range(4, 20, 8)}
PICTURES = [
    Picture("Flat", FLAT, EVIL),
    Picture("Gouraud", GOURAUD, "once per vertex", EQUATIONS),
    Picture("Phong", PHONG),
]
STRIPS = [
    Strip(EVIL, PICTURES, notes=[EVIL]),
    Strip("sizes", [Picture("expected", FLAT), Picture("actual", FLAT[:20])], status="failed"),
]
VIEWERS = "const viewers = [...document.querySelectorAll('glsim-compare')].map((element) => element.viewer);"


class Page:
    """A page in the browser; ``strip`` is which of its strips is meant."""

    def __init__(self, browser: Browser, path: Path, strip: int) -> None:
        self.browser, self.path, self.strip = browser, path, strip

    def open(self, width: int = 1280, height: int = 900, **media: str) -> Page:
        self.browser.open(self.path, width, height, **media)
        self.browser.until(f"{VIEWERS} return viewers.length && viewers.every((viewer) => viewer?.pixels.length)")
        self.browser.js(f"{VIEWERS} viewers[{self.strip}].host.scrollIntoView({{block: 'center'}})")
        self.browser.until("const now = scrollY, old = window.old; window.old = now; return now === old")
        return self

    def js(self, code: str) -> object:
        return self.browser.js(f"{VIEWERS} const viewer = viewers[{self.strip}]; {code}")

    def part(self, selector: str) -> WebElement:
        found = self.js(f"return viewer.$({selector!r})")
        assert isinstance(found, WebElement), selector
        return found

    def press(self, *keys: str, part: str = ".stage") -> None:
        self.js(f"viewer.$({part!r}).focus({{preventScroll: true}})")
        self.browser.act().send_keys(*keys).perform()

    def press_with_shift(self, *keys: str) -> None:
        self.browser.act().key_down(Keys.SHIFT).send_keys(*keys).key_up(Keys.SHIFT).perform()

    def place(self) -> tuple[float, float, float]:
        """Where the picture lies on the canvas: left, top, scale."""
        place = self.js("return viewer.stage.place(viewer.stage.panels[0].box)")
        assert isinstance(place, dict)
        return place["left"], place["top"], place["scale"]

    def offset(self, x: float, y: float) -> tuple[int, int]:
        """The middle of a pixel, from the middle of the canvas, as ActionChains counts."""
        left, top, scale = self.place()
        size = self.js("const {clientWidth, clientHeight} = viewer.$('canvas'); return [clientWidth, clientHeight]")
        assert isinstance(size, list)
        return round(left + (x + 0.5) * scale - size[0] // 2), round(top + (y + 0.5) * scale - size[1] // 2)

    def point_at(self, x: float, y: float, click: bool = False) -> None:
        action = self.browser.act().move_to_element_with_offset(self.part(".stage"), *self.offset(x, y))
        (action.click() if click else action).perform()

    def drawn(self) -> NDArray[np.uint8]:
        """The picture as the canvas shows it, one colour for each of its pixels: (height, width, 3)."""
        left, top, scale = self.place()
        rows = self.js(f"""const canvas = viewer.$('canvas'), {{width, height}} = canvas, values = [];
            const copy = new OffscreenCanvas(width, height).getContext('2d', {{willReadFrequently: true}});
            copy.drawImage(canvas, 0, 0);
            const {{data}} = copy.getImageData(0, 0, width, height);
            for (let y = 0; y < {HEIGHT}; y++) for (let x = 0; x < {WIDTH}; x++) {{
              const column = Math.floor({left} + (x + 0.5) * {scale}), row = Math.floor({top} + (y + 0.5) * {scale});
              values.push(...data.subarray(4 * (row * width + column), 4 * (row * width + column) + 4));
            }}
            return values""")
        return np.array(rows, np.uint8).reshape(HEIGHT, WIDTH, 4)[..., :3]

    def values(self) -> dict[str, list[str]]:
        """What is read off the pixel: a row's name and its cells."""
        rows = self.js("return [...viewer.$('.values').rows].map((row) => [...row.cells].map((c) => c.textContent))")
        assert isinstance(rows, list)
        return {name: cells for name, *cells in rows}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("pages")
    (folder / "page.html").write_text(page("Shading", STRIPS, EVIL), "utf-8")
    cells = "<hr>".join(element(strip) for strip in STRIPS)
    (folder / "cells.html").write_text(f"<!doctype html><meta charset=utf-8><body>{cells}", "utf-8")
    return folder


@pytest.fixture
def shown(browser: Browser, folder: Path) -> Iterator[Page]:
    """A fresh page, at its strip of three pictures; whatever a test does, nothing is said and nothing is asked for."""
    yield Page(browser, folder / "page.html", strip=1).open()
    assert browser.messages() == []
    assert browser.requests() == [(folder / "page.html").as_uri()]


def test_keys_swap_pictures_in_place(shown: Page) -> None:
    assert np.array_equal(shown.drawn(), FLAT)
    before = shown.place()
    assert before[2] >= 2
    assert before[2] == int(before[2])
    shown.press("2")
    assert np.array_equal(shown.drawn(), GOURAUD)
    assert shown.place() == before
    shown.press("++", Keys.ARROW_RIGHT, Keys.ARROW_DOWN)
    zoomed = shown.place()
    assert zoomed[2] > before[2]
    where = shown.js("return viewer.$('canvas').getBoundingClientRect().toJSON()")
    for key, current in (("1", 0), ("3", 2), (" ", 0), ("9", 0)):
        shown.press(key)
        assert shown.js("return viewer.current") == current
        assert shown.place() == zoomed
        assert shown.js("return viewer.$('canvas').getBoundingClientRect().toJSON()") == where
    assert shown.js("return viewer.$('.pictures input:checked').value") == "0"


def test_keys_work_when_nothing_has_the_focus(shown: Page) -> None:
    shown.browser.js("document.activeElement.blur()")
    shown.browser.act().move_to_element(shown.part(".stage")).perform()
    shown.browser.act().send_keys("2").perform()
    assert shown.js("return viewers.map((viewer) => viewer.current)") == [0, 1]


def test_the_choices_are_reached_by_keyboard_and_show_the_focus(shown: Page) -> None:
    shown.press(Keys.ARROW_RIGHT, part=".pictures input")
    assert shown.js("return viewer.current") == 1
    assert shown.js("return getComputedStyle(viewer.$('.pictures input:focus-visible + span')).outlineStyle") == "solid"
    seen = set()
    for _ in range(12):
        shown.browser.act().send_keys(Keys.TAB).perform()
        seen.add(shown.js("const e = viewer.root.activeElement; return e && (e.dataset.zoom || e.name || e.className)"))
    assert {"views", "in", "out", "fit", "full", "stage"} <= seen


@pytest.mark.parametrize("pointer", ["mouse", "touch", "keys"])
def test_swipe(shown: Page, pointer: str) -> None:
    shown.press("2s")
    left, _, scale = shown.place()
    shown.browser.until(f"{VIEWERS} return viewers[1].$('.divider').offsetWidth")
    box = shown.js("return viewer.$('.divider').getBoundingClientRect().toJSON()")
    assert isinstance(box, dict)
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    move = round(8 * scale)
    if pointer == "mouse":
        shown.browser.act().click_and_hold(shown.part(".divider")).move_by_offset(move, 0).release().perform()
    elif pointer == "touch":
        for kind, points in (("Start", [x]), ("Move", [x + move // 2]), ("Move", [x + move]), ("End", [])):
            touches = [{"x": place, "y": y} for place in points]
            touch = {"type": f"touch{kind}", "touchPoints": touches}
            shown.browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", touch)
    else:
        shown.press(*[Keys.ARROW_RIGHT] * 6, "...", part=".divider")
    divider = shown.js("return viewer.divider")
    width = shown.js("return viewer.$('canvas').clientWidth")
    assert isinstance(divider, float)
    assert isinstance(width, int)
    expected = 0.5 + 9 * 0.02 if pointer == "keys" else 0.5 + move / width
    assert divider == pytest.approx(expected, abs=1.5 / width)
    split = (divider * width - left) / scale
    at = np.arange(WIDTH) + 0.5
    drawn, sure = shown.drawn()[8:-8], abs(at - split) > 0.6  # away from the labels
    both = np.where((at < split)[None, :, None], FLAT, GOURAUD)[8:-8]
    assert 0 < split < WIDTH
    assert np.array_equal(drawn[:, sure], both[:, sure])


def test_differences_are_amplified(shown: Page) -> None:
    shown.press("d")
    assert shown.js("return [viewer.current, viewer.gain]") == [1, 8]
    difference = np.abs(GOURAUD.astype(int) - FLAT)
    assert np.array_equal(shown.drawn(), np.minimum(8 * difference, 255))
    shown.press(".")
    assert np.array_equal(shown.drawn(), np.minimum(16 * difference, 255))
    shown.press(*",,,,,,,")
    assert np.array_equal(shown.drawn(), difference)
    shown.press("3")
    alpha = 255 - PHONG[..., 3:].astype(int)
    assert np.array_equal(shown.drawn(), np.maximum(np.abs(PHONG[..., :3].astype(int) - FLAT), alpha))


def test_zoom_keeps_the_pixel_under_the_pointer_and_all_strips_in_step(shown: Page) -> None:
    fit = shown.place()
    shown.browser.js("scrolled = 0")
    shown.browser.until("return performance.now() > 1000")  # after the page's own scrolling
    stage, (x, y) = shown.part(".stage"), shown.offset(40, 8)
    from selenium.webdriver.common.actions.wheel_input import ScrollOrigin

    shown.point_at(40, 8)
    origin = ScrollOrigin.from_element(stage, x, y)
    shown.browser.act().scroll_from_origin(origin, 0, -400).perform()
    shown.browser.until(f"{VIEWERS} return viewers[1].stage.place(viewers[1].stage.panels[0].box).scale > {fit[2]}")
    assert shown.values().keys() >= {"(40, 8)"}
    assert shown.offset(40, 8) == pytest.approx((x, y), abs=shown.place()[2] / 2 + 1)
    scales = shown.js("return viewers.map(({stage}) => stage.place(stage.panels[0].box).scale)")
    assert scales == [shown.place()[2]] * 2
    left, top, scale = shown.place()
    shown.browser.act().drag_and_drop_by_offset(stage, -30, 20).perform()
    assert shown.place() == (left - 30, top + 20, scale)
    shown.press("0")
    assert shown.place()[2] == 1
    shown.press("f")
    assert shown.place() == fit


def test_two_fingers_zoom(shown: Page) -> None:
    box = shown.js("return viewer.$('.stage').getBoundingClientRect().toJSON()")
    assert isinstance(box, dict)
    x, y, before = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, shown.place()[2]
    for kind, spread in (("Start", 40), ("Move", 60), ("Move", 80), ("End", 0)):
        points = [{"x": x - spread, "y": y, "id": 0}, {"x": x + spread, "y": y, "id": 1}] if spread else []
        touch = {"type": f"touch{kind}", "touchPoints": points}
        shown.browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", touch)
    assert shown.place()[2] == pytest.approx(2 * before, rel=0.05)


@pytest.mark.parametrize(("x", "y"), [(0, 0), (17, 5), (47, 31), (30, 20)])
def test_values_are_the_arrays(shown: Page, x: int, y: int) -> None:
    shown.press("3")
    shown.point_at(x, y)
    flat, phong = [*FLAT[y, x].tolist(), 255], PHONG[y, x].tolist()
    signed = [f"{d:+d}".replace("-", "−") if (d := b - a) else "0" for a, b in zip(flat, phong, strict=True)]
    found = shown.values()
    assert found[f"({x}, {y})"] == [*"RGBA"]
    assert found["Flat"] == [str(value) for value in flat]
    assert found["Phong"] == [str(value) for value in phong]
    assert found["Difference"] == signed


def test_a_click_shows_the_nearest_equation(shown: Page) -> None:
    shown.press("2")
    shown.point_at(10, 5, click=True)
    assert shown.part(".equation pre").text == EQUATIONS[12, 4].replace("k_d", "kd"), "with an index"
    assert "k<sub>d</sub>" in shown.part(".equation pre").get_attribute("innerHTML")
    assert shown.part(".equation h4").text == "Gouraud at (12, 4)"
    assert shown.js("return [viewer.marks.mark, viewer.marks.point]") == [{"x": 10, "y": 5}, {"x": 12, "y": 4}]
    shown.press_with_shift(Keys.ARROW_LEFT * 3, Keys.ARROW_DOWN * 4)
    assert shown.js("return viewer.marks.mark") == {"x": 7, "y": 9}
    assert shown.part(".equation pre").text == EQUATIONS[4, 12].replace("k_d", "kd")
    shown.point_at(45, 30, click=True)
    assert shown.part(".equation pre").text == "There is no equation near this pixel."


def test_pictures_of_other_sizes_have_no_difference(shown: Page) -> None:
    shown.strip = 0
    shown.press("d")
    assert shown.part(".message").text == "The sizes differ: 48 × 32 and 48 × 20."
    shown.press("p")
    assert shown.js("return viewer.$('.message').textContent") == ""
    assert np.array_equal(shown.drawn()[:20], FLAT[:20])
    assert shown.part(".status").text == "FAILED"


def test_all_side_by_side(shown: Page) -> None:
    shown.press("a")
    boxes = shown.js("return viewer.stage.panels.map(({box, label}) => [label, box.x, box.y, box.width, box.height])")
    assert isinstance(boxes, list)
    assert [label for label, *_ in boxes] == ["Flat", "Gouraud", "Phong"]
    assert len({(x, y) for _, x, y, *_ in boxes}) == 3
    assert len({(width, height) for *_, width, height in boxes}) == 1
    assert np.array_equal(shown.drawn(), FLAT)
    shown.point_at(12, 7)
    assert set(shown.values()) == {"(12, 7)", "Flat", "Gouraud", "Phong"}


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_telephone_is_wide_enough(browser: Browser, folder: Path, scheme: str) -> None:
    shown = Page(browser, folder / "page.html", strip=1).open(390, 844, prefers_color_scheme=scheme)
    shown.press("2d")
    shown.point_at(10, 5, click=True)
    assert browser.js("return document.documentElement.scrollWidth") <= 390
    inside = "return [...viewer.root.querySelectorAll('.ui > *, .bar > *, .columns > *')]"
    assert max(shown.js(f"{inside}.map((part) => part.getBoundingClientRect().right)") or [0]) <= 390  # type: ignore[call-overload]
    paper = browser.js("return getComputedStyle(document.body).backgroundColor")
    assert (int(paper[4:].split(",")[0]) > 128) == (scheme == "light")


def test_elements_on_one_page_do_not_clash(browser: Browser, folder: Path) -> None:
    """As in a notebook: each brings the script, and the second is there after the element was defined."""
    shown = Page(browser, folder / "cells.html", strip=0).open()
    shown.press("2")
    assert shown.js("return viewers.map((viewer) => viewer.current)") == [1, 0]
    shown.press("+")
    assert shown.js("return new Set(viewers.map(({stage}) => stage.place(stage.panels[0].box).scale)).size") == 1
    late = "const box = document.createElement('div'); box.innerHTML = viewer.host.outerHTML.replace(/display/g, '$&');"
    assert shown.js(f"{late} return box.querySelectorAll('glsim-compare').length") == 1
    assert browser.messages() == []


def test_far_strips_hold_no_pixels(browser: Browser, tmp_path: Path) -> None:
    strips = [Strip(f"s{k}", [Picture("a", FLAT), Picture("b", GOURAUD)], metrics=[{}, {}]) for k in range(60)]
    (tmp_path / "many.html").write_text(page("Many", strips), "utf-8")
    browser.open(tmp_path / "many.html")
    awake = f"{VIEWERS} return viewers.flatMap((viewer, index) => (viewer?.pixels.length ? [index] : []))"
    assert 0 in browser.until(awake)
    assert len(browser.js(awake)) < 8
    browser.find('a[href="#strip-55"]').click()
    browser.until(f"{awake}.includes(54)")
    assert 0 not in browser.js(awake)
    assert len(browser.js(awake)) < 8
    assert browser.messages() == []
