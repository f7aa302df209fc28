"""One page for the teacher: how the marks are distributed, and every submission with its hints and pictures.

It needs no network and no other file.  Without JavaScript everything is there, but for sorting and filtering.
"""

from __future__ import annotations

import base64
import io
from collections import Counter
from collections.abc import Sequence
from html import escape
from pathlib import Path
from string import Template

from PIL import Image

from glsim.course.grading.record import Part, Record, Total
from glsim.course.grading.tables import exercise_names, first_sentence
from glsim.files import write_text
from glsim.web import page as web

ASSETS = Path(__file__).parents[1] / "assets"
MOST_BARS = 14
MANY = 6  # exercises whose points stand in a line of their own
THUMBNAIL = 288  # pixels
COMMON = 3  # hints that are shown for a part


def write(folder: Path, totals: Sequence[Total]) -> Path:
    """Write overview.html into a folder."""
    path = folder / "overview.html"
    write_text(path, overview(totals))
    return path


def overview(totals: Sequence[Total]) -> str:
    """The page for at least one submission."""
    names = exercise_names(totals)
    records = [record for total in totals for record in total.records]
    failures = sum(bool(record.failure) for record in records)
    whole = [total.points for total in totals if not any(record.failure for record in total.records)]
    mean = sum(whole) / max(len(whole), 1)
    isolation = ", ".join(sorted({r.isolation for r in records if r.isolation})) or "nothing was run"
    about = [
        f"{len(totals)} submission{'s' * (len(totals) != 1)}",
        f"mean {mean:.1f} of {totals[0].most} points",
        f"isolation: {isolation}",
    ]
    warning = f'<p class="failed" role="alert">{failures} could not be graded and have no mark.</p>' if failures else ""
    cards = [_card("All points", whole, totals[0].most, "")] if len(names) > 1 else []
    cards += [_exercise_card([record for record in records if record.exercise == name]) for name in names]
    heads = "".join(_head(_short(name, names), name) for name in names)
    rows = "\n".join(_row(total, names) for total in totals)
    css = Path(web.__file__).with_name("page.css").read_text(encoding="utf-8")
    return Template((ASSETS / "overview.html").read_text(encoding="utf-8")).substitute(
        policy=web.POLICY,
        css=css + (ASSETS / "overview.css").read_text(encoding="utf-8"),
        script=(ASSETS / "overview.js").read_text(encoding="utf-8"),
        about=escape("; ".join(about)),
        warning=warning,
        cards="\n".join(cards),
        size="many" if len(names) > MANY else "few",
        heads=heads if len(names) > 1 else "",
        rows=rows,
    )


def _short(name: str, names: Sequence[str]) -> str:
    return str(int(name[:2])) if len(names) > MANY else name[3:].replace("_", " ")


def _head(text: str, title: str) -> str:
    return f'<th scope="col" title="{escape(title)}"><button type="button">{escape(text)}</button></th>'


# ---------------------------------------------------------------- distributions


def _exercise_card(records: Sequence[Record]) -> str:
    """The distribution of an exercise's points, how many have each part right, and what is most often wrong."""
    first = records[0]
    judged = [record for record in records if not record.failure]
    parts = "".join(
        _part_statistics(part.about, [record.parts[number] for record in judged])
        for number, part in enumerate(first.parts)
    )
    return _card(first.title, [record.points for record in judged], first.most, f"<ul>{parts}</ul>")


def _card(title: str, values: Sequence[int], most: int, below: str) -> str:
    return f"<article><h3>{escape(title)}</h3>{_bars(values, most)}{below}</article>"


def _bars(values: Sequence[int], most: int) -> str:
    """A histogram of points from 0 to ``most``."""
    width = max(1, -(-(most + 1) // MOST_BARS))  # points that share a bar
    counts = Counter(value // width for value in values)
    highest = max(counts.values(), default=1)
    bars, words = [], []
    for number in range(most // width + 1):
        first, last = number * width, min(number * width + width - 1, most)
        label = str(first) if first == last else f"{first}-{last}"
        count = counts[number]
        bars.append(f'<li style="--share: {count / highest:.3f}"><b>{count or ""}</b><i></i><span>{first}</span></li>')
        words.append(f"{label} points: {count}")
    return f'<ol class="bars" aria-label="{", ".join(words)}">{"".join(bars)}</ol>'


def _part_statistics(about: str, parts: Sequence[Part]) -> str:
    right = sum(part.right for part in parts)
    share = right / len(parts) if parts else 0.0
    common = Counter(part.hint for part in parts if part.hint).most_common(COMMON)
    hints = "".join(f"<li><b>{count}</b> {escape(hint)}</li>" for hint, count in common)
    often = f"<details><summary>most often wrong</summary><ul>{hints}</ul></details>" if hints else ""
    return (
        f'<li><span class="share" style="--share: {share:.3f}">{escape(about)} '
        f"<b>{right} of {len(parts)}</b></span>{often}</li>"
    )


# ---------------------------------------------------------------- submissions


def _row(total: Total, names: Sequence[str]) -> str:
    marks = {record.exercise: record for record in total.records}
    cells = "".join(_mark(marks[name]) for name in names) if len(names) > 1 else ""
    failed = any(record.failure for record in total.records)
    state = "failed" if failed else "full" if total.points == total.most else "lost"
    if not any(record.file for record in total.records):
        state += " nofile"
    picture = next((part.picture for record in total.records for part in record.parts if part.picture), "")
    thumbnail = f'<img loading="lazy" alt="" src="data:image/jpeg;base64,{_smaller(picture)}">' if picture else ""
    details = "".join(_details(record) for record in total.records)
    share = total.points / total.most if total.most else 0.0
    return (
        f'<tr data-state="{state}"><th scope="row"><details><summary><b>{escape(total.submission)}</b> '
        f'<span class="note">{escape(first_sentence(total))}</span></summary>'
        f'{details}</details></th>{cells}<td class="total" data-value="{total.points}">'
        f'<span class="share" style="--share: {share:.3f}">{total.points} of {total.most}</span></td>'
        f'<td class="thumb">{thumbnail}</td></tr>'
    )


def _mark(record: Record) -> str:
    value = -1 if record.failure else record.points
    state = "failed" if record.failure else "full" if value == record.most else "none" if value == 0 else "some"
    text = "!" if record.failure else "-" if not record.file else str(record.points)
    title = escape(f"{record.title}: {record.failure or record.note or f'{record.points} of {record.most}'}")
    number = int(record.exercise[:2])
    return f'<td class="mark {state}" data-label="{number}" data-value="{value}" title="{title}">{text}</td>'


def _details(record: Record) -> str:
    """What is to be said about a submission's file: what was graded, each part with its hint, what it printed."""
    notes = "".join(
        f'<p class="{kind}">{escape(text)}</p>'
        for kind, text in (("failed", record.failure), ("note", record.note), ("note", _file(record)))
        if text
    )
    parts = "".join(_part(part) for part in record.parts) if record.file and not record.failure else ""
    printed = f"<pre>{escape(record.printed)}</pre>" if record.printed else ""
    points = "not graded" if record.failure else f"{record.points} of {record.most}"
    head = f"<h4>{escape(record.title)} <span>{points}</span></h4>"
    return f"<section>{head}{notes}<ul>{parts}</ul>{printed}</section>"


def _file(record: Record) -> str:
    return f"{record.file}, {record.seconds:.1f} s, {record.isolation}" if record.isolation else ""


def _part(part: Part) -> str:
    if part.right:
        return f'<li class="right">{escape(part.about)}</li>'
    picture = _image(part.picture, f"{part.about}: expected, actual and difference") if part.picture else ""
    return f'<li class="wrong">{escape(part.about)}: {escape(part.hint)}{picture}</li>'


def _smaller(picture: str) -> str:
    """A PNG in base64 as a JPEG in base64, small enough for hundreds on a page."""
    image = Image.open(io.BytesIO(base64.b64decode(picture))).convert("RGB")
    image.thumbnail((THUMBNAIL, THUMBNAIL))
    buffer = io.BytesIO()
    image.save(buffer, "JPEG", quality=85)
    return base64.b64encode(buffer.getvalue()).decode("ascii")


def _image(picture: str, alternative: str) -> str:
    source = f"data:image/png;base64,{picture}"
    return f'<img loading="lazy" decoding="async" alt="{escape(alternative)}" src="{source}">'
