"""A Comparison: pictures in columns and rows, what they differ by, and how they are shown and saved."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim import metrics
from glsim.files import check_folder, write_atomically, write_text
from glsim.study.axes import Axis
from glsim.study.looks import truest
from glsim.study.sheet import draw_sheet
from glsim.study.studio import Cell, Key, Pixels

if TYPE_CHECKING:
    from PIL import Image

    from glsim.study.shown import Shown
    from glsim.web.live import Live
    from glsim.web.page import Strip

FACTORS = (1, 2, 4, 8, 16, 32, 64)  # as the page offers them
MILLISECONDS = 80  # of a picture of an animation


@dataclass(frozen=True)
class Comparison:
    """Pictures of one scene, or given ones.

    columns, rows: the two axes.  cells[row, column]: picture and Frame, see ``images``.
    reference: the name of the column that differences are taken from, in each row.
    factor: how many times differences are amplified on the sheet, 0 for none, None: see ``amplified``.
    layout: of the sheet, see sheet.LAYOUTS.
    captions: name of a column or row -> words for it.  legend: the illumination equation.  note: what went wrong,
    though there are pictures.  remarks: sentences about what is shown otherwise than it was given.
    film: sheets of an animation.  live: the same as a live picture, None if it was not asked for.
    """

    title: str
    columns: Axis
    rows: Axis
    cells: dict[Key, Cell]
    reference: str
    outlines: frozenset[str] = frozenset()
    factor: int | None = None
    layout: str = "screen"
    captions: Mapping[str, str] = field(default_factory=dict)
    legend: str = ""
    note: str = ""
    remarks: tuple[str, ...] = ()
    film: Sequence[Image.Image] = ()
    live: Live | None = None

    def __repr__(self) -> str:
        height, width = next(iter(self.images.values())).shape[:2]
        names = "; ".join(filter(None, (", ".join(axis.names) for axis in (self.columns, self.rows))))
        return f"<Comparison {self.title} {width} x {height}: {names}>"

    @property
    def images(self) -> dict[Key, Pixels]:
        """images[row, column]: (height, width, 3) uint8, top row first.

        There is none for ("phong", "native"): the driver's fixed function has only the other lobe."""
        return {key: cell.pixels for key, cell in self.cells.items() if cell.pixels is not None}

    # ------------------------------------------------------------ differences

    def reference_of(self, row: str) -> str:
        """The column that a row's differences are taken from: ``reference``, or, if that has no picture in the
        row, the truest that has one (looks.truest)."""
        there = self.pictures_of(row)
        return self.reference if self.reference in there else truest(there)

    def pictures_of(self, row: str) -> list[str]:
        """The columns that have a picture in a row: native and pyrender have none for a lobe that they lack."""
        return [column for column in self.columns.names if (row, column) in self.images]

    @cached_property
    def amplified(self) -> int:
        """How many times differences are amplified on the sheet, all alike so that they can be compared: ``factor``, or
        the power of two, up to 64, that makes the largest of them white."""
        if self.factor is not None:
            return self.factor
        largest = max((int(self.difference(*key).max()) for key in self.images if self.has_difference(*key)), default=0)
        return next((factor for factor in FACTORS if factor * largest >= 255), FACTORS[-1]) if largest else 1

    def difference(self, row: str, column: str) -> NDArray[np.int16]:
        """|picture - reference of its row|, (height, width, 3) in 0..255.  Raises ValueError if their sizes differ."""
        return np.abs(metrics.difference(self.images[row, self.reference_of(row)], self.images[row, column]))

    def has_difference(self, row: str, column: str) -> bool:
        """Whether the difference says something: of two pictures of one size that are more than outlines."""
        reference = self.reference_of(row)
        sizes = {self.images[row, name].shape for name in (column, reference)}
        return column != reference and len(sizes) == 1 and self.outlines.isdisjoint((row, column, reference))

    @cached_property
    def metrics(self) -> list[dict[str, Any]]:
        """For each picture the names of its row, column and reference, and the numbers of glsim.metrics.metrics; None
        where there are none: for pictures of two sizes, and for one that is alone in its row.  A list of dicts, as
        pandas.DataFrame takes it."""
        found = []
        for row, column in self.images:
            names = {self.rows.name: row} if self.rows.name else {}
            names |= {self.columns.name: column, "reference": self.reference_of(row)}
            a, b = (self.images[row, name] for name in (names["reference"], column))
            alone = a.shape != b.shape or len(self.pictures_of(row)) == 1 < len(self.columns.values)
            values: Mapping[str, float | None] = metrics.metrics(a, a if alone else b)
            found.append({**names, **(dict.fromkeys(values) if alone else values)})
        return found

    @property
    def notes(self) -> list[str]:
        """Sentences: what went wrong, though there are pictures; remarks; which pictures have another size."""
        found = [*([self.note] if self.note else []), *self.remarks]
        for row, column in self.images:
            sizes = [self.images[row, name].shape[1::-1] for name in (column, self.reference_of(row))]
            if sizes[0] != sizes[1]:
                words = " and ".join(f"{width} x {height}" for width, height in sizes)
                found.append(f"{column} and {self.reference_of(row)} have {words} pixels: no difference can be taken")
        return found

    def statistics(self) -> list[dict[str, Any]]:
        """The metrics in short: names of row and column, the largest and the mean difference, in 1/255."""
        axes = [axis.name for axis in (self.rows, self.columns) if axis.name]
        found = []
        for row in self.metrics:
            sized = row["max"] is not None
            short = {"max": int(row["max"]), "mean": round(row["mean"], 4)} if sized else {"max": None, "mean": None}
            found.append({**{name: row[name] for name in axes}, **short})
        return found

    def numbers(self, row: str, column: str) -> dict[str, Any]:
        """The metrics of one picture."""
        return self.metrics[list(self.images).index((row, column))]

    def difference_words(self, row: str, column: str) -> list[str]:
        """What is written beside a difference."""
        if column == self.reference_of(row):
            return ["reference"] if len(self.pictures_of(row)) > 1 else []
        if not self.has_difference(row, column):
            height, width = self.images[row, column].shape[:2]
            return [] if self.numbers(row, column)["max"] is not None else ["another size:", f"{width} x {height}"]
        values = self.numbers(row, column)
        return [f"difference x{self.amplified}", f"max {values['max']:.0f}", f"mean {values['mean']:.2f}",
                f"SSIM {values['ssim']:.3f}"]  # fmt: skip

    # ------------------------------------------------------------ showing and saving

    @property
    def sheet(self) -> Image.Image:
        """The labelled sheet: pictures, and under them, smaller, amplified differences from the reference."""
        return draw_sheet(self)

    def strips(self, equations: Mapping[Key, Mapping[tuple[int, int], str]] | None = None) -> list[Strip]:
        """What the HTML element shows: for each row its pictures, which swap in place.

        equations: for pixels of a picture the text of the probe."""
        from glsim.web.page import Picture, Strip

        found = []
        images = self.images
        for row in self.rows.values:
            columns = [column for column in self.columns.values if (row.name, column.name) in images]
            if not columns:
                continue
            pictures = [
                Picture(column.label, images[row.name, column.name],
                        ".  ".join(filter(None, (self.captions.get(column.name, ""), column.formula))),
                        (equations or {}).get((row.name, column.name)))
                for column in columns
            ]  # fmt: skip
            names = [column.name for column in columns]
            notes = [f"{column.label}: {self.cells[row.name, column.name].words}"
                     for column in self.columns.values if column.name not in names]  # fmt: skip
            title = self.captions.get(row.name, row.label) or self.title
            found.append(
                Strip(title, pictures, names.index(self.reference_of(row.name)), "", notes, self._table(row.name),
                      self.amplified)
            )  # fmt: skip
        return found

    def _table(self, row: str) -> list[Mapping[str, float] | None]:
        """The metrics of a row's pictures, for the element."""
        names = {self.rows.name, self.columns.name, "reference"}
        rows = [values for (name, _), values in zip(self.images, self.metrics, strict=True) if name == row]
        return [
            None if values["max"] is None else {key: value for key, value in values.items() if key not in names}
            for values in rows
        ]

    def save(self, path: str | os.PathLike[str], progress: Callable[[str], object] | None = None) -> None:
        """Write the sheet as a picture, a page to compare in (.html), or the animation (.gif) if there is one.

        progress: called with what is being done for a page, whose equations take some seconds."""
        ending = Path(path).suffix.lower()
        check_folder(path)
        if ending in (".html", ".htm"):
            from glsim.study.equations import equations
            from glsim.web.page import page

            found = equations(self.cells, progress or (lambda words: None))
            about = "\n\n".join(filter(None, (self.legend, *self.notes)))
            write_text(path, page(f"{self.title}: a comparison", self.strips(found), about))
        elif ending == ".gif":
            if not self.film:
                raise ValueError(f'{path}: nothing moves: compare(..., animate="turntable") makes an animation')
            first, *rest = self.film
            write_atomically(path, lambda name: first.save(
                name, save_all=True, append_images=rest, duration=MILLISECONDS, loop=0))  # fmt: skip
        else:
            sheet = self.sheet
            write_atomically(path, lambda name: sheet.save(name))

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.sheet.save(buffer, "PNG")
        return buffer.getvalue()

    def _repr_html_(self) -> str:
        if self.live is not None:
            return self._shown(self.live)._repr_html_()
        from glsim.web.page import element

        return "\n".join(element(strip) for strip in self.strips())

    def _repr_live_(self) -> str | None:
        return None if self.live is None else self._shown(self.live)._repr_live_()

    def _shown(self, live: Live) -> Shown:
        from glsim.study.shown import Shown

        return Shown(live, self.sheet)
