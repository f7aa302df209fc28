"""The HTML of a page: order, contents, escaping, what is refused."""

from __future__ import annotations

import base64
import io
import json
import re
from html.parser import HTMLParser

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from glsim.metrics import metrics
from glsim.web import page as web
from glsim.web.page import Picture, Strip, element, page

EVIL = "</script><script>throw 1</script><!-- <b>'\"&"


def noise(height: int = 6, width: int = 9, channels: int = 3, seed: int = 0) -> NDArray[np.uint8]:
    return np.random.default_rng(seed).integers(0, 256, (height, width, channels), np.uint8)


def strip(title: str = "strip", status: str = "") -> Strip:
    return Strip(title, [Picture("a", noise()), Picture("b", noise(seed=1))], status=status)


class Tags(HTMLParser):
    """Start tags and the texts of script elements, as a browser would see them."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.scripts: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        if self.tags and self.tags[-1][0] == "script" and data.strip():
            self.scripts.append(data)


def test_failed_strips_come_first_and_keep_their_order() -> None:
    text = page("Run", [strip("p1", "passed"), strip("f1", "failed"), strip("p2", "passed"), strip("f2", "failed")])
    assert re.findall(r"<h2>(\w+)", text) == ["f1", "f2", "p1", "p2"]
    assert "2 failed, 2 passed" in text
    assert "<nav" not in text


def test_many_strips_have_contents() -> None:
    strips = [strip(f"s{k}", "failed" if k == 5 else "passed") for k in range(7)]
    text = page("Run", strips)
    assert re.findall(r'<a href="#(strip-\d+)">(s\d)', text)[:2] == [("strip-1", "s5"), ("strip-2", "s0")]
    assert [f'<section id="strip-{k}">' in text for k in (1, 7, 8)] == [True, True, False]
    assert re.findall(r"<summary>(\w+) <span>(\d)", text) == [("Failed", "1"), ("Passed", "6")]


def test_untrusted_words_are_only_words() -> None:
    picture = Picture(EVIL, noise(), EVIL, {(1, 2): EVIL})
    text = page(EVIL, [Strip(EVIL, [picture, picture], status=EVIL, notes=[EVIL], metrics=[None, {EVIL: 1.0}])], EVIL)
    tags = Tags(text)
    assert len(tags.scripts) == 2  # one strip's data, the code
    assert {tag for tag, _ in tags.tags}.isdisjoint({"i"})
    assert [tag for tag, _ in tags.tags].count("b") == 2  # the names under the pictures
    data = json.loads(tags.scripts[0])
    assert data["pictures"][0] == {"name": EVIL, "caption": EVIL, "equations": [[1, 2, EVIL]]}
    assert dict(tags.tags)["glsim-compare"]
    page("\udcff", [strip("\udcff")]).encode("utf-8")  # half a surrogate, as file names may have


def test_pictures_are_png_with_the_arrays_values() -> None:
    pictures = [noise(5, 7, 3), noise(5, 7, 4)]
    text = element(Strip("s", [Picture("a", pictures[0]), Picture("b", pictures[1])]))
    for uri, pixels in zip(re.findall(r'src="data:image/png;base64,([^"]+)"', text), pictures, strict=True):
        assert np.array_equal(np.asarray(Image.open(io.BytesIO(base64.b64decode(uri)))), pixels)
    assert re.findall(r'alt="([^"]*)"', text) == ["s: a", "s: b"]


def test_metrics_are_computed_where_sizes_agree() -> None:
    a, b = noise(), noise(seed=1)
    text = element(Strip("s", [Picture("a", a), Picture("b", b), Picture("c", a[:4])]))
    rows = re.findall(r"<tr>(.*?)</tr>", text)
    found = metrics(a, b)
    assert f"<td>{found['max']:.0f}</td><td>{found['mean']:.4g}</td>" in rows[2]
    assert f"<td>{100 * found['different']:.3g} %</td>" in rows[2]
    assert "reference" in rows[1]
    assert "not comparable, 9 × 4" in rows[3]


def test_a_picture_without_alpha_is_opaque() -> None:
    a = noise()
    opaque = np.dstack([a, np.full(a.shape[:2], 255, np.uint8)])
    clear = np.dstack([a, np.zeros(a.shape[:2], np.uint8)])
    strip_of = Strip("s", [Picture("a", a), Picture("same", opaque), Picture("clear", clear)])
    rows = re.findall(r"<tr>(.*?)</tr>", element(strip_of))
    assert rows[2].startswith('<th scope="row">same</th><td>0</td>')
    assert rows[3].startswith('<th scope="row">clear</th><td>255</td>')


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (Strip("s", []), "strip 's'"),
        (Strip("s", [Picture("a", noise())], reference=1), "picture 1 is the reference"),
        (Strip("s", [Picture("grey", noise()[..., 0])]), "picture 'grey'"),
        (Strip("s", [Picture("float", noise() / 255)]), "float64"),
        (Strip("s", [Picture("empty", noise()[:0])]), "at least one pixel"),
        (Strip("s", [Picture("a", noise()), Picture("b", noise())], metrics=[{}]), "2 pictures, but 1 metrics"),
    ],
)
def test_what_cannot_be_shown_is_refused_with_a_sentence(wrong: Strip, words: str) -> None:
    with pytest.raises(ValueError, match="strip 's'") as caught:
        page("t", [wrong])
    assert words in str(caught.value)


def test_code_and_style_cannot_end_their_elements() -> None:
    code = Tags(element(strip())).scripts[-1]
    assert "customElements.define" in code
    assert code.rstrip().endswith("})();")
    assert "</style" not in web._file("page.css")
