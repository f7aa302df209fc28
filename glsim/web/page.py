"""Pictures to compare as HTML: one offline page of strips, or one strip as an element for a notebook or lesson.

A strip is a custom element, ``<glsim-compare>`` (compare.js, compare.css).  Its children are plain HTML: a heading, a
figure for each picture, a table of metrics.  They are what a reader without JavaScript and a printer get; compare.js
takes the pixels out of the figures' PNGs and builds the viewer.
"""

from __future__ import annotations

import base64
import io
import json
import re
from collections.abc import Mapping, Sequence
from functools import cache
from html import escape
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.metrics import metrics

SCRIPTS = ("png.js", "stage.js", "controls.js", "hands.js", "viewer.js", "compare.js")
MANY = 4  # strips: a page with more has a table of contents
SYMBOL = re.compile(  # k_d and w_1, but no file's name; x^n
    r"(?<![\w./-])(?P<letter>[A-Za-z])_(?P<index>\d+|[A-Za-z])(?![\w./])|(?<=[\w)])\^(?P<exponent>\d+|[A-Za-z])(?!\w)"
)
FITTING = "max-width: 100%; height: auto"
LABELS = {"max": "Max", "mean": "Mean", "rmse": "RMSE", "different": "Different", "ssim": "SSIM", "flip": "FLIP"}
MEANINGS = {
    "max": "largest difference of a channel, 0 to 255",
    "mean": "mean difference of all channels, 0 to 255",
    "rmse": "root of the mean squared difference, 0 to 255",
    "different": "share of pixels that differ in any channel",
    "ssim": "structural similarity of luminance, 1 for equal pictures",
    "flip": "mean difference that FLIP predicts people to see, 0 to 1",
}


class Picture(NamedTuple):
    """A picture of a strip.

    name: short, the label of its button.
    pixels: (height, width, 3 or 4) uint8, top row first.
    caption: one line, such as the formula of the shading mode.
    equations: for some pixels (x, y), counted from the upper left corner, the text that the page shows when a pixel
        near them is clicked.
    """

    name: str
    pixels: NDArray[np.uint8]
    caption: str = ""
    equations: Mapping[tuple[int, int], str] | None = None


class Strip(NamedTuple):
    """Pictures that are shown in the same place.  Their sizes may differ; then there is no difference to show.

    reference: the index of the picture from which differences are taken.
    status: "failed" and "passed" are marked, and failed strips come first; any other word is shown as it is.
    notes: sentences under the title.
    gain: how many times a difference is amplified at first.
    metrics: for each picture its numbers against the reference, None where there are none; if empty, they are
        computed by glsim.metrics for all pictures of the reference's size.
    """

    title: str
    pictures: Sequence[Picture]
    reference: int = 0
    status: str = ""
    notes: Sequence[str] = ()
    metrics: Sequence[Mapping[str, float] | None] = ()
    gain: int = 8


def element(strip: Strip) -> str:
    """An HTML fragment that needs nothing else; any number of them can stand on one page or in one notebook.

    Raises ValueError for a strip without pictures, or with a picture that is not (height, width, 3 or 4) uint8.
    """
    return _encodable(f"{_strip(strip, 'h3')}\n{_script()}\n")


def page(title: str, strips: Sequence[Strip], about: str = "") -> str:
    """A whole HTML page for any browser, without a network.

    about: text under the title; an empty line begins a new paragraph.  Failed strips come first.
    Raises ValueError as ``element`` does.
    """
    ordered = sorted(strips, key=lambda strip: strip.status != "failed")
    body = "\n".join(
        f'<section id="strip-{number}">\n{_strip(strip, "h2")}\n</section>' for number, strip in enumerate(ordered, 1)
    )
    paragraphs = "\n".join(f"<p>{typeset(text)}</p>" for text in about.split("\n\n") if text.strip())
    return _encodable(f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{escape(title)}</title>
<style>
{_file("page.css")}</style>
</head>
<body>
<header>
<h1>{escape(title)}</h1>
{paragraphs}
{_contents(ordered)}
</header>
<main>
{body}
</main>
{_script()}
</body>
</html>
""")


# The page itself forbids requests: pictures are data, script and style stand in it.
POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'"


def typeset(text: str) -> str:
    """Text as HTML, in which "k_d" has an index and "x^n" an exponent; viewer.js does the same (``typeset``)."""

    def symbol(found: re.Match[str]) -> str:
        letter, index, exponent = found.groups()
        return f"{letter}<sub>{index}</sub>" if letter else f"<sup>{exponent}</sup>"

    return SYMBOL.sub(symbol, escape(text))


def _contents(strips: Sequence[Strip]) -> str:
    """How many strips there are of each status and, when there are many, links to them."""
    groups: dict[str, list[str]] = {}
    for number, strip in enumerate(strips, 1):
        link = f'<li><a href="#strip-{number}">{escape(strip.title)}</a></li>'
        groups.setdefault(strip.status, []).append(link)
    counts = ", ".join(f"{len(links)} {status}" for status, links in groups.items() if status)
    words = f'<p class="counts">{escape(counts)}</p>\n' if counts else ""
    if len(strips) <= MANY:
        return words
    lists = "\n".join(
        f"<details{'' if status == 'passed' else ' open'}><summary>{escape(status.capitalize() or 'Contents')} "
        f"<span>{len(links)}</span></summary>\n<ol>{''.join(links)}</ol></details>"
        for status, links in groups.items()
    )
    return f'{words}<nav aria-label="Contents">\n{lists}\n</nav>'


def _strip(strip: Strip, heading: str) -> str:
    if not 0 <= strip.reference < len(strip.pictures):
        count = len(strip.pictures)
        raise ValueError(f"strip {strip.title!r}: picture {strip.reference} is the reference, but there are {count}")
    figures = "\n".join(_figure(strip, picture) for picture in strip.pictures)
    notes = "".join(f"<p>{typeset(note)}</p>" for note in strip.notes)
    status = f' <span class="status" data-status="{escape(strip.status)}">{escape(strip.status)}</span>'
    data = {
        "title": strip.title,
        "reference": strip.reference,
        "gain": strip.gain,
        "pictures": [
            {
                "name": picture.name,
                "caption": picture.caption,
                "equations": [[int(x), int(y), text] for (x, y), text in (picture.equations or {}).items()],
            }
            for picture in strip.pictures
        ],
    }
    return f"""<glsim-compare data-lm-suppress-shortcuts="true">
<{heading}>{typeset(strip.title)}{status if strip.status else ""}</{heading}>{notes}
{figures}
{_table(strip)}
<script type="application/json">{_json(data)}</script>
</glsim-compare>"""


def _figure(strip: Strip, picture: Picture) -> str:
    pixels = np.asarray(picture.pixels)
    if pixels.ndim != 3 or pixels.shape[2] not in (3, 4) or pixels.dtype != np.uint8 or not pixels.size:
        raise ValueError(
            f"picture {picture.name!r} of strip {strip.title!r} is {pixels.shape} {pixels.dtype}; "
            "expected (height, width, 3 or 4) uint8 with at least one pixel"
        )
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels)).save(buffer, "PNG")
    uri = "data:image/png;base64," + base64.b64encode(buffer.getvalue()).decode("ascii")
    alt = escape(f"{strip.title}: {picture.name}" + (f", {picture.caption}" if picture.caption else ""))
    height, width = pixels.shape[:2]
    return (
        f'<figure><img loading="lazy" decoding="async" width="{width}" height="{height}" style="{FITTING}" '
        f'alt="{alt}" src="{uri}">'
        f"<figcaption><b>{typeset(picture.name)}</b> {typeset(picture.caption)}</figcaption></figure>"
    )


def _table(strip: Strip) -> str:
    """The metrics of each picture against the reference."""
    rows = strip.metrics or [_against(strip.pictures[strip.reference], picture) for picture in strip.pictures]
    if len(rows) != len(strip.pictures):
        raise ValueError(f"strip {strip.title!r} has {len(strip.pictures)} pictures, but {len(rows)} metrics")
    keys = list(dict.fromkeys(key for row in rows if row for key in row))
    heads = "".join(
        f'<th scope="col" title="{escape(MEANINGS.get(key, ""))}">{escape(LABELS.get(key, key))}</th>' for key in keys
    )
    body = []
    for number, (picture, row) in enumerate(zip(strip.pictures, rows, strict=True)):
        name = f'<th scope="row">{typeset(picture.name)}</th>'
        if number == strip.reference:
            cells = f'<td colspan="{len(keys) or 1}">reference</td>'
        elif row is None:
            height, width = picture.pixels.shape[:2]
            cells = f'<td colspan="{len(keys) or 1}">not comparable, {width} × {height}</td>'
        else:
            cells = "".join(f"<td>{_number(key, row[key]) if key in row else ''}</td>" for key in keys)
        body.append(f"<tr>{name}{cells}</tr>")
    against = f'<th scope="col">Against {typeset(strip.pictures[strip.reference].name)}</th>'
    return f"<table><thead><tr>{against}{heads}</tr></thead><tbody>{''.join(body)}</tbody></table>"


def _against(reference: Picture, picture: Picture) -> dict[str, float] | None:
    a, b = reference.pixels, picture.pixels
    if a.ndim == b.ndim == 3 and a.shape[2] != b.shape[2]:
        a, b = _rgba(a), _rgba(b)
    return metrics(a, b) if a.shape == b.shape else None


def _rgba(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A picture without alpha is opaque."""
    if pixels.shape[2] == 4:
        return pixels
    return np.dstack([pixels, np.full(pixels.shape[:2], 255, np.uint8)])


def _number(key: str, value: float) -> str:
    if key == "different":
        return f"{100 * value:.3g} %"
    return f"{value:.0f}" if float(value).is_integer() else f"{value:.4g}"


def _encodable(text: str) -> str:
    """Without halves of surrogate pairs, which names of files can contain and no file of UTF-8 can."""
    return text.encode("utf-8", "replace").decode("utf-8")


def _json(data: object) -> str:
    """JSON that can stand in a script element: no end tag and no comment can begin in it."""
    return json.dumps(data, ensure_ascii=False).replace("<", "\\u003c")


def _script() -> str:
    """The custom element's code in a function of its own, after its style as the text COMPARE_CSS."""
    code = "".join(_file(name) for name in SCRIPTS)
    style = _json(_file("compare.css"))
    return f'<script>(() => {{\n"use strict";\nconst COMPARE_CSS = {style};\n{code}}})();\n</script>'


@cache
def _file(name: str) -> str:
    return Path(__file__).with_name(name).read_text(encoding="utf-8")
