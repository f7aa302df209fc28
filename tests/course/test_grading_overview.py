"""The page for the teacher: all marks, distributions, pictures; harmless whatever is in a name; sorted and filtered."""

from __future__ import annotations

import base64
import io
from html.parser import HTMLParser
from pathlib import Path

import pytest
from PIL import Image

from glsim.course.grading import overview
from glsim.course.grading.record import Part, Record, Total, totals
from tests.browser import Browser

EVIL = "<script>document.title = 'evil'</script>\"'&amp;$css🦊"


def png() -> str:
    buffer = io.BytesIO()
    Image.new("RGB", (300, 100), "red").save(buffer, "PNG")
    return base64.b64encode(buffer.getvalue()).decode()


def record(student: str, slug: str, exercise: str, points: int, hint: str = "", **fields: str) -> Record:
    parts = (Part("first", points, 3, hint, png() if hint else ""), Part("second", 1, 1))
    return Record(student, slug, exercise, "Lambert's law", parts, "x.py", isolation="bubblewrap", **fields)


def graded() -> list[Total]:
    return totals(
        [
            record("student 10", "a", "03_lambert", 3),
            record("student 10", "a", "05_snell", 3),
            record("student 9", "b", "03_lambert", 1, "the light comes from behind"),
            record("student 9", "b", "05_snell", 3),
            record(EVIL, "c", "03_lambert", 0, EVIL, printed=EVIL, note=EVIL),
            record(EVIL, "c", "05_snell", 0, failure=EVIL),
        ]
    )


class Page(HTMLParser):
    """Start tags with their attributes, and all text."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += data


def test_everything_is_on_the_page_and_nothing_is_executed() -> None:
    page = Page(overview.overview(graded()))
    names = [tag for tag, _ in page.tags]
    assert names.count("script") == 1
    assert page.text.count(EVIL) >= 4
    assert not [a for _, attributes in page.tags for a in attributes if a.startswith("on")]
    assert all((attributes.get("src") or "data:").startswith("data:") for _, attributes in page.tags)
    assert names.count("img") == 4, "a thumbnail and a picture for each of two"
    labels = [attributes["aria-label"] for tag, attributes in page.tags if tag == "ol"]
    counts = [[int(bar.rpartition(": ")[2]) for bar in str(label).split(", ")] for label in labels]
    assert counts == [[0, 0, 0, 0, 0, 0, 1, 0, 1], [0, 1, 1, 0, 1], [0, 0, 0, 0, 2]]
    assert str(labels[1]).startswith("0 points: 0, 1 points: 1, ")
    assert "3 submissions; mean 7.0 of 8 points; isolation: bubblewrap" in page.text
    assert "1 could not be graded and have no mark." in page.text
    assert "1 of 3" in page.text, "who has the first part right"


def test_many_points_share_bars() -> None:
    one = Record("s", "s", "03_lambert", "t", (Part("p", 50, 100),), "x.py")
    labels = [a["aria-label"] for tag, a in Page(overview.overview(totals([one]))).tags if tag == "ol"]
    assert labels[0] is not None
    assert "48-55 points: 1" in labels[0]
    assert labels[0].endswith("96-100 points: 0")


@pytest.mark.slow
def test_rows_are_sorted_and_filtered(browser: Browser, tmp_path: Path) -> None:
    browser.open(overview.write(tmp_path, graded()))
    names = "return [...document.querySelectorAll('tbody tr:not([hidden]) summary b')].map(s => s.textContent)"
    press = "[...document.querySelectorAll('thead button')].find(b => b.textContent === arguments[0]).click()"
    browser.js(press, "submission")
    assert browser.js(names) == [EVIL, "student 9", "student 10"]
    browser.js(press, "points")
    assert browser.js(names) == [EVIL, "student 9", "student 10"]
    browser.js(press, "points")
    assert browser.js(names) == ["student 10", "student 9", EVIL]
    browser.find("input").send_keys("From Behind")
    assert browser.js(names) == ["student 9"]
    assert browser.find("output").text == "1 of 3"
    browser.find("input").clear()
    browser.find("input").send_keys(" ")
    browser.find("select").send_keys("not graded")
    assert browser.js(names) == [EVIL]
    assert browser.driver.title == "Marks"
    assert browser.messages() == []
    browser.open(tmp_path / "overview.html", width=390)
    assert browser.js("return document.documentElement.scrollWidth") == 390
    assert len(browser.requests()) == 1
