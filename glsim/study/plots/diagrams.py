"""Diagrams of rays: reflection, refraction, the construction of R and of H, Lambert's cosine law, form factors."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from glsim import shading
from glsim.study.plots.curves import N, in_plane, incidence, incidences, medium, polarised_shares
from glsim.study.plots.style import BLUE, COLORS, FAINT, GREEN, INK, ORANGE, PINK, RED, SURFACE, Plot, diagram

if TYPE_CHECKING:
    from matplotlib.axes import Axes

O = np.zeros(2)  # noqa: E741  the lit point


def at(degrees: float, length: float = 1.0) -> Any:
    """The point (2,) at an angle from the normal, which points up; positive angles lean to the right."""
    return length * in_plane(degrees)[[0, 2]]


def reflection(theta: float | Sequence[float] = 40.0) -> Plot:
    """The law of reflection: the ray leaves at the angle at which it came.

    theta: angle of incidence in degrees, or several, each in a colour of its own.

    Example: ``plots.reflection((20, 50))``
    """
    angles = incidences("reflection", theta)

    def draw(axes: Axes) -> None:
        _ground(axes)
        _arrow(axes, O, at(0, 1.12), INK, "$N$", (0, 8))
        for number, t in enumerate(angles):
            color = COLORS[number % len(COLORS)]
            _ray(axes, at(-t, 1.2), O, color)
            _ray(axes, O, at(t, 1.2), color)
            if len(angles) == 1:
                _angle(axes, -t, 0, 0.42, r"$\theta_i$")
                _angle(axes, 0, t, 0.42, r"$\theta_r$")
                _label(axes, at(-t, 1.28), "light")
                _label(axes, at(t, 1.28), "$R$")
            else:
                _label(axes, at(-t, 1.3), f"{t:g}°", color)
                _label(axes, at(t, 1.3), f"{t:g}°", color)
        axes.set_title(r"Law of reflection: $\theta_r = \theta_i$")
        _room(axes, 1.5, (-0.25, 1.4))

    return diagram(draw, f"light reflected at {_list(angles)} degrees on both sides of the normal")


def refraction(
    n_1: str | float = "air", n_2: str | float = "glass", theta: float | Sequence[float] = (20, 40, 60)
) -> Plot:
    """Snell's law: rays from one medium into another, with the share that is reflected as their width.

    n_1, n_2: names of plots.MEDIA or refractive indices, above and below the surface.  theta: angles of incidence in
    degrees.  Rays beyond the critical angle are reflected totally.

    Example: ``plots.refraction("glass", "air", (20, 35, 60))``
    """
    (name_1, a), (name_2, b) = medium(n_1), medium(n_2)
    n_a, n_b = complex(a).real, complex(b).real
    angles = incidences("refraction", theta)
    total = [t for t in angles if n_a * np.sin(np.radians(t)) > n_b]

    def draw(axes: Axes) -> None:
        _water(axes, n_b > n_a)
        axes.plot([0, 0], [-1.3, 1.3], color=FAINT, linewidth=1.2, linestyle=(0, (4, 3)))
        _label(axes, (0.0, 1.38), "$N$", INK)
        for number, t in enumerate(angles):
            color = COLORS[number % len(COLORS)]
            F = float(np.mean([share[()] for share in polarised_shares(np.cos(np.radians(t)), n_a, n_b)]))
            _ray(axes, at(-t, 1.3), O, color, 3.4)
            _label(axes, at(-t, 1.42), f"{t:g}°", color)
            _ray(axes, O, at(t, 1.3), color, 0.6 + 2.8 * F, alpha=0.35 + 0.65 * F)
            if t in total:
                _label(axes, at(t, 1.42), "total", color)
                continue
            bent = float(np.degrees(np.arcsin(n_a / n_b * np.sin(np.radians(t)))))
            _ray(axes, O, -at(-bent, 1.3), color, 0.6 + 2.8 * (1.0 - F))
            _label(axes, -at(-bent, 1.42), f"{bent:.1f}°", color)
        _medium(axes, 1.0, name_1, n_a)
        _medium(axes, -1.0, name_2, n_b)
        axes.set_title(r"Snell's law: $n_1 \sin\theta_1 = n_2 \sin\theta_2$")
        _room(axes, 1.9, (-1.5, 1.5))

    words = f"; totally reflected at {_list(total)} degrees" if total else ""
    return diagram(draw, f"rays from {name_1} into {name_2} at {_list(angles)} degrees{words}", (7.6, 6.2))


def computing_r(theta: float = 35.0) -> Plot:
    """The lecture's construction R = (N.L) N + S with S = (N.L) N - L.  theta: angle of incidence in degrees.

    Example: ``plots.computing_r(35)``
    """
    theta = incidence("computing_r", theta)
    L, R = at(-theta), at(theta)
    foot = np.array([0.0, L[1]])

    def draw(axes: Axes) -> None:
        _ground(axes)
        _arrow(axes, O, at(0, 1.25), INK, "$N$", (0, 8))
        _arrow(axes, O, L, ORANGE, "$L$", (-10, 6))
        _arrow(axes, O, R, BLUE, "$R$", (10, 6))
        _arrow(axes, O, foot, GREEN)
        _label(axes, 0.66 * foot + (0.03, 0.0), r"$(N \cdot L)\,N$", GREEN, "left")
        for start in (L, foot):
            _arrow(axes, start, start + foot - L, RED)
        for x in (L[0] / 2.0, R[0] / 2.0):
            _label(axes, (x, L[1] + 0.07), "$S$", RED)
        _angle(axes, -theta, 0, 0.3, r"$\theta$")
        _angle(axes, 0, theta, 0.3, r"$\theta$")
        axes.set_title(r"$S = (N \cdot L)\,N - L,\quad R = (N \cdot L)\,N + S$")
        _room(axes, 1.5, (-0.2, 1.4))

    return diagram(draw, "L, its projection (N.L) N on the normal, S from L to the projection and on to R")


def halfway(light: float = 50.0, eye: float = 10.0) -> Plot:
    """H halfway between L and V, and R: the angle between N and H is half of that between R and V.

    light, eye: angles of L (to the left) and V (to the right of N if positive) from N, in degrees, in (-90, 90).

    Example: ``plots.halfway(light=50, eye=10)``
    """
    for angle in (light, eye):
        if not -90.0 < angle < 90.0:
            raise ValueError(f"plots.halfway: angles must be in (-90, 90) degrees, not {angle:g}")
    L, V = in_plane(-light), in_plane(eye)
    H, R = shading.halfway(L, V)[[0, 2]], shading.reflection(N, L)[[0, 2]]
    middle = (eye - light) / 2.0

    def draw(axes: Axes) -> None:
        _ground(axes)
        _arrow(axes, O, at(0, 1.2), INK, "$N$", (0, 9))
        _arrow(axes, O, L[[0, 2]], ORANGE, "$L$", (-10, 6))
        _arrow(axes, O, V[[0, 2]], GREEN, "$V$", (4, 10))
        _arrow(axes, O, R, BLUE, "$R$", (10, 4))
        _arrow(axes, O, H, PINK, "$H$", (-4, 10))
        _angle(axes, middle, 0, 0.62, f"{abs(middle):g}°", PINK)
        _angle(axes, eye, light, 0.45, f"{abs(light - eye):g}°", BLUE)
        axes.set_title(r"$H = (L + V)\,/\,|L + V|$")
        _room(axes, 1.5, (-0.2, 1.4))

    return diagram(draw, f"N, L, V, R and H; N and H are {abs(middle):g} degrees apart, R and V {abs(light - eye):g}")


def cosine_law(theta: Sequence[float] = (0, 40, 65)) -> Plot:
    """The proof of Lambert's cosine law: a beam as wide as w lights a footprint of w / cos(theta).

    theta: angles of incidence in degrees, each in [0, 80].

    Example: ``plots.cosine_law((0, 30, 60))``
    """
    angles = incidences("cosine_law", theta)
    if max(angles) > 80.0:
        raise ValueError(f"plots.cosine_law: angles must be in [0, 80] degrees, not {max(angles):g}")
    w = 0.5
    feet = [w / np.cos(np.radians(t)) for t in angles]
    gaps = [max(0.95, 0.3 + 1.25 * (np.sin(b) - np.cos(b) * np.tan(a))) for a, b in pairwise(np.radians(angles))]
    steps = [gap + (f + g) / 2.0 for gap, (f, g) in zip(gaps, pairwise(feet), strict=True)]
    middles = np.cumsum([feet[0] / 2.0, *steps])

    def draw(axes: Axes) -> None:
        left = min(-0.9, -0.3 - 1.25 * float(np.sin(np.radians(angles[0]))))
        right = float(middles[-1] + feet[-1] / 2.0 + 0.5)
        axes.fill_between([left, right], -0.16, 0.0, color=SURFACE, linewidth=0)
        axes.plot([left, right], [0, 0], color=INK, linewidth=2.0)
        for t, foot, x in zip(angles, feet, middles, strict=True):
            _beam(axes, float(x), t, w, foot)
        axes.set_title(r"The same light on a larger area: $E = I_L\,w / (w / \cos\theta) = I_L \cos\theta$")
        axes.set_xlim(left, right)
        axes.set_ylim(-0.62, 1.55)

    words = "beams of the same width; the more they are tilted, the larger the area that they light"
    return diagram(draw, f"{words}: {_list(angles)} degrees", (10.0, 4.4))


def _beam(axes: Axes, x: float, theta: float, w: float, foot: float) -> None:
    """A beam that comes from the upper left and is w wide, and the footprint that it lights."""
    towards = at(-theta, 1.25)
    left, right = np.array([x - foot / 2.0, 0.0]), np.array([x + foot / 2.0, 0.0])
    top_left, top_right = left + towards, right + towards
    along = at(-theta)
    shift = float((left - right) @ along)  # the beam's end is cut at a right angle
    top_right = top_right + along * shift
    axes.fill(*np.array([left, right, top_right, top_left]).T, color=ORANGE, alpha=0.28, linewidth=0)
    for k in np.linspace(0.0, 1.0, 5):
        start, end = top_left + k * (top_right - top_left), left + k * (right - left)
        _ray(axes, start, end, ORANGE, 1.4, 14)
    axes.plot(*np.array([top_left, top_right]).T, color=RED, linewidth=3.0, solid_capstyle="butt")
    across = (top_left + top_right) / 2.0 + along * 0.13
    _label(axes, across, "$w$", RED)
    axes.plot([left[0], right[0]], [0, 0], color=BLUE, linewidth=5.0, solid_capstyle="butt")
    share = np.cos(np.radians(theta))
    text = "$w$" if theta == 0.0 else r"$w / \cos\theta$"
    _label(axes, (x, -0.25), text, BLUE)
    _label(axes, (x, -0.46), rf"$\theta = {theta:g}°$: {100 * share:.0f} %", INK)


def nusselt(elevation: float = 50.0, size: float = 0.7, distance: float = 1.7) -> Plot:
    """Nusselt's analog in a plane: a patch, seen from a point, projected on the circle and then down on the base.

    elevation: angle of the patch's middle from the normal in degrees; size, distance: of the patch, in radii.
    The form factor is the share of the base circle that is covered.

    Example: ``plots.nusselt(elevation=30, size=0.7)``
    """
    elevation = incidence("nusselt", elevation)
    if not (0.0 < size < 2.0 and distance > 1.0):
        raise ValueError("plots.nusselt: the size must be in (0, 2) and the distance more than 1, in radii")
    middle, across = at(elevation, distance), at(elevation + 90.0, size / 2.0)
    ends = [middle - across, middle + across]
    on_circle = [end / np.linalg.norm(end) for end in ends]
    if min(end[1] for end in ends) <= 0.0:
        raise ValueError("plots.nusselt: the patch must be above the base: a smaller elevation or size is needed")

    def draw(axes: Axes) -> None:
        _ground(axes, 1.35)
        arc = np.radians(np.linspace(-90, 90, 181))
        axes.plot(np.sin(arc), np.cos(arc), color=FAINT, linewidth=1.6)
        for end, point in zip(ends, on_circle, strict=True):
            axes.plot(*np.array([O, end]).T, color=ORANGE, linewidth=1.4)
            axes.plot([point[0], point[0]], [0, point[1]], color=BLUE, linewidth=1.4, linestyle=(0, (4, 3)))
        axes.plot(*np.array(ends).T, color=RED, linewidth=6, solid_capstyle="butt")
        _label(axes, middle + at(elevation, 0.32), "patch $A_j$", RED)
        a, b = (float(np.arctan2(p[0], p[1])) for p in on_circle)
        part = np.linspace(a, b, 60)
        axes.plot(np.sin(part), np.cos(part), color=ORANGE, linewidth=6, solid_capstyle="butt")
        _label(axes, at(elevation - 30.0, 1.16), "solid angle", ORANGE)
        axes.plot([p[0] for p in on_circle], [0, 0], color=BLUE, linewidth=7, solid_capstyle="butt")
        _label(axes, (float(np.mean([p[0] for p in on_circle])), -0.16), "projected: the form factor", BLUE)
        _arrow(axes, O, at(0, 0.75), INK, "$N_i$", (-14, 0))
        axes.plot(0, 0, "o", color=INK, markersize=7)
        axes.set_title("Nusselt's analog: seen from a point, then projected down")
        _room(axes, 2.0, (-0.35, max(1.3, float(middle[1]) + 0.45)))

    return diagram(draw, "a patch projected on the unit circle about a point, and from there down on the base")


# ---------------------------------------------------------------- strokes


def _list(angles: Sequence[float]) -> str:
    return ", ".join(f"{angle:g}" for angle in angles)


def _ground(axes: Axes, half: float = 1.4) -> None:
    axes.fill_between([-half, half], -0.12, 0.0, color=SURFACE, linewidth=0)
    axes.plot([-half, half], [0, 0], color=INK, linewidth=2.0)


def _water(axes: Axes, denser_below: bool) -> None:
    low, high = (-1.5, 0.0) if denser_below else (0.0, 1.5)
    axes.fill_between([-1.9, 1.9], low, high, color="#dcebf5", linewidth=0)
    axes.plot([-1.9, 1.9], [0, 0], color=INK, linewidth=2.0)


def _medium(axes: Axes, side: float, name: str, index: float) -> None:
    text = f"$n = {index:g}$" if name.startswith("n =") else f"{name}, $n = {index:g}$"
    axes.text(1.84, 0.08 * side, text, ha="right", va="bottom" if side > 0 else "top", fontsize=12)


def _room(axes: Axes, half: float, y: tuple[float, float]) -> None:
    axes.set_xlim(-half, half)
    axes.set_ylim(*y)


def _label(axes: Axes, place: ArrayLike, text: str, color: str = INK, ha: str = "center") -> None:
    axes.text(*_place(place), text, color=color, ha=ha, va="center", fontsize=14)


def _arrow(
    axes: Axes, start: ArrayLike, end: ArrayLike, color: str, name: str = "", off: tuple[float, float] = (0, 0)
) -> None:
    """A vector from start to end, with its name beside the tip (off: points)."""
    style = {"arrowstyle": "-|>", "color": color, "lw": 2.6, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 18}
    axes.annotate("", _place(end), _place(start), arrowprops=style)
    if name:
        axes.annotate(name, _place(end), off, textcoords="offset points", color=color, ha="center", va="center",
                      fontsize=16)  # fmt: skip


def _ray(
    axes: Axes, start: ArrayLike, end: ArrayLike, color: str, width: float = 2.4, head: float = 24, alpha: float = 1.0
) -> None:
    """A ray of light, its head in the middle."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    axes.plot(*np.array([start, end]).T, color=color, linewidth=width, alpha=alpha)
    place = start + 0.55 * (end - start)
    style = {"arrowstyle": "-|>", "color": color, "lw": 0.1, "mutation_scale": head, "alpha": alpha}
    axes.annotate("", place + 0.02 * (end - start), place, arrowprops=style)


def _place(point: ArrayLike) -> tuple[float, float]:
    x, y = np.asarray(point, float)
    return float(x), float(y)


def _angle(axes: Axes, first: float, last: float, radius: float, text: str, color: str = INK) -> None:
    """An arc between two angles from the normal (degrees), and its name."""
    arc = np.radians(np.linspace(first, last, 60))
    axes.plot(radius * np.sin(arc), radius * np.cos(arc), color=color, linewidth=1.6)
    _label(axes, at((first + last) / 2.0, radius + 0.11), text, color)
