"""The course as a site of static pages: a table of contents and a page for each lesson; no page asks another server."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from string import Template

from glsim.course.cells import PREDICTION, Cell, Lesson, folded
from glsim.course.markdown import html, mathml
from glsim.course.outputs import FILE_ENDINGS, LIVE, Output, awaited, write_figures
from glsim.course.source import highlighted
from glsim.files import write_bytes, write_text
from glsim.web.live import program

TEMPLATES = Path(__file__).parent / "assets"
PLAYER = '<script src="assets/live.js" defer></script>\n'  # on pages with live figures
ASSETS = ("course.css", "course.js", "STIXTwoMath.woff2", "STIXTwoMath-LICENSE.txt")
UNTOLD = '<span class="untold" aria-hidden="true">?</span>'  # for a lesson whose only picture is its prediction's


@dataclass(frozen=True)
class Page:
    """A lesson that was run: its outputs, one for each cell."""

    lesson: Lesson
    outputs: Sequence[Output]


def write_site(folder: Path, pages: Sequence[Page]) -> list[Path]:
    """Write the pages of lessons, in their order, their table of contents and what they share; returns the HTML files.

    folder: made if it does not exist.  Each file is written whole; the table of contents is written last.
    Raises MissingPackageError without the extra ``course``, FormulaError for a formula that is none."""
    (folder / "assets").mkdir(parents=True, exist_ok=True)
    for name in ASSETS:
        write_bytes(folder / "assets" / name, (TEMPLATES / name).read_bytes())
    write_text(folder / "assets" / "live.js", program())
    written = []
    for number, page in enumerate(pages):
        write_figures(folder / "figures", page.lesson, page.outputs)
        path = folder / f"{page.lesson.name}.html"
        before = pages[number - 1].lesson if number else None
        after = pages[number + 1].lesson if number + 1 < len(pages) else None
        write_text(path, _lesson(page, [p.lesson for p in pages], before, after))
        written.append(path)
    index = folder / "index.html"
    write_text(index, _index(pages))
    return [index, *written]


def _index(pages: Sequence[Page]) -> str:
    cards = []
    for page in pages:
        lesson = page.lesson
        untold = awaited(lesson, page.outputs)
        shown = [name for number, name in enumerate(_pictures(page)) if name and number not in untold]
        image = f'<img src="{shown[0]}" alt="" loading="lazy">' if shown else UNTOLD
        cards.append(
            f'<li><a href="{lesson.name}.html">{image}<strong>{lesson.number}. {escape(lesson.title)}</strong>'
            f'<span class="about">{_plain(lesson.about)}</span></a></li>'
        )
    body = f'<h1>How light becomes pixels</h1><ol class="cards">{"".join(cards)}</ol>'
    return _filled("How light becomes pixels", "index", "", body, "")


def _lesson(page: Page, all_: Sequence[Lesson], before: Lesson | None, after: Lesson | None) -> str:
    lesson = page.lesson
    links = "".join(
        f'<li><a href="{one.name}.html"{" aria-current=page" if one is lesson else ""}>{one.number}. '
        f"{escape(one.title)}</a></li>"
        for one in all_
    )
    untold = awaited(lesson, page.outputs)
    sections = [_section(page, k, picture, k in untold) for k, picture in enumerate(_pictures(page))]
    around = "".join(
        f'<a class="{word}" rel="{word}" href="{other.name}.html">{escape(other.title)}</a>'
        for word, other in (("prev", before), ("next", after))
        if other
    )
    around = f'<footer><nav aria-label="Lessons">{around}</nav></footer>\n{_player(page)}'
    contents = f'<details class="contents"><summary>Contents</summary><ol>{links}</ol></details>'
    return _filled(lesson.title, "lesson", contents, "".join(sections), around)


def _player(page: Page) -> str:
    """The code of live figures, if there is one."""
    return PLAYER if any(LIVE in output.shown for output in page.outputs) else ""


def _filled(title: str, kind: str, contents: str, body: str, around: str) -> str:
    template = Template((TEMPLATES / "page.html").read_text(encoding="utf-8"))
    return template.substitute(title=escape(title), kind=kind, contents=contents, body=body, around=around)


# ---------------------------------------------------------------- the cells of a page


def _pictures(page: Page) -> list[str]:
    """For each cell the address of the picture that it shows; "" if it shows none."""
    return [
        next((f"figures/{page.lesson.name}-{k}{end}" for kind, end in FILE_ENDINGS.items() if kind in output.shown), "")
        for k, output in enumerate(page.outputs)
    ]


def _section(page: Page, number: int, picture: str, untold: bool) -> str:
    cell, output = page.lesson.cells[number], page.outputs[number]
    if cell.kind == "markdown":
        kind = "predict" if PREDICTION.search(cell.source) else "prose"
        return f'<section class="cell {kind}">{html(folded(cell.source))}</section>'
    quoted = cell.source.startswith("glsim.source(")  # the lines of source alone are shown, not the call
    code = "" if quoted else highlighted(cell.source, "python")
    printed = f'<pre class="printed">{escape(output.printed)}</pre>' if output.printed else ""
    result = printed + (_figure(page.lesson, cell, output, picture) if output.shown else "")
    if result and untold:
        result = f'<details class="answer"><summary>Predict first, then look</summary>{result}</details>'
    return f'<section class="cell code">{code}{result}</section>'


def _figure(lesson: Lesson, cell: Cell, output: Output, picture: str) -> str:
    """What a cell shows: a live element, a picture in a file of its own, a formula or text."""
    caption = f"<figcaption>{_plain(cell.title)}</figcaption>" if cell.title else ""
    if LIVE in output.shown:
        return f'<figure class="live">{output.shown[LIVE]}{caption}</figure>'
    if "text/html" in output.shown:
        content = output.shown["text/html"]
        return content if content.startswith("<figure") else f'<figure class="live">{content}{caption}</figure>'
    if picture:
        alternative = escape(cell.title or f"Figure of {lesson.title}", quote=True)
        return f'<figure class="picture"><img src="{picture}" alt="{alternative}" loading="lazy">{caption}</figure>'
    if "text/latex" in output.shown:
        return f'<figure class="formula">{mathml(output.shown["text/latex"].strip().strip("$"))}{caption}</figure>'
    return f'<pre class="printed">{escape(output.shown["text/plain"])}</pre>'


def _plain(text: str) -> str:
    """A line of Markdown as HTML without a paragraph around it."""
    return html(text).strip().removeprefix("<p>").removesuffix("</p>")
