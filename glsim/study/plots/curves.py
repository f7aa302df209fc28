"""Functions of one variable: the factors of the illumination equation, and whatever a lesson wants to plot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from glsim import shading
from glsim.study.plots.style import FAINT, Plot, line_style, plot

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Float = NDArray[np.float64]
Curves = Mapping[str, tuple[ArrayLike, ArrayLike]]


def curves(
    series: Curves, xlabel: str = "", ylabel: str = "", *, title: str = "", log: bool = False, markers: bool = False,
    marks: Mapping[float, str] | None = None, xlim: tuple[float, float] | None = None,
    ylim: tuple[float, float | None] | None = None, alt: str = "",
) -> Plot:  # fmt: skip
    """Curves with a legend.

    series: label -> (x, y), arrays of one length; labels may hold TeX between dollars.  xlabel, ylabel: with the unit.
    log: the y axis is logarithmic.  markers: a dot at each point.  marks: x -> the name of a vertical line there.
    alt: in words what is seen; made of the labels if it is empty.  Raises ValueError for arrays of different lengths,
    or none at all.

    Example: ``plots.curves({"$x^2$": (x, x * x), "$x^3$": (x, x**3)}, "x", "y", marks={1.0: "equal"})``
    """
    if not series:
        raise ValueError("plots.curves: at least one curve is needed, as {label: (x, y)}")
    arrays = {label: tuple(np.asarray(part, float) for part in pair) for label, pair in series.items()}
    for label, pair in arrays.items():
        if len(pair) != 2 or pair[0].ndim != 1 or pair[0].shape != pair[1].shape:
            raise ValueError(f"plots.curves: {label!r} must be two lists of numbers of one length, (x, y)")

    def draw(axes: Axes) -> None:
        from matplotlib.ticker import MaxNLocator

        if log:
            axes.set_yscale("log")
        for number, (label, (x, y)) in enumerate(arrays.items()):
            axes.plot(x, y, label=label, marker="o" if markers else None, markersize=5, **line_style(number))
        for place, name in (marks or {}).items():
            axes.axvline(place, color=FAINT, linewidth=1.2, linestyle=(0, (3, 3)), zorder=1)
            axes.annotate(name, (place, 1.0), (4, -4), xycoords=("data", "axes fraction"), textcoords="offset points",
                          va="top", color=FAINT, fontsize=11)  # fmt: skip
        axes.set(xlabel=xlabel, ylabel=ylabel, title=title)
        if all((x == np.rint(x)).all() for x, _ in arrays.values()):
            axes.xaxis.set_major_locator(MaxNLocator(integer=True))
        if xlim is not None:
            axes.set_xlim(*xlim)
        if ylim is not None:
            axes.set_ylim(*ylim)
        if len(arrays) > 1 or next(iter(arrays)):
            axes.legend(loc="best")

    of = f"{ylabel or 'y'} over {xlabel or 'x'}"
    return plot(draw, alt or f"{title or 'curves'}: {of}: {', '.join(arrays)}")


def _degrees(last: float = 90.0, first: float = 0.0) -> tuple[Float, Float]:
    angle = np.linspace(first, last, 721)
    return angle, np.cos(np.radians(angle))


def in_plane(degrees: ArrayLike) -> Float:
    """Unit vectors (..., 3) in the plane of x and z, at an angle from N = z; positive angles lean towards x."""
    angle = np.radians(np.asarray(degrees, float))
    return np.stack([np.sin(angle), np.zeros_like(angle), np.cos(angle)], axis=-1)


N = np.array([0.0, 0.0, 1.0])
THETA = r"angle $\theta$ between $N$ and $L$ (degrees)"


def lambert() -> Plot:
    """Lambert's law: cos(theta) = N.L, and what clamping makes of it where the light is behind the surface.

    Example: ``plots.lambert().save("lambert.svg")``
    """
    angle, cosine = _degrees(180.0)
    series = {r"$\max(N \cdot L,\ 0)$": (angle, shading.lambert(N, in_plane(angle))[:, 0]),
              r"$\cos\theta$ without clamping": (angle, cosine)}  # fmt: skip
    return curves(
        series,
        THETA,
        "share of the light",
        title="Lambert's cosine law",
        marks={90.0: "grazing light"},
        xlim=(0, 180),
        alt="cos theta falls from 1 at 0 degrees to 0 at 90; beyond it is clamped to 0",
    )


def powers(n: Sequence[float] = (1, 5, 20, 100)) -> Plot:
    """cos^n(phi) for several n: the larger the shininess, the narrower the highlight.

    Example: ``plots.powers((1, 10, 100))``
    """
    angle, cosine = _degrees(90.0, -90.0)
    series = {f"$n = {k:g}$": (angle, shading.power(cosine, k)) for k in n}
    return curves(
        series,
        r"angle $\varphi$ between $R$ and $V$ (degrees)",
        r"$\cos^n \varphi$",
        xlim=(-90, 90),
        title="Shininess: the power of the cosine",
        alt=f"bell curves of cos^n phi for n = {', '.join(f'{k:g}' for k in n)}: the larger n, the narrower",
    )


def highlights(theta: float = 45.0, n: float = 20.0, four_times: bool = True) -> Plot:
    """(R.V)^n beside (N.H)^n while the eye moves through the plane of incidence.

    theta: angle of incidence in degrees, in [0, 90); n: shininess; four_times: (N.H)^(4 n) too, which near R is almost
    Phong's highlight, because there the angle between N and H is half of that between R and V.

    Example: ``plots.highlights(theta=30, n=50)``
    """
    angle, _ = _degrees(90.0, -90.0)
    L, V = in_plane(-incidence("highlights", theta)), in_plane(angle)
    series = {
        f"Phong: $(R \\cdot V)^{{{n:g}}}$": (angle, shading.phong_specular(N, L, V, n)[:, 0]),
        f"Blinn: $(N \\cdot H)^{{{n:g}}}$": (angle, shading.blinn_torrance_specular(N, L, V, n)[:, 0]),
    }
    if four_times:
        both = shading.blinn_torrance_specular(N, L, V, 4.0 * n)[:, 0]
        series[f"Blinn with $4n$: $(N \\cdot H)^{{{4 * n:g}}}$"] = (angle, both)
    return curves(
        series,
        r"angle between $N$ and $V$ (degrees), light from the left",
        "highlight",
        xlim=(-90, 90),
        title=rf"Two highlights, $\theta = {theta:g}°$",
        marks={-theta: "L", theta: "R"},
        alt=f"both highlights are largest at V = R, {theta:g} degrees; (N.H)^n is wider than (R.V)^n",
    )


def attenuation(factors: Sequence[tuple[float, float, float]] = ((1, 0, 0), (1, 1, 0), (1, 0, 1), (0, 0, 1)),
                farthest: float = 5.0) -> Plot:  # fmt: skip
    """1 / (a + b d + c d^2) over the distance.  factors: (a, b, c) of each curve, as glLight takes them.

    Example: ``plots.attenuation(((1, 0, 0), (1, 0.5, 0), (1, 0, 0.5)), farthest=8)``
    """
    d = np.linspace(farthest / 500.0, farthest, 500)
    series = {_one_over((a, b, c)): (d, shading.attenuation(d, a, b, c)) for a, b, c in factors}
    return curves(series, "distance $d$ from the light (units of the scene)", r"$1 / (a + b\,d + c\,d^2)$",
                  xlim=(0, farthest), ylim=(0, 1.3), title="Attenuation",
                  alt="the share of the light that arrives over the distance, for several attenuations")  # fmt: skip


def _one_over(factors: tuple[float, float, float]) -> str:
    """1 / (a + b d + c d^2) as TeX, without the parts that are 0."""
    parts = [f"{k:g}" if not unit else unit if k == 1 else f"{k:g}\\,{unit}"
             for k, unit in zip(factors, ("", "d", "d^2"), strict=True) if k]  # fmt: skip
    if not parts:
        raise ValueError("plots.attenuation: one of the three factors must be more than 0")
    return f"$1 / ({' + '.join(parts)})$" if len(parts) > 1 else "$1$" if parts == ["1"] else f"$1 / {parts[0]}$"


def spot(exponents: Sequence[float] = (0, 1, 8, 64), cutoff: float = 30.0) -> Plot:
    """The spotlight factor cos^e inside of the cone.  exponents: of GL_SPOT_EXPONENT; cutoff: in degrees.

    Example: ``plots.spot((0, 4, 32), cutoff=25)``
    """
    angle, _ = _degrees(60.0 if cutoff < 60.0 else 90.0, -60.0 if cutoff < 60.0 else -90.0)
    L = -in_plane(angle)
    series = {f"$e = {e:g}$": (angle, shading.spotlight(L, N, cutoff, e)[:, 0]) for e in exponents}
    return curves(
        series,
        "angle from the spot's direction (degrees)",
        r"$\cos^e$ inside of the cone, else 0",
        title=f"Spotlight with a cutoff of {cutoff:g}°",
        marks={-cutoff: "", cutoff: "cutoff"},
        alt=f"the spotlight factor is 0 beyond {cutoff:g} degrees; the larger the exponent, the narrower",
    )


# Refractive indices n + i k near 580 nm: gold and silver from Johnson & Christy, Optical constants of the noble metals
# (1972), at 582 nm
MEDIA: dict[str, complex] = {
    "air": 1.0, "water": 1.333, "glass": 1.5, "diamond": 2.417, "gold": 0.29 + 2.863j, "silver": 0.05 + 3.858j,
}  # fmt: skip


def medium(index: str | complex) -> tuple[str, complex]:
    """A medium's name and refractive index.  index: a name of MEDIA, or a number.  Raises ValueError for others."""
    if isinstance(index, str):
        if index not in MEDIA:
            raise ValueError(f"plots: the media are {', '.join(MEDIA)}, not {index!r}; a refractive index will do, too")
        return index, MEDIA[index]
    if not complex(index).real > 0.0:
        raise ValueError(f"plots: a refractive index must be more than 0, not {index}")
    return f"n = {index:g}", index


def fresnel(
    media: Sequence[str | complex] = ("water", "glass", "diamond", "gold", "silver"), *, inside: str | complex = "air",
    polarised: bool = False,
) -> Plot:  # fmt: skip
    """Fresnel: the share of the light that a smooth boundary reflects, over the angle of incidence.

    media: behind the boundary: names of MEDIA or refractive indices, n + 1j k for metals.  inside: where the light
    comes from.  polarised: the two polarisations as well, s (across the plane of incidence) and p (in it).

    Example: ``plots.fresnel(("glass", 1.8, "gold"), polarised=True)``
    """
    angle, cosine = _degrees()
    _, n_1 = medium(inside)
    series: dict[str, tuple[ArrayLike, ArrayLike]] = {}
    marks: dict[float, str] = {}
    for name, n_2 in map(medium, media):
        s, p = polarised_shares(cosine, n_1, n_2)
        series[name] = (angle, (s + p) / 2.0)
        if polarised:
            series[f"{name}, s"], series[f"{name}, p"] = (angle, s), (angle, p)
            if not complex(n_2).imag:
                marks[float(np.degrees(np.arctan2(complex(n_2).real, complex(n_1).real)))] = f"Brewster, {name}"
    return curves(
        series,
        r"angle of incidence $\theta$ (degrees)",
        "reflected share $F$",
        xlim=(0, 90),
        ylim=(0, 1.03),
        title="Fresnel reflectance" + ("" if inside == "air" else f", from {medium(inside)[0]}"),
        marks=marks,
        alt=f"reflectance over the angle for {', '.join(series)}: at grazing incidence all reaches 1",
    )


def polarised_shares(cosine: ArrayLike, n_1: complex, n_2: complex) -> tuple[Float, Float]:
    """Fresnel's reflectances (s, p) of a boundary, also of metals: n_2 = n + 1j k.  (Born & Wolf, Optics, section 14.2)

    cosine: of the angle of incidence, in [0, 1].  For two real indices (s + p) / 2 is shading.fresnel.
    """
    cos_1 = np.asarray(cosine, complex)
    cos_2 = np.sqrt(1.0 - (n_1 / n_2) ** 2 * (1.0 - cos_1 * cos_1))
    with np.errstate(invalid="ignore"):
        s = (n_1 * cos_1 - n_2 * cos_2) / (n_1 * cos_1 + n_2 * cos_2)
        p = (n_2 * cos_1 - n_1 * cos_2) / (n_2 * cos_1 + n_1 * cos_2)
    s, p = (np.minimum(np.abs(np.nan_to_num(share)) ** 2, 1.0) for share in (s, p))
    return s, p


def snell(
    pairs: Sequence[tuple[str | float, str | float]] = (("air", "water"), ("air", "glass"), ("glass", "air")),
) -> Plot:
    """Snell: the angle of refraction over the angle of incidence.  pairs: (from, into), names of MEDIA or indices.

    Example: ``plots.snell((("air", "diamond"), ("water", "air")))``
    """
    angle, _ = _degrees(89.999)
    series, marks = {}, {}
    for first, second in pairs:
        (name_1, n_1), (name_2, n_2) = medium(first), medium(second)
        bent = shading.refraction(N, in_plane(angle), complex(n_1).real, complex(n_2).real)
        series[f"{name_1} into {name_2}"] = (angle, np.degrees(np.arccos(-bent[:, 2])))
        if complex(n_2).real < complex(n_1).real:
            critical = float(np.degrees(np.arcsin(complex(n_2).real / complex(n_1).real)))
            marks[critical] = f"total reflection from {critical:.1f}°"
    return curves(series, r"angle of incidence $\theta_1$ (degrees)", r"angle of refraction $\theta_2$ (degrees)",
                  title=r"Snell: $n_1 \sin\theta_1 = n_2 \sin\theta_2$", xlim=(0, 90), ylim=(0, 91), marks=marks,
                  alt=f"angle of refraction over angle of incidence: {', '.join(series)}")  # fmt: skip


def fog(density: float = 0.35, start: float = 1.0, end: float = 6.0, farthest: float = 8.0) -> Plot:
    """OpenGL's three fog factors f over the distance: f C + (1 - f) C_fog.

    Example: ``plots.fog(density=0.2, start=2, end=10, farthest=12)``
    """
    from glsim.machine import constants as gl
    from glsim.machine.state import Fog
    from glsim.study.fragments import fog_factor

    z = np.linspace(0.0, farthest, 401)
    modes = {f"GL_LINEAR, from {start:g} to {end:g}": gl.GL_LINEAR, f"GL_EXP, density {density:g}": gl.GL_EXP,
             f"GL_EXP2, density {density:g}": gl.GL_EXP2}  # fmt: skip
    series = {
        name: (z, [fog_factor(Fog(mode=mode, density=density, start=start, end=end), float(d)) for d in z])
        for name, mode in modes.items()
    }
    return curves(
        series,
        "distance from the eye (units of the scene)",
        "share $f$ of the fragment's own colour",
        title="Fog",
        xlim=(0, farthest),
        ylim=(0, 1.05),
        alt="three fog factors that fall with the distance",
    )


def interpolation(depths: tuple[float, float] = (1.0, 5.0)) -> Plot:
    """Hyperbolic against affine: where on an edge that goes away from the eye a pixel on the screen is.

    depths: distances of the two ends from the eye (w of clip space), more than 0.  Half-way on the screen is not
    half-way on the edge:  t = (s / w_2) / ((1 - s) / w_1 + s / w_2).

    Example: ``plots.interpolation((1, 20))``
    """
    w_1, w_2 = depths
    if not (w_1 > 0.0 and w_2 > 0.0):
        raise ValueError(f"plots.interpolation: both distances must be more than 0, not {w_1:g} and {w_2:g}")
    s = np.linspace(0.0, 1.0, 401)
    t = s / w_2 / ((1.0 - s) / w_1 + s / w_2)
    series = {"hyperbolic: perspective-correct": (s, t), "affine: linear on the screen": (s, s)}
    return curves(
        series,
        "place $s$ between the ends on the screen",
        "place $t$ between the ends on the edge",
        title=f"An edge from distance {w_1:g} to {w_2:g}",
        marks={0.5: ""},
        xlim=(0, 1),
        ylim=(0, 1),
        alt=f"in the middle of the screen the edge is only at {t[200]:.2f} of its length, not at 0.5",
    )


def form_factor_distance(farthest: float = 5.0) -> Plot:
    """Form factors of two parallel unit squares that face each other, over the distance: exact and approximate.

    Example: ``plots.form_factor_distance(farthest=3)``
    """
    d = np.linspace(0.05, farthest, 400)
    far = np.where(d > 0.5, 1.0 / (np.pi * d * d), np.nan)
    series: Curves = {
        "two unit squares, exact": (d, parallel_squares(d)),
        "middle of one to the other, exact": (d, [point_to_square(x, 0.0) for x in d]),
        r"small patches: $A\,\cos\theta_i\,\cos\theta_j / (\pi r^2)$": (d, far),
    }  # fmt: skip
    return curves(
        series,
        "distance (side lengths)",
        "form factor $F$",
        title="Form factor and distance",
        xlim=(0, farthest),
        ylim=(0, 1.03),
        alt="form factors fall with the distance; far away with its square, near they approach 1",
    )


def form_factor_angle(distance: float = 2.0) -> Plot:
    """The form factor from a point to a unit square at a distance (side lengths) that turns round its middle.

    Example: ``plots.form_factor_angle(distance=1)``
    """
    if not distance > 0.5:
        raise ValueError(f"plots.form_factor_angle: the distance must be more than half a side, not {distance:g}")
    angle, cosine = _degrees()
    series: Curves = {"exact": (angle, [point_to_square(distance, a) for a in angle]),
              r"$A\,\cos\theta_j / (\pi r^2)$": (angle, cosine / (np.pi * distance**2))}  # fmt: skip
    return curves(
        series,
        r"angle $\theta_j$ by which the square is turned away (degrees)",
        "form factor $F$",
        title=f"Form factor and angle, {distance:g} side lengths away",
        xlim=(0, 90),
        ylim=(0, None),
        alt="the form factor falls like the cosine of the angle by which the square is turned away",
    )


def parallel_squares(d: ArrayLike) -> Float:
    """The form factor of two parallel unit squares, straight opposite, at distance d > 0.  (Howell, catalogue, C-11)"""
    x = 1.0 / np.asarray(d, float)
    root = np.sqrt(1.0 + x * x)
    parts = 0.5 * np.log((1.0 + x * x) ** 2 / (1.0 + 2.0 * x * x)) + 2.0 * x * root * np.arctan(x / root)
    return np.asarray(2.0 / (np.pi * x * x) * (parts - 2.0 * x * np.arctan(x)))


def point_to_square(distance: float, degrees: float) -> float:
    """The form factor from a point with normal z to a unit square over it, turned by an angle in [0, 90] about x.

    Lambert's sum over the edges (1760): 1 / (2 pi) sum of angle_k N . unit(r_k x r_k+1).
    """
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    r = np.array([(x, y * c, distance + y * s) for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5))])
    after = np.roll(r, -1, axis=0)
    cross = np.cross(r, after)
    length = np.linalg.norm(cross, axis=1)
    angle = np.arctan2(length, np.sum(r * after, axis=1))
    return float(np.sum(angle * cross[:, 2] / length) / (2.0 * np.pi))


def residuals(results: Any) -> Plot:
    """How the residual of radiosity solvers falls, logarithmically.

    results: a Radiosity, or label -> Radiosity or list of SolverStep.

    Example: ``plots.residuals({name: radiosity.solve("goral", 60, solver=name) for name in ("jacobi", "cg")})``
    """
    named = results if isinstance(results, Mapping) else {results.solver: results}
    steps: dict[str, Any] = {label: getattr(result, "steps", result) for label, result in named.items()}
    series = {
        label: ([step.iteration for step in of], [max(step.residual, 1e-17) for step in of])
        for label, of in steps.items()
    }
    few = max(len(of) for of in steps.values()) <= 60
    return curves(series, "iteration", "residual, relative to $E$", title="Convergence", log=True, markers=few,
                  alt=f"the residual over the iterations on a logarithmic scale: {', '.join(series)}")  # fmt: skip


def incidence(call: str, theta: float) -> float:
    if not 0.0 <= theta < 90.0:
        raise ValueError(f"plots.{call}: the angle of incidence must be in [0, 90) degrees, not {theta:g}")
    return float(theta)


def incidences(call: str, theta: float | Sequence[float]) -> list[float]:
    """One angle of incidence, or several.  Raises ValueError for none."""
    angles = [theta] if isinstance(theta, int | float) else list(theta)
    if not angles:
        raise ValueError(f"plots.{call}: at least one angle is needed")
    return [incidence(call, angle) for angle in angles]
