"""The exported site: links, formulas and alt texts of all lessons; and in a real browser."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from glsim.course.cells import lesson, lessons
from glsim.course.outputs import Output, execute
from glsim.course.site import Page, write_site
from tests.browser import Browser

DRAWN = ("lambert", "direct_and_radiosity", "linear_system")  # lessons whose figures are drawn here, of each kind


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All lessons as pages; the figures only of some."""
    drawn = {lesson(name).name for name in DRAWN}
    pages = [
        Page(one, execute(one) if one.name in drawn else [Output()] * len(one.cells))
        for one in lessons()
    ]  # fmt: skip
    folder = tmp_path_factory.mktemp("site")
    write_site(folder, pages)
    return folder


class Links(HTMLParser):
    """The addresses that a page names, and pictures without words for those who do not see them."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []
        self.mute: list[str] = []
        self.maths = 0

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        named = dict(attributes)
        self.found += [value for name in ("href", "src") if (value := named.get(name))]
        self.maths += tag == "math"
        if tag == "img" and "alt" not in named:
            self.mute.append(str(named))


@pytest.mark.slow
def test_links_alt_texts_and_formulas(site: Path) -> None:
    for path in sorted(site.glob("*.html")):
        text = path.read_text(encoding="utf-8")
        links = Links()
        links.feed(text)
        for address in links.found:
            assert address.startswith(("data:", "#")) or (site / address).is_file(), f"{path.name}: {address}"
        assert not links.mute, path.name
        assert "$$" not in re.sub(r"<pre.*?</pre>|<code.*?</code>|<script.*?</script>", "", text, flags=re.DOTALL)
        assert links.maths > 0 or path.name == "index.html", f"{path.name} has no formula"
    assert (site / "assets" / "STIXTwoMath.woff2").stat().st_size < 120_000


@pytest.mark.slow
@pytest.mark.parametrize("width", [1280, 390])
def test_pages_fit_and_ask_nobody(site: Path, browser: Browser, width: int) -> None:
    for path in sorted(site.glob("*.html")):
        browser.open(path, width)
        wide = browser.js("return document.documentElement.scrollWidth")
        assert wide <= width, f"{path.name} is {wide} pixels wide on a screen of {width}"
        undecoded = browser.js(
            "document.querySelectorAll('img').forEach((i) => (i.loading = 'eager'));"
            "return Promise.all([...document.images].map((i) => i.decode().then(() => null, () => i.src)))"
            ".then((all) => all.filter((source) => source))"
        )
        assert undecoded == [], path.name
        assert browser.messages() == [], path.name
        assert not [url for url in browser.requests() if not url.startswith("file:")], path.name


@pytest.mark.slow
def test_a_prediction_hides_its_figure_until_it_is_answered(site: Path, browser: Browser) -> None:
    browser.open(site / f"{lesson('lambert').name}.html")
    seen = "return document.querySelector('.result.awaiting figure').offsetHeight > 0"
    assert browser.js(seen) is False
    browser.find(".predict li:nth-child(2) button").click()
    assert browser.js(seen) is True
    assert browser.js("return document.querySelectorAll('.predict [aria-pressed=true]').length") == 1


@pytest.mark.slow
def test_slides_show_one_cell_a_screen(site: Path, browser: Browser) -> None:
    from selenium.webdriver.common.keys import Keys

    browser.open(site / f"{lesson('lambert').name}.html")
    browser.find("button.slides").click()
    shown = "return [...document.querySelectorAll('.cell')].filter((c) => c.offsetHeight > 0).map((c) => c.innerText)"
    first = browser.js(shown)
    assert len(first) == 1
    browser.act().send_keys(Keys.ARROW_RIGHT).perform()
    second = browser.js(shown)
    assert len(second) == 1
    assert second != first
    browser.act().send_keys(Keys.ARROW_LEFT).perform()
    assert browser.js(shown) == first
    browser.act().send_keys(Keys.ESCAPE).perform()
    assert len(browser.js(shown)) > 3


@pytest.mark.slow
def test_a_figure_is_enlarged(site: Path, browser: Browser) -> None:
    browser.open(site / f"{lesson('linear_system').name}.html")
    browser.js("document.querySelectorAll('.reveal').forEach((b) => b.click());"
               "document.querySelectorAll('.predict button')[0].click()")  # fmt: skip
    browser.js("document.querySelector('figure.picture img').click()")
    assert browser.js("return document.querySelector('dialog.zoom').open") is True
    browser.js("document.querySelector('dialog.zoom').click()")
    assert browser.js("return document.querySelector('dialog.zoom').open") is False
