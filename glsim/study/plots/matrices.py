"""Matrices as pictures: form factors, and the linear system of radiosity with its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim.study.plots.style import FAINT, INK, PAPER, Plot, diagram, plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes

NUMBERS = 14  # a matrix with more rows shows no numbers in its cells
Float = NDArray[np.float64]


def matrix(
    values: ArrayLike | Any, labels: Sequence[str] | None = None, *, title: str = "", bar: str = "", log: bool = False,
    numbers: bool | None = None,
) -> Plot:  # fmt: skip
    """A matrix as a picture with a colour bar, row 0 on top.

    values: (n, m), or a solution of glsim.radiosity.solve, of which the form factors F_ij are shown.  labels: of the
    rows and columns.  bar: what the colours mean.  log: colours by the logarithm, over four decades.  numbers: the
    values in the cells (None: if there are at most 14 rows).  Negative values get the other half of a scale of two
    colours.

    Example: ``plots.matrix(radiosity.solve("cornell", 100), log=True)``
    """
    M = form_factors(values) if hasattr(values, "factors") else np.asarray(values, float)
    if M.ndim != 2 or not M.size:
        raise ValueError(f"plots.matrix: a matrix (n, m) is needed, not an array of the shape {M.shape}")
    if labels is not None and len(labels) != len(M):
        raise ValueError(f"plots.matrix: {len(M)} labels are needed, one for each row, not {len(labels)}")
    words = bar or ("form factor $F_{ij}$" if hasattr(values, "factors") else "")
    shown = len(M) <= NUMBERS if numbers is None else numbers
    side = 6.2 if len(M) > 8 else max(4.2, 0.75 * len(M) + 1.5)

    def draw(axes: Axes) -> None:
        image = _cells(axes, M, log, shown)
        _name_cells(axes, M.shape, labels)
        if hasattr(values, "factors"):
            axes.set(xlabel="patch $j$, which receives", ylabel="patch $i$, which sends")
        axes.set_title(title)
        assert axes.figure is not None
        axes.figure.colorbar(image, ax=axes, label=words, shrink=0.85).outline.set_visible(False)

    return plot(
        draw, f"{title or bar or 'a matrix'}: {M.shape[0]} x {M.shape[1]} values as colours", (side + 1.2, side)
    )


def form_factors(result: Any) -> Float:
    """F (n, n) of a solution of glsim.radiosity.solve.  Raises ValueError if it keeps no matrix."""
    if result.factors.matrix is None:
        raise ValueError(f"plots.matrix: {result.factors.method} form factors are no matrix that could be shown")
    return np.asarray(result.factors.matrix / result.patches.area[:, None], float)


def system(result: Any, channel: int = 0, *, title: str = "") -> Plot:
    """The linear system E = (I - R F) B of a small solution, with all its numbers.

    result: of glsim.radiosity.solve, with at most 14 patches.  channel: 0 red, 1 green, 2 blue.

    Example: ``plots.system(radiosity.solve("goral", 10))``
    """
    n = len(result.patches)
    if n > NUMBERS:
        raise ValueError(f"plots.system: {n} patches have more numbers than can be read; take {NUMBERS} or fewer")
    rho, E, B = (np.asarray(part, float)[:, channel] for part in (result.patches.rho, result.patches.E, result.B))
    M = np.eye(n) - rho[:, None] * form_factors(result)
    return system_of(E, M, B, title=title)


def system_of(E: ArrayLike, M: ArrayLike, B: ArrayLike, *, title: str = "") -> Plot:
    """E = M B with the numbers in cells.  E, B: (n,); M: (n, n).

    Example: ``plots.system_of([1, 0], [[1, -0.4], [-0.2, 1]], [1.09, 0.22])``
    """
    E, M, B = np.asarray(E, float), np.asarray(M, float), np.asarray(B, float)
    n = len(M)
    if M.shape != (n, n) or E.shape != (n,) or B.shape != (n,):
        raise ValueError("plots.system_of: E (n,), M (n, n) and B (n,) are needed")
    parts = {"$E$": (E[:, None], 0.0), "$I - R\\,F$": (M, 2.4), "$B$": (B[:, None], n + 4.1)}

    def draw(axes: Axes) -> None:
        for name, (values, left) in parts.items():
            columns = values.shape[1]
            _cells(axes, values, False, True, left)
            axes.text(left + columns / 2.0, -0.95, name, ha="center", va="center", fontsize=17)
            for k in range(columns if columns > 1 else 0):
                axes.text(left + k + 0.5, -0.3, str(k), ha="center", va="center", fontsize=11, color=FAINT)
            for k in range(n):
                axes.text(left - 0.2, k + 0.5, str(k), ha="right", va="center", fontsize=11, color=FAINT)
        for sign, x in (("$=$", 1.5), (r"$\cdot$", n + 3.0)):
            axes.text(x, n / 2.0, sign, ha="center", va="center", fontsize=26)
        axes.set(xlim=(-0.6, n + 5.3), ylim=(n + 0.1, -1.5), title=title)

    words = f"{title or 'the linear system'}: {n} equations E = (I - R F) B with their numbers"
    return diagram(draw, words, (0.62 * (n + 6.6), 0.62 * (n + 1.8) + 0.3))


def _cells(axes: Axes, M: Float, log: bool, numbers: bool, left: float = 0.0) -> Any:
    """Draw the cells, each one unit large: white to blue, or red to blue where there are negative values."""
    from matplotlib.colors import LinearSegmentedColormap, LogNorm, Normalize

    low, high = float(np.nanmin(M)), float(np.nanmax(M))
    blues = ["#ffffff", "#cfe3f2", "#6baed6", "#0072B2", "#003a5d"]
    if low < 0.0:
        most = max(-low, high)
        norm: Normalize = Normalize(-most, most)
        both = ["#7a3300", "#D55E00", "#f6cdb0", "#ffffff", "#b5d5ea", "#0072B2", "#003a5d"]
        colors = LinearSegmentedColormap.from_list("two", both, 256)
    else:
        colors = LinearSegmentedColormap.from_list("one", blues, 256)
        norm = LogNorm(max(high, 1e-300) / 1e4, max(high, 1e-300), clip=True) if log else Normalize(0.0, high or 1.0)
    rows, columns = M.shape
    place = (left, left + columns, rows, 0.0)
    image = axes.imshow(M, cmap=colors, norm=norm, interpolation="nearest", aspect="equal", extent=place)
    outline = [left, left + columns, left + columns, left, left], [0, 0, rows, rows, 0]
    axes.plot(*outline, color=FAINT, linewidth=1.2, clip_on=False)
    axes.grid(False)
    for (row, column), value in np.ndenumerate(M) if numbers else ():
        r, g, b, _ = colors(norm(value))
        text = f"{value:.2f}".replace("-0.00", "0.00")
        dark = 0.3 * r + 0.59 * g + 0.11 * b < 0.55
        axes.text(
            left + column + 0.5, row + 0.5, text, color=PAPER if dark else INK, ha="center", va="center", fontsize=11
        )
    return image


def _name_cells(axes: Axes, shape: tuple[int, ...], labels: Sequence[str] | None) -> None:
    """Label rows and columns: by name, or by number from 0 if they are few."""
    axes.tick_params(length=0)
    axes.xaxis.set_ticks_position("top")
    axes.xaxis.set_label_position("top")
    axes.spines[:].set_visible(False)
    for axis, count in ((axes.xaxis, shape[1]), (axes.yaxis, shape[0])):
        step = 1 if count <= 16 else 5 if count <= 80 else 20 if count <= 300 else 100 * -(-count // 1500)
        shown = range(0, count, step)
        names = labels if labels is not None and len(labels) == count else [str(k) for k in range(count)]
        axis.set_ticks([k + 0.5 for k in shown], [names[k] for k in shown], fontsize=12)
    if labels is not None and max(map(len, labels)) > 3:
        axes.tick_params(axis="x", rotation=60)
