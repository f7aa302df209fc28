"""GL_GLSIM_affine_interpolation: linear on the screen, against both interpolations computed in NumPy."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import gluPerspective
from glsim.machine import archive
from glsim.play.capture import capture
from glsim.render.key import draw_key
from glsim.study.prober import Prober

SIZE = 128
# a floor that goes away from the eye: x, y, z in eye space, and s, t
Places = list[tuple[float, float, float]]
FLOOR: Places = [(-1.0, -1.0, -1.5), (1.0, -1.0, -1.5), (1.5, 1.0, -8.0), (-1.5, 1.0, -8.0)]
COORDINATES = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
MODES = {"affine": GL_AFFINE_GLSIM, "hyperbolic": GL_NICEST}


def perspective() -> None:
    glMatrixMode(GL_PROJECTION)
    gluPerspective(70.0, 1.0, 0.5, 20.0)
    glMatrixMode(GL_MODELVIEW)


def ramp() -> None:
    """A texture whose red is s and green is t."""
    s, t = np.meshgrid((np.arange(256) + 0.5) / 256, (np.arange(256) + 0.5) / 256)
    texels = np.stack([s, t, np.zeros_like(s)], axis=-1)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 256, 256, 0, GL_RGB, GL_FLOAT, texels.astype(np.float32))
    for name in (GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T):
        glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE)
    for name in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
        glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glEnable(GL_TEXTURE_2D)


def floor(colors: bool = False, places: Places = FLOOR) -> None:
    glBegin(GL_TRIANGLES)
    for k in (0, 1, 2, 0, 2, 3):
        if colors:
            glColor3f(*COORDINATES[k], 0.0)
        glTexCoord2f(*COORDINATES[k])
        glVertex3f(*places[k])
    glEnd()


def expected(affine: bool, places: Places = FLOOR) -> tuple[np.ndarray, np.ndarray]:
    """s and t at each pixel, top row first, (SIZE, SIZE, 2), and where the floor is, without its border."""
    f = 1.0 / np.tan(np.radians(35.0))
    corners = np.array(places)
    w = -corners[:, 2]
    at = (1.0 + f * corners[:, :2] / w[:, None]) * SIZE / 2.0
    x, y = np.meshgrid(np.arange(SIZE) + 0.5, SIZE - 0.5 - np.arange(SIZE))
    values, inside = np.zeros((SIZE, SIZE, 2)), np.zeros((SIZE, SIZE), bool)
    for chosen in ([0, 1, 2], [0, 2, 3]):
        system = np.vstack([at[chosen].T, np.ones(3)])
        weights = np.linalg.solve(system, np.stack([x.ravel(), y.ravel(), np.ones(x.size)])).T.reshape(SIZE, SIZE, 3)
        here = (weights > 0.02).all(axis=-1)
        if not affine:
            weights = weights / w[chosen]
            weights /= weights.sum(axis=-1, keepdims=True)
        values[here] = (weights @ np.array(COORDINATES)[chosen])[here]
        inside |= here
    return values, inside


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("what", ["texture", "color"])
def test_both_interpolations_against_numpy(screen: glsim.Offscreen, mode: str, what: str) -> None:
    perspective()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, MODES[mode])
    if what == "texture":
        ramp()
    floor(colors=what == "color")
    values, inside = expected(mode == "affine")
    shown = screen.pixels()[..., :2].astype(float)
    assert inside.sum() > 2000
    assert np.abs(shown - 255.0 * values)[inside].max() <= 1.5


@pytest.mark.parametrize("near", [-1.0, -0.6, -0.3, -0.1])
@pytest.mark.parametrize("wide", [1.0, 30.0])
def test_clipping_changes_nothing(screen: glsim.Offscreen, near: float, wide: float) -> None:
    """The floor reaches beyond the sides and beyond the near plane, which is at -0.5."""
    places = [(-wide, -1.0, near), (wide, -1.0, near), (1.5 * wide, 1.0, -8.0), (-1.5 * wide, 1.0, -8.0)]
    perspective()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
    floor(colors=True, places=places)
    values, inside = expected(True, places)
    picture = screen.pixels()
    drawn = inside & (picture[..., 3] > 0)
    assert drawn.sum() > 1000
    assert np.abs(picture[..., :2] - 255.0 * values)[drawn].max() <= 1.5


def test_what_reaches_behind_the_eye_is_interpolated_hyperbolically(screen: glsim.Offscreen) -> None:
    places = [(-1.0, -1.0, 2.0), (1.0, -1.0, 2.0), (1.5, 1.0, -8.0), (-1.5, 1.0, -8.0)]
    pictures = []
    perspective()
    for hint in MODES.values():
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint)
        with capture(calls=True) as frame:
            glClear(GL_COLOR_BUFFER_BIT)
            floor(colors=True, places=places)
        pictures.append(screen.pixels())
        assert "affine" not in glsim.probe(frame, 64, 80).winner.shading
    assert pictures[0].any()
    assert (pictures[0] == pictures[1]).all()


def test_clip_planes_cut_where_they_are(screen: glsim.Offscreen) -> None:
    """Also between vertices at different distances: the same pixels with both interpolations."""
    perspective()
    glClipPlane(GL_CLIP_PLANE0, [0.3, 0.2, 1.0, 3.0])
    glEnable(GL_CLIP_PLANE0)
    covered = []
    for hint in MODES.values():
        glClear(GL_COLOR_BUFFER_BIT)
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint)
        floor()
        covered.append(screen.pixels()[..., 0] > 0)
    assert covered[0].sum() > 500
    assert (covered[0] != covered[1]).sum() <= 3


def test_the_two_differ_much() -> None:
    a, inside = expected(True)
    b, _ = expected(False)
    assert np.abs(a - b)[inside].max() > 0.3


def test_fastest_nicest_and_dont_care_are_hyperbolic(screen: glsim.Offscreen) -> None:
    perspective()
    ramp()
    pictures = []
    for hint in (GL_FASTEST, GL_NICEST, GL_DONT_CARE, GL_AFFINE_GLSIM):
        glClear(GL_COLOR_BUFFER_BIT)
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint)
        floor()
        pictures.append(screen.pixels())
    assert (pictures[0] == pictures[1]).all()
    assert (pictures[0] == pictures[2]).all()
    assert (pictures[0] != pictures[3]).any()


def test_fog_and_normals_are_linear_too(screen: glsim.Offscreen) -> None:
    perspective()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, GL_LINEAR)
    glFogf(GL_FOG_START, 0.0)
    glFogf(GL_FOG_END, 10.0)
    floor()
    _, inside = expected(True)
    t = expected(True)[0][..., 1]
    distance = 1.5 + t * 6.5  # z is linear in t on the floor
    assert np.abs(screen.pixels()[..., 0] - 255.0 * (1.0 - distance / 10.0))[inside].max() <= 1.5


def scene(model: int, hint: int) -> None:
    perspective()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint)
    ramp()
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE)
    for cap in (GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE, GL_FOG):
        glEnable(cap)
    glLightfv(GL_LIGHT0, GL_POSITION, [0.5, 1.0, 0.0, 1.0])
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, [0.7, 0.7, 0.7, 1.0])
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 12.0)
    glFogf(GL_FOG_DENSITY, 0.05)
    glShadeModel(model)
    glBegin(GL_QUADS)
    for k, normal in enumerate(((-0.3, 1, 0.8), (0.4, 1, 0.8), (0.2, 1, 0), (-0.5, 1, 0.2))):
        glNormal3f(*normal)
        glTexCoord2f(*COORDINATES[k])
        glVertex3f(*FLOOR[k])
    glEnd()
    glDisable(GL_LIGHTING)
    glLineWidth(7.0)
    glBegin(GL_LINES)
    for color, place in (((1, 0, 0), (-1.3, -0.5, -1.2)), ((0, 1, 1), (3.0, 3.0, -9.0))):
        glColor3f(*color)
        glVertex3f(*place)
    glEnd()


@pytest.mark.parametrize("model", [GL_FLAT, GL_SMOOTH, GL_PHONG_WIN])
def test_the_probe_agrees_with_the_picture(screen: glsim.Offscreen, model: int, tmp_path: Path) -> None:
    with capture(calls=True) as frame:
        scene(model, GL_AFFINE_GLSIM)
    picture = screen.pixels()
    archive.save(frame, tmp_path / "frame.npz")
    again = archive.load(tmp_path / "frame.npz")
    assert next(iter(again.draws)).state.hints.perspective_correction == GL_AFFINE_GLSIM
    rng = np.random.default_rng(1)
    ys, xs = np.nonzero(picture[..., :3].any(axis=2))
    prober = Prober(again)
    for k in rng.choice(len(xs), 40, replace=False):
        probe = prober.at(int(xs[k]), int(ys[k]))
        assert probe.pixel == tuple(picture[ys[k], xs[k]])
        assert np.abs(np.subtract(probe.computed, probe.pixel)).max() <= 1, (xs[k], ys[k])
    probe = prober.at(64, 70)
    prober.release()
    assert probe.winner is not None
    assert "affine" in probe.winner.shading
    x, y = 64.5, SIZE - 70.5
    linear = [v.linear for v in probe.winner.vertices]
    np.testing.assert_allclose(np.array(linear) @ [v.window[:2] for v in probe.winner.vertices], (x, y), atol=0.01)
    w = np.array([-v.eye[2] for v in probe.winner.vertices])
    hyperbolic = np.array(linear) / w
    np.testing.assert_allclose([v.hyperbolic for v in probe.winner.vertices], hyperbolic / hyperbolic.sum(), atol=1e-5)


def test_the_key_has_the_bit_only_where_something_is_interpolated(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        for hint in (GL_AFFINE_GLSIM, GL_FASTEST):
            glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint)
            for model in (GL_SMOOTH, GL_FLAT):
                glShadeModel(model)
                glRectf(-1, -1, 1, 1)
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
        glEnable(GL_FOG)
        glRectf(-1, -1, 1, 1)
        glBegin(GL_POINTS)
        glVertex2f(0, 0)
        glEnd()
    assert [draw_key(draw).affine for draw in frame.draws] == [True, False, False, False, True, False]


def test_state_explain_and_trace_know_it(screen: glsim.Offscreen) -> None:
    assert b"GL_GLSIM_affine_interpolation" in glGetString(GL_EXTENSIONS)
    assert glGetIntegerv(GL_PERSPECTIVE_CORRECTION_HINT) == GL_DONT_CARE
    glPushAttrib(GL_HINT_BIT)
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
    assert glGetIntegerv(GL_PERSPECTIVE_CORRECTION_HINT) == GL_AFFINE_GLSIM
    glPopAttrib()
    assert glGetIntegerv(GL_PERSPECTIVE_CORRECTION_HINT) == GL_DONT_CARE
    with capture(calls=True) as frame:
        glNewList(1, GL_COMPILE)
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
        glEndList()
        glCallList(1)
        assert glGetIntegerv(GL_PERSPECTIVE_CORRECTION_HINT) == GL_AFFINE_GLSIM
        glRectf(-1, -1, 1, 1)
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST)
    explanation = glsim.explain(frame)[0]
    setting = next(setting for setting in explanation.key if setting.name == "AFFINE")
    assert setting.value == "true"
    assert "GL_AFFINE_GLSIM" in setting.origins[0].text
    assert "perspective_correction" in str(glsim.trace(frame).as_dict())


def test_wrong_hints_are_sentences(screen: glsim.Offscreen) -> None:
    with pytest.raises(GLError, match="GL_AFFINE_GLSIM is for GL_PERSPECTIVE_CORRECTION_HINT"):
        glHint(GL_FOG_HINT, GL_AFFINE_GLSIM)
    with pytest.raises(GLError, match="hint must be GL_FASTEST, GL_NICEST or GL_DONT_CARE"):
        glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_SMOOTH)
