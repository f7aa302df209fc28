"""glBegin/glEnd, current values, bad numbers."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.machine.current import make_current
from glsim.play.capture import capture
from tests.machine.moments import interrupted

MODES = (
    GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
    GL_QUAD_STRIP, GL_POLYGON,
)  # fmt: skip


@pytest.mark.parametrize("mode", MODES, ids=repr)
def test_too_few_vertices_draw_nothing(screen: glsim.Offscreen, mode: int) -> None:
    least = {GL_POINTS: 1, GL_LINES: 2, GL_LINE_STRIP: 2, GL_LINE_LOOP: 2, GL_QUADS: 4, GL_QUAD_STRIP: 4}.get(mode, 3)
    for count in range(least):
        glBegin(mode)
        for k in range(count):
            glVertex2f(0.5 * (k % 2), 0.5 * (k // 2))
        glEnd()
    assert not screen.pixels().any()
    glBegin(mode)
    for k in range(least):
        glVertex2f(0.5 * (k % 2) + 0.1 * (k // 2), 0.5 * (k // 2))
    glEnd()
    assert screen.pixels().any()


def test_illegal_between_begin_and_end(screen: glsim.Offscreen) -> None:
    glBegin(GL_TRIANGLES)
    with pytest.raises(GLError, match="glEnable: not allowed between glBegin and glEnd") as caught:
        glEnable(GL_LIGHTING)
    assert caught.value.err == GL_INVALID_OPERATION == 1282
    assert caught.value.baseOperation == "glEnable"
    assert caught.value.cArguments == (GL_LIGHTING,)
    with pytest.raises(GLError, match="glBegin: the glBegin before has no glEnd yet"):
        glBegin(GL_LINES)
    glMaterialf(GL_FRONT, GL_SHININESS, 3.0)
    glEnd()
    with pytest.raises(GLError, match="glEnd: there is no glBegin"):
        glEnd()
    assert not glIsEnabled(GL_LIGHTING)


def test_wrong_primitive(screen: glsim.Offscreen) -> None:
    with pytest.raises(GLError, match="glBegin: mode must be one of the ten primitives"):
        glBegin(GL_LIGHTING)


def test_vertices_outside_begin_and_end_are_ignored(screen: glsim.Offscreen) -> None:
    glVertex3f(0, 0, 0)
    glVertex4f(0, 0, 0, 2)
    glBegin(GL_POINTS)
    glVertex2f(0.25, 0.25)
    glEnd()
    assert (screen.pixels()[..., :3].any(axis=2)).sum() == 1


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: glVertex3f("a", 0, 0), "glVertex3f: x must be a number, not 'a'"),
        (lambda: glVertex3f(0, None, 0), "glVertex3f: y must be a number, not None"),
        (lambda: glVertex3fv([1, 2]), "glVertex3fv: v must be a list, tuple or array of 3 numbers, not"),
        (lambda: glVertex2fv("ab"), "glVertex2fv: v must be a list, tuple or array of 2 numbers, not"),
        (lambda: glColor3ub(0.5, 0, 0), "glColor3ub: red must be an integer, not 0.5"),
        (lambda: glVertex(1), "glVertex takes 2 or 3 or 4 numbers"),
        (lambda: glTranslatef("x", 0, 0), "glTranslatef: x must be a number"),
        (lambda: glMaterialfv(GL_FRONT, GL_DIFFUSE, "red"), "glMaterialfv: params must be a list, tuple or array"),
        (lambda: glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0]), "glMaterialfv: a colour needs four numbers"),
        (lambda: glShadeModel("flat"), "glShadeModel"),
    ],
)
def test_bad_numbers_get_a_sentence(screen: glsim.Offscreen, call: object, sentence: str) -> None:
    glBegin(GL_POINTS) if sentence.startswith("glVertex") else None
    with pytest.raises((TypeError, ValueError, GLError), match=sentence):
        call()  # type: ignore[operator]
    screen.machine.reset()


def test_a_bad_current_normal_is_named(screen: glsim.Offscreen) -> None:
    glNormal3f("up", 0, 0)
    glBegin(GL_POINTS)
    with pytest.raises(TypeError, match=r"the current normal \(glNormal\) is not made of numbers"):
        glVertex3f(0, 0, 0)


def test_a_missing_end_is_told(screen: glsim.Offscreen) -> None:
    glBegin(GL_QUADS)
    with pytest.raises(GLError, match=r"glBegin\(GL_QUADS\) has no glEnd yet"):
        screen.pixels()
    glEnd()


def test_a_bad_rectangle_leaves_everything_as_it_was(screen: glsim.Offscreen) -> None:
    with pytest.raises(TypeError, match="glRectf: y2 must be a number, not None"):
        glRectf(0, 0, 1, None)
    glEnable(GL_LIGHTING)
    glColor3f(None, 0, 0)
    with pytest.raises(TypeError, match=r"glRectf: the current color \(glColor\) is not made of numbers"):
        glRectf(0, 0, 1, 1)


def many_materials(count: int) -> None:
    glEnable(GL_LIGHTING)
    for i in range(count):
        glBegin(GL_QUADS)
        for k in range(4):
            glMaterialfv(GL_FRONT, GL_DIFFUSE, (k / 4, i / count, 0, 1))
            glVertex2f(k / 4, i / count)
        glEnd()


@pytest.mark.slow
def test_many_materials_inside_many_primitives_take_no_time(screen: glsim.Offscreen) -> None:
    """The search for the changes of one primitive looks at no other: twice as many, twice the work."""
    passed = []
    for count in (100, 200, 400):
        screen.reset()
        passed.append(interrupted(lambda count=count: (many_materials(count), screen.pixels())))
    first, second, third = passed
    assert first > 10_000
    assert third - second < 2.2 * (second - first)
    screen.reset()
    with capture() as frame:
        many_materials(3000)
    assert sum(draw.count if draw.indices is None else len(draw.indices) for draw in frame.draws) == 12_000


def test_nan_vertices_draw_nothing_and_crash_nothing(screen: glsim.Offscreen) -> None:
    glBegin(GL_TRIANGLES)
    for x in (0.0, float("nan"), 0.5):
        glVertex3f(x, x, 0.0)
    glEnd()
    assert not screen.pixels().any()
    glRectf(-1, -1, 1, 1)
    assert (screen.pixels()[..., :3] == 255).all()


def test_current_values(screen: glsim.Offscreen) -> None:
    glColor3ub(255, 0, 51)
    assert np.allclose(glGetFloatv(GL_CURRENT_COLOR), [1, 0, 0.2, 1])
    glColor4d(0.1, 0.2, 0.3, 0.4)
    assert np.allclose(glGetFloatv(GL_CURRENT_COLOR), [0.1, 0.2, 0.3, 0.4])
    glColor3b(127, -128, 0)
    assert np.allclose(glGetFloatv(GL_CURRENT_COLOR), [1, -1, 1 / 255, 1])
    glNormal3s(32767, 0, -32768)
    assert np.allclose(glGetFloatv(GL_CURRENT_NORMAL), [1, 1 / 65535, -1])
    glTexCoord2f(0.25, 0.75)
    assert glGetFloatv(GL_CURRENT_TEXTURE_COORDS).tolist() == [0.25, 0.75, 0.0, 1.0]
    glMultiTexCoord3f(GL_TEXTURE0, 1, 2, 3)
    assert glGetFloatv(GL_CURRENT_TEXTURE_COORDS).tolist() == [1, 2, 3, 1]
    glEdgeFlag(GL_FALSE)
    assert glGetBooleanv(GL_EDGE_FLAG) == 0
    glEdgeFlagv([GL_TRUE])
    assert glGetBooleanv(GL_EDGE_FLAG) == 1
    glFogCoordf(3.5)
    assert glGetFloatv(GL_CURRENT_FOG_COORDINATE) == 3.5
    glSecondaryColor3ub(255, 0, 51)
    assert np.allclose(glGetFloatv(GL_CURRENT_SECONDARY_COLOR)[:3], [1, 0, 0.2])


def test_suffix_free_forms(screen: glsim.Offscreen) -> None:
    glColor(0.5, 0.25, 1)
    assert glGetFloatv(GL_CURRENT_COLOR).tolist() == [0.5, 0.25, 1, 1]
    glColor([0.5, 0.25, 1, 0.125])
    assert glGetFloatv(GL_CURRENT_COLOR)[3] == 0.125
    glNormal((0, 1, 0))
    assert glGetFloatv(GL_CURRENT_NORMAL).tolist() == [0, 1, 0]
    glTranslate(1, 2, 3)
    glRotate(90, 0, 0, 1)
    glScale(2, 2, 2)
    assert glGetFloatv(GL_MODELVIEW_MATRIX)[3].tolist() == [1, 2, 3, 1]
    glMaterial(GL_FRONT, GL_SHININESS, 7)
    assert glGetMaterialfv(GL_FRONT, GL_SHININESS) == 7
    glLight(GL_LIGHT0, GL_DIFFUSE, (0.5, 0.5, 0.5, 1))
    assert glGetLightfv(GL_LIGHT0, GL_DIFFUSE)[0] == 0.5


def test_no_context_in_a_glut_program(monkeypatch: pytest.MonkeyPatch) -> None:
    from glsim.glut import api
    from glsim.machine.errors import NoContextError

    make_current(None)
    monkeypatch.setattr(api.settings, "initialized", False)
    monkeypatch.setattr(NoContextError, "uses_glut", False)
    api.glutInit()
    with pytest.raises(NoContextError, match=r"^no context is current: call glutCreateWindow before the first gl"):
        glEnable(GL_LIGHTING)


def test_no_context(monkeypatch: pytest.MonkeyPatch) -> None:
    from glsim.machine.errors import NoContextError

    monkeypatch.setattr(NoContextError, "uses_glut", False)  # other tests call glutInit
    make_current(None)
    with pytest.raises(RuntimeError, match=r"no context is current: call glsim.offscreen"):
        glBegin(GL_POINTS)
    with pytest.raises(RuntimeError, match="no context is current"):
        glVertex3f(0, 0, 0)
