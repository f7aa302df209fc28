"""The illumination equation in NumPy: closed forms, limits, laws of physics; and that GLSL and the driver's own fixed
function compute the same."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import glsim
from glsim import shading
from glsim.gl import *
from glsim.machine.stage import vertex_stage
from glsim.machine.state import Light
from glsim.play.capture import capture
from glsim.render.native import Native

SEEDS = st.integers(0, 2**32 - 1)
Z = np.array([0.0, 0.0, 1.0])


def directions(rng: np.random.Generator, count: int) -> np.ndarray:
    return shading.normalize(rng.normal(size=(count, 3)))


def rotation(rng: np.random.Generator) -> np.ndarray:
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q * np.sign(np.linalg.det(q))


# ---------------------------------------------------------------- the factors


def test_lambert_is_the_cosine_of_the_angle() -> None:
    angle = np.radians([0.0, 30.0, 60.0, 90.0, 120.0])
    L = np.stack([np.sin(angle), 0 * angle, np.cos(angle)], axis=1)
    assert shading.lambert(Z, L)[:, 0] == pytest.approx([1.0, 3**0.5 / 2, 0.5, 0.0, 0.0], abs=1e-15)
    assert shading.diffuse((1.0, 0.5, 0.0), (0.5, 0.5, 0.5), Z, L)[2] == pytest.approx([0.25, 0.125, 0.0])


@given(SEEDS)
def test_the_law_of_reflection(seed: int) -> None:
    """R lies in the plane of N and L, at the same angle, and S = (N.L) N - L is half of what separates them."""
    rng = np.random.default_rng(seed)
    N, L = directions(rng, 20), directions(rng, 20)
    R = shading.reflection(N, L)
    assert shading.dot(N, R) == pytest.approx(shading.dot(N, L), abs=1e-12)
    assert np.linalg.norm(R, axis=1) == pytest.approx(np.ones(20))
    assert np.einsum("ij,ij->i", R, np.cross(N, L)) == pytest.approx(np.zeros(20), abs=1e-12)
    assert pytest.approx(2 * (shading.dot(N, L) * N - L), abs=1e-12) == R - L


@given(SEEDS)
def test_highlights_do_not_change_when_everything_turns(seed: int) -> None:
    rng = np.random.default_rng(seed)
    N, L, V, turn = directions(rng, 20), directions(rng, 20), directions(rng, 20), rotation(rng)
    for lobe in (shading.phong_specular, shading.blinn_torrance_specular):
        assert lobe(N @ turn, L @ turn, V @ turn, 17.0) == pytest.approx(lobe(N, L, V, 17.0), abs=1e-10)
    assert shading.phong_specular(N, L, V, 3.0) == pytest.approx(shading.phong_specular(N, V, L, 3.0), abs=1e-12)


def test_highlights_at_their_limits() -> None:
    L = shading.normalize([1.0, 0.0, 1.0])
    mirrored = L * (-1, 1, 1)
    for lobe in (shading.phong_specular, shading.blinn_torrance_specular):
        assert lobe(Z, L, mirrored, 128.0) == pytest.approx(1.0)  # the eye looks into the mirror direction
        assert lobe(Z, L, L, 0.0) == 1.0  # x^0, also 0^0
        assert lobe(Z, L, L, 1e6) == pytest.approx(0.0, abs=1e-9)
    # in the plane of incidence H turns half as far as R: (R.V)^n is about (N.H)^4n
    V = shading.normalize([-1.1, 0.0, 1.0])
    assert shading.phong_specular(Z, L, V, 10.0) == pytest.approx(
        shading.blinn_torrance_specular(Z, L, V, 40.0), rel=1e-3
    )
    assert np.array_equal(shading.halfway(L, -L), np.zeros(3))


def test_attenuation_spot_and_the_policies() -> None:
    assert shading.attenuation([0.0, 1.0, 2.0], 1.0, 0.5, 0.25) == pytest.approx([1.0, 1 / 1.75, 1 / 3])
    down = np.array([0.0, -1.0, 0.0])
    at = np.radians([0.0, 20.0, 29.9, 30.1])
    L = np.stack([np.sin(at), np.cos(at), 0 * at], axis=1)
    assert shading.spotlight(L, down, 30.0, 2.0)[:, 0] == pytest.approx(
        [1.0, np.cos(at[1]) ** 2, np.cos(at[2]) ** 2, 0.0]
    )
    assert (shading.spotlight(L, down, 180.0, 2.0) == 1.0).all()
    assert shading.clamp([-1.0, 0.5, 2.0]).tolist() == [0.0, 0.5, 1.0]
    assert shading.lambert(shading.towards_light(Z, -Z), -Z) == 0.0
    assert shading.lambert(shading.towards_light(Z, -Z, flip=True), -Z) == 1.0


@given(SEEDS, st.floats(1.0, 2.5), st.floats(1.0, 2.5))
def test_snell_and_fresnel(seed: int, n_1: float, n_2: float) -> None:
    N = np.broadcast_to(Z, (30, 3))
    L = directions(np.random.default_rng(seed), 30)
    L[:, 2] = np.abs(L[:, 2])
    T = shading.refraction(N, L, n_1, n_2)
    through = ~np.isnan(T[:, 0])
    sine_1, sine_2 = np.linalg.norm(np.cross(N, L), axis=1), np.linalg.norm(np.cross(N, T), axis=1)
    assert n_1 * sine_1[through] == pytest.approx(n_2 * sine_2[through], abs=1e-9)
    assert np.linalg.norm(T[through], axis=1) == pytest.approx(np.ones(through.sum()))
    reflected = shading.fresnel(L[:, 2], n_1, n_2)
    assert (reflected[~through] == 1.0).all()
    assert ((reflected >= 0.0) & (reflected <= 1.0)).all()
    # the same share from the other side
    back = shading.fresnel(-T[through, 2], n_2, n_1)
    assert back == pytest.approx(reflected[through], abs=1e-8)


def test_fresnel_at_its_limits() -> None:
    assert shading.fresnel(1.0, 1.0, 1.5) == pytest.approx(0.04)  # ((n1 - n2) / (n1 + n2))^2
    assert shading.fresnel(0.0, 1.0, 1.5) == pytest.approx(1.0)
    brewster = np.cos(np.arctan(1.5))  # there only light polarised across is reflected
    assert shading.fresnel(brewster, 1.0, 1.5) == pytest.approx(0.5 * ((1 - 1.5**2) / (1 + 1.5**2)) ** 2)
    assert shading.fresnel_schlick([0.0, 1.0], 0.04) == pytest.approx([1.0, 0.04])


# ---------------------------------------------------------------- the sum


LAMP = Light(ambient=(0.1, 0.2, 0.3, 1), diffuse=(0.5, 0.6, 0.7, 1), specular=(0.9, 0.8, 0.7, 1), position=(1, 2, 3, 1))
GOLD = shading.Surface((0.2, 0.2, 0.1), (0.7, 0.6, 0.2), (0.6, 0.6, 0.4), (0.01, 0.02, 0.03), 12.0)


@given(SEEDS)
def test_light_is_additive_and_linear(seed: int) -> None:
    rng = np.random.default_rng(seed)
    N, P = directions(rng, 20), rng.uniform(-2, 2, (20, 3)) - (0, 0, 4)
    other = LAMP._replace(position=tuple(rng.uniform(-3, 3, 4)), diffuse=(0.2, 0.9, 0.1, 1.0))
    both = shading.illuminate(GOLD, [LAMP, other], N, P).sum
    dark = shading.illuminate(GOLD, [], N, P).sum
    each = [shading.illuminate(GOLD, [light], N, P).sum - dark for light in (LAMP, other)]
    assert both - dark == pytest.approx(each[0] + each[1], abs=1e-12)
    doubled = LAMP._replace(
        **{name: tuple(2 * np.array(getattr(LAMP, name))) for name in ("ambient", "diffuse", "specular")}
    )
    assert shading.illuminate(GOLD, [doubled], N, P).sum - dark == pytest.approx(2 * each[0], abs=1e-12)


def test_a_contribution_is_made_of_its_factors() -> None:
    N, P = shading.normalize([0.1, 0.3, 1.0]), np.array([0.2, -0.1, -3.0])
    spot = LAMP._replace(spot_cutoff=80.0, spot_exponent=3.0, spot_direction=(-0.1, -0.3, -1.0), linear_attenuation=0.5)
    terms = shading.illuminate(GOLD, [spot], N, P, scene_ambient=(0.3, 0.3, 0.3))
    light = terms.lights[0]
    d = np.linalg.norm([0.8, 2.1, 6.0])
    assert light.d == pytest.approx(d)
    assert light.attenuation == pytest.approx(1 / (1 + 0.5 * d))
    assert pytest.approx(N @ np.array([0.8, 2.1, 6.0]) / d) == light.N_L
    assert light.specular == pytest.approx(light.strength * np.array(GOLD.k_s) * LAMP.specular[:3] * light.cosine**12)
    assert terms.sum == pytest.approx(terms.emission + terms.ambient + light.ambient + light.diffuse + light.specular)
    assert terms.ambient == pytest.approx(0.3 * np.array(GOLD.k_a))
    with pytest.raises(ValueError, match="lobe must be"):
        shading.illuminate(GOLD, [], N, P, lobe="cook")


def test_a_light_behind_gives_no_highlight() -> None:
    behind = LAMP._replace(position=(0.0, 0.0, -1.0, 0.0))
    light = shading.illuminate(GOLD, [behind], Z, -Z).lights[0]
    assert not light.diffuse.any()
    assert not light.specular.any()
    assert shading.illuminate(GOLD, [behind], Z, -Z, flip=True).lights[0].diffuse.any()


# ---------------------------------------------------------------- the three witnesses


COLOR_MATERIAL_MODES = (GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION)


def random_state(rng: np.random.Generator, shininess: tuple[float, ...] = (0.0, 1.0, 9.5, 60.0, 128.0)) -> None:
    """Lights, materials and a light model of any kind, by gl calls; no clamping is avoided."""
    glEnable(GL_LIGHTING)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    for _ in range(rng.integers(0, 5)):
        light = GL_LIGHT0 + int(rng.integers(0, 8))
        glEnable(light)
        w = float(rng.choice([0.0, 1.0, 2.0]))
        glLightfv(light, GL_POSITION, [*rng.uniform(-4, 4, 2), rng.uniform(-6, 3), w])
        for name in (GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR):
            glLightfv(light, name, [*rng.uniform(0, 0.9, 3), 1])
        if rng.random() < 0.4:
            glLightf(light, GL_SPOT_CUTOFF, float(rng.uniform(20, 90)))
            glLightf(light, GL_SPOT_EXPONENT, float(rng.uniform(0, 20)))
            glLightfv(light, GL_SPOT_DIRECTION, rng.uniform(-1, 1, 3))
        if rng.random() < 0.5:
            glLightf(light, GL_CONSTANT_ATTENUATION, float(rng.uniform(0.3, 1.5)))
            glLightf(light, GL_LINEAR_ATTENUATION, float(rng.uniform(0, 0.3)))
            glLightf(light, GL_QUADRATIC_ATTENUATION, float(rng.uniform(0, 0.1)))
    for side in (GL_FRONT, GL_BACK):
        for name in (GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION):
            glMaterialfv(side, name, [*rng.uniform(0, 0.6 if name != GL_EMISSION else 0.2, 3), 1])
        glMaterialf(side, GL_SHININESS, float(rng.choice(shininess)))
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [*rng.uniform(0, 0.5, 3), 1])
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, int(rng.integers(0, 2)))
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, int(rng.integers(0, 2)))
    if rng.random() < 0.3:
        glColorMaterial(GL_FRONT_AND_BACK, COLOR_MATERIAL_MODES[rng.integers(0, 5)])
        glEnable(GL_COLOR_MATERIAL)
    glColor3f(*rng.uniform(0, 1, 3))
    glEnable(GL_NORMALIZE)


def points(rng: np.random.Generator) -> None:
    """64 points with normals of all directions, 16 pixels apart."""
    glPointSize(5)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glFrustum(-1, 1, -1, 1, 1, 50)
    glMatrixMode(GL_MODELVIEW)
    glBegin(GL_POINTS)
    for k in range(64):
        x, y = (k % 8 + 0.53) / 4 - 1, (k // 8 + 0.53) / 4 - 1
        z = float(rng.uniform(1.5, 8))
        normal = directions(rng, 1)[0]
        glNormal3f(*(normal * rng.uniform(0.5, 2)))
        glVertex3f(x * z, y * z, -z)
    glEnd()


def three_witnesses(seed: int, screen: glsim.Offscreen, native: Native) -> None:
    """One random lighting state with 64 points, per vertex.  (The driver errs where the shininess is 0: see
    test_contradictions.py.)"""
    screen.reset()
    with capture(calls=True) as frame:
        rng = np.random.default_rng(seed)
        random_state(rng, (1.0, 9.5, 60.0, 128.0))
        points(rng)
    (draw,) = frame.draws
    expected = vertex_stage(draw, np.arange(64, dtype=np.uint32), 0).front * 255.0
    at = np.stack(np.meshgrid(np.arange(8), np.arange(8)), -1).reshape(-1, 2) * 16 + 8
    for name, picture in (("GLSL", screen.pixels()), ("the driver", native.replay(frame.calls))):
        found = picture[::-1][at[:, 1], at[:, 0]]
        worst = np.abs(found - expected)[:, :3].max()
        assert worst <= 1.0, f"{name} is {worst:.2f}/255 away"


@pytest.mark.parametrize("seed", range(10))
def test_glsl_and_the_driver_agree_with_numpy_in_ten_states(seed: int, screen: glsim.Offscreen, native: Native) -> None:
    three_witnesses(seed, screen, native)


@pytest.mark.slow
@settings(max_examples=150)
@given(seed=SEEDS)
def test_glsl_and_the_driver_agree_with_numpy(screen: glsim.Offscreen, native: Native, seed: int) -> None:
    three_witnesses(seed, screen, native)


@pytest.mark.slow
@settings(max_examples=60)
@given(seed=SEEDS, phong=st.booleans(), flip=st.booleans(), fragment=st.booleans())
def test_glsl_agrees_with_numpy_in_the_extensions(
    screen: glsim.Offscreen, seed: int, phong: bool, flip: bool, fragment: bool
) -> None:
    screen.reset()
    with capture() as frame:
        rng = np.random.default_rng(seed)
        random_state(rng)
        glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM if phong else GL_BLINN_TORRANCE_GLSIM)
        glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, GL_FLIP_NORMAL_GLSIM if flip else GL_CLAMP_NORMAL_GLSIM)
        glShadeModel(GL_PHONG_WIN if fragment else GL_SMOOTH)
        points(rng)
    (draw,) = frame.draws
    expected = vertex_stage(draw, np.arange(64, dtype=np.uint32), 0).front * 255.0
    at = np.stack(np.meshgrid(np.arange(8), np.arange(8)), -1).reshape(-1, 2) * 16 + 8
    assert np.abs(screen.pixels()[::-1][at[:, 1], at[:, 0]] - expected)[:, :3].max() <= 1.0


# ---------------------------------------------------------------- BRDFs


BRDFS: list[Any] = [
    shading.Lambertian((0.7, 0.5, 0.2)), shading.NormalizedPhong(0.8, 30.0), shading.BlinnPhong(0.8, 30.0),
    shading.CookTorrance((0.9, 0.6, 0.3), 0.3), shading.CookTorrance(1.0, 0.1),
]  # fmt: skip


@pytest.mark.parametrize("brdf", BRDFS, ids=lambda brdf: type(brdf).__name__)
def test_physical_brdfs_keep_reciprocity_and_energy(brdf: shading.BRDF) -> None:
    assert brdf.reciprocity_error() < 1e-9
    for cosine in (0.05, 0.2, 0.5, 0.9, 1.0):
        assert (brdf.albedo(cosine) <= 1.0 + 1e-6).all()


def test_the_lectures_phong_model_keeps_neither() -> None:
    phong = shading.Phong(1.0, 5.0)
    assert phong.reciprocity_error() > 0.5
    assert phong.albedo(0.05) > 1.5


def test_albedos_that_are_known() -> None:
    assert shading.Lambertian(0.3).albedo(0.4) == pytest.approx([0.3])
    for n in (1.0, 10.0, 500.0):
        assert shading.NormalizedPhong(0.5, n).albedo() == pytest.approx([0.5], rel=1e-3)
        assert shading.BlinnPhong(0.5, n).albedo() == pytest.approx([0.5], rel=2e-3)
        assert shading.Phong(1.0, n).albedo() == pytest.approx([2 * np.pi / (n + 2)], rel=1e-3)
    smooth = shading.CookTorrance(0.8, 0.01)  # nearly a mirror
    assert smooth.albedo(1.0) == pytest.approx([0.8], rel=1e-2)


@pytest.mark.parametrize("brdf", BRDFS, ids=lambda brdf: type(brdf).__name__)
@pytest.mark.slow
def test_samples_have_their_density(brdf: shading.BRDF) -> None:
    """The mean of g(L) over samples is the integral of g times the density, here by quadrature over the sphere."""
    rng = np.random.default_rng(3)
    N, V = Z, shading.normalize([0.5, 0.2, 0.8])
    u = rng.random((200_000, 2))
    L = brdf.sample(np.broadcast_to(N, (len(u), 3)), np.broadcast_to(V, (len(u), 3)), u)
    assert np.linalg.norm(L, axis=1) == pytest.approx(np.ones(len(u)))
    z = np.linspace(-1, 1, 2001)[:-1] + 0.0005
    phi = np.linspace(0, 2 * np.pi, 2001)[:-1]
    z, phi = (grid.ravel() for grid in np.meshgrid(z, phi))
    ring = np.sqrt(1 - z * z)
    sphere = np.stack([ring * np.cos(phi), ring * np.sin(phi), z], axis=1)
    density = brdf.pdf(N, sphere, V)[:, 0] * (4 * np.pi / len(sphere))
    assert density.sum() == pytest.approx(1.0, abs=2e-3)
    for axis in range(3):
        assert L[:, axis].mean() == pytest.approx((density * sphere[:, axis]).sum(), abs=6e-3)
