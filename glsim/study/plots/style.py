"""How plots look: one style for all, readable in a lecture hall, in print and for colour-blind people.

matplotlib is used without pyplot, so nothing is kept between two plots and no window opens.
"""

from __future__ import annotations

import hashlib
import io
import os
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from glsim.files import write_atomically

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Okabe & Ito, Color universal design (2008), without its yellow, which is too pale on paper
COLORS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#444444")
BLUE, RED, GREEN, PINK, ORANGE, SKY, GREY = COLORS
DASHES: tuple[Any, ...] = ("-", (0, (6, 2)), (0, (2, 1.5)), (0, (7, 2, 2, 2)), (0, (1, 1)), "-", (0, (4, 2)))
INK, FAINT, SURFACE, PAPER = "#1e2026", "#6e727c", "#d8d4c8", "#ffffff"
STYLE: dict[str, Any] = {
    "font.family": "DejaVu Sans", "font.size": 13.0, "axes.titlesize": 14.0, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.titlepad": 10.0, "axes.labelsize": 13.0, "axes.edgecolor": FAINT,
    "axes.labelcolor": INK, "axes.titlecolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.linewidth": 1.0, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
    "axes.axisbelow": True, "grid.color": "#e3e3de", "grid.linewidth": 1.0, "lines.linewidth": 2.6,
    "lines.solid_capstyle": "round", "legend.frameon": True, "legend.framealpha": 0.92, "legend.edgecolor": "none",
    "legend.fontsize": 12.0, "legend.handlelength": 2.8, "figure.facecolor": PAPER, "axes.facecolor": PAPER,
    "savefig.facecolor": PAPER, "svg.fonttype": "path", "svg.hashsalt": "glsim", "mathtext.fontset": "dejavusans",
}  # fmt: skip
MISSING = "glsim.plots draws with matplotlib, which is not installed: pip install 'glsim[course]'"


@contextmanager
def styled() -> Iterator[None]:
    """The style holds inside of the block.  Raises ImportError with a sentence if matplotlib is missing."""
    try:
        from matplotlib import rc_context
    except ImportError as error:
        raise ImportError(MISSING) from error
    with rc_context(STYLE):  # type: ignore[arg-type,unused-ignore]  # newer stubs of matplotlib want literal keys
        yield


class Plot:
    """A drawn plot: shown by Jupyter as SVG, written by ``save``.

    figure: matplotlib's Figure, for whoever wants to change it.  alt: in words what is drawn, for who cannot see it.
    """

    def __init__(self, figure: Figure, alt: str) -> None:
        self.figure, self.alt = figure, alt

    def __repr__(self) -> str:
        width, height = self.figure.get_size_inches()
        return f"<Plot {width:g} x {height:g} inches: {self.alt}>"

    def save(self, path: str | os.PathLike[str], dpi: float = 150.0) -> None:
        """Write .svg, .png, .pdf or another format of matplotlib; the file's ending says which.

        dpi: pixels an inch, for pictures made of pixels.  Raises ValueError for an ending that matplotlib cannot write.
        """
        kind = Path(path).suffix[1:].lower()
        known = self.figure.canvas.get_supported_filetypes()
        if kind not in known:
            raise ValueError(f"{path}: the name must end in .svg, .png or .pdf")
        data = self._written(kind, dpi)
        write_atomically(path, lambda name: Path(name).write_bytes(data))

    def svg(self) -> str:
        """The plot as the text of an SVG file, the same each time."""
        return self._written("svg", 72.0).decode()

    def image(self, dpi: float = 150.0) -> Any:
        """The plot as a PIL.Image.Image."""
        from PIL import Image

        return Image.open(io.BytesIO(self._written("png", dpi))).convert("RGB")

    def _written(self, kind: str, dpi: float) -> bytes:
        stream = io.BytesIO()
        nothing = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}.get(kind, {})
        with styled():
            self.figure.savefig(stream, format=kind, dpi=dpi, metadata=nothing, bbox_inches="tight", pad_inches=0.12)
        data = stream.getvalue()
        return _same_names(data.decode()).encode() if kind == "svg" else data

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_png_(self) -> bytes:
        return self._written("png", 150.0)


def _same_names(svg: str) -> str:
    """An SVG whose clip paths are named after the drawing; matplotlib names some after addresses in memory."""
    clips = dict(re.findall(r'<clipPath id="(\w+)">(.*?)</clipPath>\s*', svg, re.DOTALL))
    svg = re.sub(r"<clipPath .*?</clipPath>\s*", "", svg, flags=re.DOTALL)
    different = list(dict.fromkeys(clips.values()))
    for name, clip in clips.items():
        svg = svg.replace(f"url(#{name})", f"url(#clip-{different.index(clip)})")
    drawing = hashlib.sha256(svg.encode()).hexdigest()[:10]  # several plots on one page have names of their own
    svg = re.sub(r"url\(#clip-(\d+)\)", rf"url(#clip-{drawing}-\1)", svg)
    texts = (f'<clipPath id="clip-{drawing}-{number}">{clip}</clipPath>' for number, clip in enumerate(different))
    return svg.replace("</svg>", f"<defs>{''.join(texts)}</defs>\n</svg>")


def plot(draw: Callable[[Axes], None], alt: str, size: tuple[float, float] = (7.6, 4.6), **axes: Any) -> Plot:
    """One pair of axes, which ``draw`` fills.  size: inches; axes: for Figure.add_subplot."""
    with styled():
        from matplotlib.figure import Figure

        figure = Figure(figsize=size, layout="constrained")
        draw(figure.add_subplot(**axes))
        return Plot(figure, alt)


def diagram(draw: Callable[[Axes], None], alt: str, size: tuple[float, float] = (7.6, 4.6)) -> Plot:
    """A drawing without scales, of which one unit is as long in x as in y."""

    def without_scales(axes: Axes) -> None:
        axes.set_axis_off()
        axes.set_aspect("equal")
        draw(axes)

    return plot(without_scales, alt, size)


def line_style(number: int) -> dict[str, Any]:
    """Colour and dashes of the line with this number: lines differ in print, too."""
    return {"color": COLORS[number % len(COLORS)], "linestyle": DASHES[number % len(DASHES)]}
