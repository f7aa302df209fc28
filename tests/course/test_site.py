"""The exported site: links, formulas and alt texts of all lessons; and in a real browser."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from glsim.course.cells import lesson, lessons
from glsim.course.outputs import Output
from glsim.course.site import Page, write_site
from tests.browser import Browser
from tests.course.executed import outputs_of

DRIVER = re.compile("software WebGL|ReadPixels")  # what Chromium itself says of WebGL without a GPU
DRAWN = ("lambert", "direct_and_radiosity", "linear_system")  # lessons whose figures are drawn here, of each kind


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """All lessons as pages; the figures only of some."""
    drawn = {lesson(name).name for name in DRAWN}
    pages = [
        Page(one, outputs_of(one.name) if one.name in drawn else [Output()] * len(one.cells))
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
        assert [words for words in browser.messages() if not DRIVER.search(words)] == [], path.name
        assert not [url for url in browser.requests() if not url.startswith("file:")], path.name


class Folded(HTMLParser):
    """The words and the pictures of a page that are seen while all <details> are closed."""

    def __init__(self, page: Path) -> None:
        super().__init__()
        self.depth = 0
        self.words, self.pictures = "", [""]
        self.feed(page.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.depth += tag == "details"
        if tag == "img" and not self.depth:
            self.pictures.append(dict(attributes)["src"] or "")

    def handle_endtag(self, tag: str) -> None:
        self.depth -= tag == "details"

    def handle_data(self, data: str) -> None:
        self.words += "" if self.depth else data


@pytest.mark.slow
def test_no_page_tells_an_answer_before_it_is_asked_for(tmp_path: Path) -> None:
    """Neither the page nor the table of contents, without any script: the figure, its words, answers to questions."""
    picture, course = Output(shown={"image/png": ""}), lessons()
    write_site(tmp_path, [Page(one, [picture if c.kind == "code" else Output() for c in one.cells]) for one in course])
    index = Folded(tmp_path / "index.html")
    for one in course:
        (question,) = [k for k, cell in enumerate(one.cells) if cell.source.startswith("## Predict")]
        awaited = f"figures/{one.name}-{question + 1}.png"
        page = Folded(tmp_path / f"{one.name}.html")
        assert awaited in (tmp_path / f"{one.name}.html").read_text("utf-8")
        assert awaited not in page.pictures
        assert awaited not in index.pictures
        answer = "\n".join(cell.source for cell in one.cells).partition("## What you should see\n\n")[2]
        words = max(re.split(r"\$.*?\$|[*`\n]", answer.split("\n\n")[0], flags=re.DOTALL), key=len)
        assert len(words) > 20
        assert words not in page.words, "what you should see is read before the question is answered"


@pytest.mark.slow
def test_a_prediction_hides_its_figure_until_it_is_answered(site: Path, browser: Browser) -> None:
    browser.open(site / f"{lesson('lambert').name}.html")
    seen = "return [...document.querySelectorAll('.answer > :not(summary)')].map((e) => e.checkVisibility())"
    assert browser.js(seen) == [False] * 2
    browser.find(".code > .answer > summary").click()
    assert browser.js(seen) == [False] * 2, "it asks for an answer first"
    browser.find(".predict li:nth-child(2) button").click()
    assert browser.js(seen) == [True] * 2
    assert browser.js("return document.querySelectorAll('.predict [aria-pressed=true]').length") == 1


@pytest.mark.slow
def test_paper_shows_all_answers_without_a_script(site: Path, browser: Browser) -> None:
    seen = (
        "return [...document.querySelectorAll('main details > :not(summary)')].map((e) => e.checkVisibility("
        "{contentVisibilityAuto: true}) && e.offsetHeight > 0)"
    )
    browser.open(site / f"{lesson('lambert').name}.html")
    assert not any(browser.js(seen))
    browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    try:
        assert len(browser.js(seen)) == 3
        assert all(browser.js(seen))
    finally:
        browser.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


@pytest.mark.slow
def test_a_card_shows_its_whole_picture(site: Path, browser: Browser) -> None:
    browser.open(site / "index.html")
    fits = browser.js("return [...document.querySelectorAll('.cards img')].map((i) => getComputedStyle(i).objectFit)")
    assert set(fits) == {"contain"}


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
    browser.js("document.querySelectorAll('.predict button')[0].click()")
    browser.js("document.querySelector('figure.picture img').click()")
    assert browser.js("return document.querySelector('dialog.zoom').open") is True
    browser.js("document.querySelector('dialog.zoom').click()")
    assert browser.js("return document.querySelector('dialog.zoom').open") is False
