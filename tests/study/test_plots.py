"""glsim.plots: the curves are the functions they say, and what cannot be plotted is said in a sentence."""

from __future__ import annotations

import builtins
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from glsim import plots, radiosity, shading
from glsim.study.plots.curves import parallel_squares, point_to_square, polarised_shares
from glsim.study.plots.lobes import polar

N = np.array([0.0, 0.0, 1.0])


def lines(plot: plots.Plot) -> dict[str, Any]:
    """label -> (x, y) of each curve in the legend."""
    return {line.get_label(): line.get_data() for line in plot.figure.axes[0].lines if line.get_label()[0] != "_"}


ALL: dict[str, Callable[[], plots.Plot]] = {
    "attenuation": plots.attenuation, "fog": plots.fog, "form_factor_angle": plots.form_factor_angle,
    "form_factor_distance": plots.form_factor_distance, "fresnel": lambda: plots.fresnel(polarised=True),
    "highlights": plots.highlights, "interpolation": plots.interpolation, "lambert": plots.lambert,
    "powers": plots.powers, "snell": plots.snell, "spot": plots.spot, "computing_r": plots.computing_r,
    "cosine_law": plots.cosine_law, "halfway": plots.halfway, "nusselt": plots.nusselt,
    "reflection": plots.reflection, "refraction": plots.refraction,
    "lobes": lambda: plots.lobes({"Phong": plots.phong_term(), "Lambert": shading.Lambertian(0.8)}),
    "matrix": lambda: plots.matrix([[0.0, 0.5], [0.25, 0.0]], ["floor", "wall"]),
    "system": lambda: plots.system_of([1, 0], [[1, -0.25], [-0.1, 1]], [1.2, 0.3]),
}  # fmt: skip


@pytest.mark.slow
def test_every_plot_draws_within_its_axes_and_says_what_it_is(tmp_path: Path) -> None:
    for name, make in ALL.items():
        plot = make()
        image = np.asarray(plot.image(40.0))
        share = float((image < 200).any(axis=2).mean())
        assert 0.005 < share < 0.9, name
        assert len(plot.alt) > 20, name
        assert plot.alt in repr(plot)
        plot.save(tmp_path / f"{name}.svg")
        assert (tmp_path / f"{name}.svg").read_text().endswith("</svg>\n"), name


@pytest.mark.parametrize(
    "name", ["matrix", *(pytest.param(name, marks=pytest.mark.slow) for name in ("form_factor_distance", "lobes"))]
)
def test_an_svg_is_the_same_each_time_and_its_clips_are_its_own(name: str) -> None:
    svg = ALL[name]().svg()
    assert svg == ALL[name]().svg()
    named = set(re.findall(r'<clipPath id="([\w-]+)"', svg))
    assert set(re.findall(r"url\(#([\w-]+)\)", svg)) == named
    assert not named & set(re.findall(r'<clipPath id="([\w-]+)"', plots.lambert().svg()))


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in dir(plots) if callable(getattr(plots, name)) and name[0].islower()])
def test_examples_of_the_docstrings(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    example = re.search(r"Example: ``(.*)``", getattr(plots, name).__doc__)
    if example is None:
        assert name.endswith("_term")  # made for lobes, in whose example they are
        return
    monkeypatch.chdir(tmp_path)
    plot = eval(example[1], {"plots": plots, "radiosity": radiosity, "x": np.linspace(0.0, 2.0)})
    assert plot is None or plot.svg().endswith("</svg>\n")


def test_curves_are_the_functions() -> None:
    angle, clamped = lines(plots.lambert())[r"$\max(N \cdot L,\ 0)$"]
    np.testing.assert_allclose(clamped, np.maximum(np.cos(np.radians(angle)), 0.0), atol=1e-12)
    phi, y = lines(plots.powers((7,)))["$n = 7$"]
    np.testing.assert_allclose(y, np.cos(np.radians(phi)) ** 7, atol=1e-12)
    d, y = lines(plots.attenuation(((1, 2, 3),)))[r"$1 / (1 + 2\,d + 3\,d^2)$"]
    np.testing.assert_allclose(y, 1.0 / (1.0 + 2.0 * d + 3.0 * d * d), atol=1e-12)
    off, y = lines(plots.spot((3,), 20.0))["$e = 3$"]
    inside = np.abs(off) < 19.99
    np.testing.assert_allclose(y[inside], np.cos(np.radians(off[inside])) ** 3, atol=1e-12)
    assert not y[np.abs(off) > 20.01].any()
    z, y = lines(plots.fog(density=0.5))["GL_EXP2, density 0.5"]
    np.testing.assert_allclose(y, np.exp(-((0.5 * z) ** 2)), atol=1e-12)


def test_highlights_are_largest_at_r_and_four_times_n_is_nearly_phong() -> None:
    drawn = lines(plots.highlights(30.0, 10.0))
    assert len(drawn) == 3
    (angle, phong), (_, blinn), (_, four) = drawn.values()
    np.testing.assert_allclose(phong, np.maximum(np.cos(np.radians(angle - 30.0)), 0.0) ** 10, atol=1e-9)
    np.testing.assert_allclose(blinn, np.cos(np.radians((angle - 30.0) / 2.0)) ** 10, atol=1e-9)
    assert abs(angle[np.argmax(blinn)] - 30.0) < 0.2
    assert np.abs(four - phong).max() < 0.03


def test_fresnel_and_snell_are_those_of_shading_and_of_the_books() -> None:
    angle, glass = lines(plots.fresnel(("glass",)))["glass"]
    cosine = np.cos(np.radians(angle))
    np.testing.assert_allclose(glass, np.ravel(shading.fresnel(cosine, 1.0, 1.5)), atol=1e-9)
    assert abs(glass[0] - 0.04) < 1e-12
    s, p = polarised_shares(np.cos(np.arctan(1.5)), 1.0, 1.5)
    assert float(p) < 1e-20 < float(s)  # Brewster's angle: only s is reflected
    n = plots.MEDIA["gold"]
    assert abs(polarised_shares(1.0, 1.0, n)[0] - abs((n - 1.0) / (n + 1.0)) ** 2) < 1e-12
    total = polarised_shares(np.cos(np.radians([45.0, 60.0])), 1.5, 1.0)
    np.testing.assert_allclose(total, 1.0, atol=1e-12)
    angle, bent = lines(plots.snell((("air", "water"),)))["air into water"]
    np.testing.assert_allclose(np.sin(np.radians(angle)), 1.333 * np.sin(np.radians(bent)), atol=1e-9)


def test_form_factor_curves_against_closed_forms() -> None:
    d = np.array([0.5, 1.0, 3.0])
    # the middle of a unit square over it: Howell's catalogue, B-4, four quarters
    a = 0.5 / d
    quarter = 2.0 * a / np.sqrt(1 + a * a) * np.arctan(a / np.sqrt(1 + a * a)) / (2.0 * np.pi)
    np.testing.assert_allclose([point_to_square(x, 0.0) for x in d], 4.0 * quarter, atol=1e-12)
    assert abs(parallel_squares(1.0) - 0.199825) < 1e-6  # two opposite faces of a cube
    far = float(parallel_squares(50.0))
    assert abs(far * np.pi * 50.0**2 - 1.0) < 1e-3
    # turned by 40 degrees: integrated over 300 x 300 parts of the square
    u = (np.arange(300) + 0.5) / 300 - 0.5
    x, v = np.meshgrid(u, u)
    c, s = np.cos(np.radians(40.0)), np.sin(np.radians(40.0))
    r = np.stack([x, v * c, 2.0 + v * s], axis=-1)
    r2 = (r * r).sum(axis=-1)
    cos_j = np.abs(r @ np.array([0.0, -s, c])) / np.sqrt(r2)
    F = (r[..., 2] / np.sqrt(r2) * cos_j / (np.pi * r2)).mean()
    assert abs(point_to_square(2.0, 40.0) - F) < 1e-6


def test_interpolation_is_hyperbolic() -> None:
    s, t = lines(plots.interpolation((2.0, 6.0)))["hyperbolic: perspective-correct"]
    # the point of the edge whose projection is at s: (1 - t) x_1 + t x_2 over (1 - t) w_1 + t w_2, with x / w = 0 and 1
    np.testing.assert_allclose(t * 6.0 / ((1.0 - t) * 2.0 + t * 6.0), s, atol=1e-12)


@pytest.mark.parametrize("theta", [0.0, 45.0, 70.0])
def test_lobe_radii_are_what_shading_says(theta: float) -> None:
    brdf = shading.BlinnPhong(k_s=0.4, n=12.0)
    drawn = lines(plots.lobes({"term": plots.phong_term(0.2, 0.6, 9.0), "brdf": brdf}, theta, largest=50.0))
    angle = np.linspace(-90.0, 90.0, 1441)
    for name, (x, y) in drawn.items():
        radius = np.hypot(x, y)
        np.testing.assert_allclose(np.stack([x, y]), polar(angle, radius), atol=1e-9)
        for k in (100, 700, 720, 1100, 1400):
            a, b = np.radians(angle[k]), np.radians(theta)
            V, L = np.array([np.sin(a), 0.0, np.cos(a)]), np.array([-np.sin(b), 0.0, np.cos(b)])
            if name == "term":
                expected = 0.2 * np.cos(b) + 0.6 * max(np.cos(a - b), 0.0) ** 9
            else:
                expected = float(np.mean(brdf.evaluate(N, L, V)))
            assert abs(radius[k] - expected) < 1e-9, (name, angle[k])


def test_rays_of_lobes_lie_at_their_angles() -> None:
    figure = plots.lobes({"term": plots.phong_term()}, 30.0).figure
    ends = [np.stack(line.get_data())[:, -1] for line in figure.axes[0].lines if len(line.get_xdata()) == 2]
    angles = [float(np.degrees(np.arctan2(x, y))) for x, y in ends if abs(y) > 1e-9]
    assert sum(abs(angle - 30.0) < 1e-6 for angle in angles) == 2  # of the scale, and R


def test_matrix_shows_its_numbers_with_row_0_on_top() -> None:
    axes = plots.matrix([[0.0, 0.5, 1.0], [0.25, 0.0, 0.125]], title="F").figure.axes[0]
    texts = {(t.get_position()[0], t.get_position()[1]): t.get_text() for t in axes.texts}
    assert texts[1.5, 0.5] == "0.50"
    assert texts[2.5, 1.5] == "0.12"
    assert axes.yaxis_inverted()
    np.testing.assert_allclose(axes.images[0].get_array(), [[0.0, 0.5, 1.0], [0.25, 0.0, 0.125]])
    assert not plots.matrix(np.eye(20)).figure.axes[0].texts


def test_residuals_of_steps() -> None:
    class Step:
        def __init__(self, iteration: int, residual: float) -> None:
            self.iteration, self.residual = iteration, residual

    plot = plots.residuals({"jacobi": [Step(0, 1.0), Step(1, 0.1)], "shooting": [Step(0, 1.0), Step(1, 0.5)]})
    assert plot.figure.axes[0].get_yscale() == "log"
    np.testing.assert_allclose(lines(plot)["jacobi"], [[0, 1], [1.0, 0.1]])


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: plots.curves({}), "at least one curve"),
        (lambda: plots.curves({"a": ([1, 2], [1])}), "'a' must be two lists of numbers of one length"),
        (lambda: plots.highlights(90.0), r"highlights: the angle of incidence must be in \[0, 90\) degrees, not 90"),
        (lambda: plots.attenuation(((0, 0, 0),)), "one of the three factors"),
        (lambda: plots.fresnel(("gas",)), "the media are air, water, .*, not 'gas'"),
        (lambda: plots.snell(((1.0, -1.0),)), "must be more than 0"),
        (lambda: plots.interpolation((1.0, 0.0)), "both distances must be more than 0"),
        (lambda: plots.form_factor_angle(0.4), "more than half a side"),
        (lambda: plots.cosine_law((0, 85)), r"in \[0, 80\] degrees, not 85"),
        (lambda: plots.reflection(()), "at least one angle"),
        (lambda: plots.halfway(120.0), r"halfway: .* not 120"),
        (lambda: plots.halfway(20.0, 100.0), r"halfway: .* not 100"),
        (lambda: plots.nusselt(80.0, 1.9), "above the base"),
        (lambda: plots.lobes({}), "at least one model"),
        (lambda: plots.lobes({"a": plots.phong_term()}, ()), "at least one angle"),
        (lambda: plots.matrix([1, 2]), "a matrix"),
        (lambda: plots.matrix(np.eye(3), ["a"]), "3 labels are needed"),
        (lambda: plots.system_of([1], np.eye(2), [1]), r"E \(n,\), M \(n, n\) and B \(n,\)"),
    ],
)
def test_errors_are_sentences(call: Callable[[], object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        call()


def test_an_ending_that_nobody_can_write(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"must end in \.svg, \.png or \.pdf"):
        plots.lambert().save(tmp_path / "lambert.txt")
    assert not list(tmp_path.iterdir())


def test_without_matplotlib_a_sentence_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    real = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        if name.split(".")[0] == "matplotlib":
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ImportError, match=r"not installed: pip install 'glsim\[course\]'"):
        plots.lambert()
