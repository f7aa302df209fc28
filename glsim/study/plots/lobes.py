"""Polar pictures: how much of the light leaves in which direction."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim import shading
from glsim.study.plots.curves import N, in_plane, incidences
from glsim.study.plots.style import FAINT, INK, SURFACE, Plot, diagram, line_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Float = NDArray[np.float64]
Term = Callable[[Any, Any, Any], Any]  # (N, L, V) -> (..., channels)


def phong_term(k_d: float = 0.3, k_s: float = 0.7, n: float = 20.0) -> Term:
    """The lecture's k_d (N.L) + k_s (R.V)^n as a function of N, L and V, for ``lobes``."""
    return lambda N, L, V: k_d * shading.lambert(N, L) + k_s * shading.phong_specular(N, L, V, n)


def blinn_term(k_d: float = 0.3, k_s: float = 0.7, n: float = 20.0) -> Term:
    """The lecture's k_d (N.L) + k_s (N.H)^n as a function of N, L and V, for ``lobes``."""
    return lambda N, L, V: k_d * shading.lambert(N, L) + k_s * shading.blinn_torrance_specular(N, L, V, n)


def lobes(
    models: Mapping[str, shading.BRDF | Term], theta: float | Sequence[float] = 45.0, *, cosine: bool = False,
    largest: float | None = None, title: str = "",
) -> Plot:  # fmt: skip
    """Lobes in the plane of incidence: the distance from the middle is what leaves in that direction.

    models: label -> a BRDF of glsim.shading, of which f (1/sr) is drawn, or a function of N, L, V such as phong_term,
    of which I is drawn.  theta: angle of incidence in degrees, or several.  cosine: multiply a BRDF by N.L, so that it
    is comparable with terms.  largest: of the scale; what is larger is cut off.

    Example: ``plots.lobes({"Phong": plots.phong_term(n=20), "Blinn": plots.blinn_term(n=20)}, theta=40)``
    """
    if not models:
        raise ValueError("plots.lobes: at least one model is needed, as {label: BRDF}")
    thetas = incidences("lobes", theta)
    angle = np.linspace(-90.0, 90.0, 1441)
    lines: list[tuple[str, Float]] = []
    for label, model in models.items():
        for t in thetas:
            words = f"{label}, $\\theta = {t:g}°$" if len(thetas) > 1 else label
            lines.append((words, _radius(model, t, angle, cosine)))
    radius = largest or 1.12 * max(float(np.nanmax(values)) for _, values in lines) or 1.0

    def draw(axes: Axes) -> None:
        _half_disc(axes, radius)
        for number, (label, values) in enumerate(lines):
            style = line_style(number)
            x, y = polar(angle, np.minimum(values, radius))
            axes.plot(x, y, label=label, **style)
            axes.fill(x, y, color=style["color"], alpha=0.10, linewidth=0)
        for t in thetas:
            _rays(axes, t, radius)
        axes.set_title(title or "Where the light goes")
        columns = min(3, len(lines)) if len(lines) != 4 else 2
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, 0.04), ncols=columns, columnspacing=1.4)

    many = ", ".join(f"{t:g}" for t in thetas)
    alt = f"polar lobes in the plane of incidence for light from {many} degrees: {', '.join(models)}"
    return diagram(draw, alt, (7.6, 5.0))


def polar(degrees: ArrayLike, radius: ArrayLike) -> Float:
    """Points (2, ...) at angles from the normal, which points up; positive angles lean to the right."""
    angle = np.radians(np.asarray(degrees, float))
    length = np.asarray(radius, float)
    return np.stack([length * np.sin(angle), length * np.cos(angle)])


def _radius(model: Any, theta: float, angle: Float, cosine: bool) -> Float:
    """f or I towards all angles, (n,), the mean of the channels."""
    L, V = in_plane(-theta), in_plane(angle)
    L = np.broadcast_to(L, V.shape)
    if isinstance(model, shading.BRDF):
        values = model.evaluate(N, L, V) * (shading.lambert(N, L) if cosine else 1.0)
    else:
        values = model(N, L, V)
    return np.asarray(np.mean(np.broadcast_to(values, (len(V), np.shape(values)[-1])), axis=-1))


def _half_disc(axes: Axes, radius: float) -> None:
    """The scale: half circles with their values, and rays with their angles."""
    from matplotlib.ticker import MaxNLocator

    arc = np.linspace(-90.0, 90.0, 181)
    axes.fill_between([-1.08 * radius, 1.08 * radius], -0.03 * radius, 0.0, color=SURFACE, linewidth=0)
    for value in MaxNLocator(4).tick_values(0.0, radius):
        if 0.0 < value < 0.98 * radius:
            axes.plot(*polar(arc, value), color="#dcdcd7", linewidth=1.0, zorder=0)
            for side in (-1.0, 1.0):
                axes.text(side * value, -0.05 * radius, f"{value:g}", ha="center", va="top", fontsize=11, color=FAINT)
    axes.plot(*polar(arc, radius), color=FAINT, linewidth=1.0)
    for degrees in range(-90, 91, 30):
        axes.plot(*polar(degrees, [0.0, radius]), color="#e6e6e1", linewidth=1.0, zorder=0)
        x, y = polar(degrees if abs(degrees) < 90 else 0.95 * degrees, 1.07 * radius)
        axes.text(x, y, f"{abs(degrees)}°", ha="center", va="center", fontsize=11, color=FAINT)
    axes.plot([-1.08 * radius, 1.08 * radius], [0, 0], color=INK, linewidth=2.0)
    axes.set_xlim(-1.16 * radius, 1.16 * radius)
    axes.set_ylim(-0.16 * radius, 1.16 * radius)


def _rays(axes: Axes, theta: float, radius: float) -> None:
    """The light from the left, and the mirrored direction R to the right."""
    (x_1, y_1), (x_2, y_2) = polar(-theta, radius), polar(-theta, 0.03 * radius)
    axes.annotate(
        "", (x_2, y_2), (x_1, y_1), arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 2.2, "mutation_scale": 18}
    )
    axes.plot(*polar(theta, [0.0, radius]), color=FAINT, linewidth=1.2, linestyle=(0, (3, 3)), zorder=1)
    for name, degrees in (("L", -theta - 5.0), ("R", theta + 5.0)):
        x, y = polar(degrees, 0.92 * radius)
        axes.text(x, y, f"${name}$", ha="center", va="center", fontsize=15)
