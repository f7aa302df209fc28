"""glsim.explain: the call that set each thing; the GLSL with the key folded in."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt
from glsim.play.capture import capture
from glsim.render import programs
from glsim.render.specialise import specialised
from glsim.study.explain import Explanation, Setting
from tests.oracle import PROGRAMS


def setting(explanation: Explanation, name: str) -> Setting:
    return next(entry for entry in (*explanation.key, *explanation.uniforms) if entry.name == name)


def line_of(words: str) -> int:
    """The line of this file that ends with the comment ``words``."""
    lines = Path(__file__).read_text().splitlines()
    return next(k for k, line in enumerate(lines, 1) if line.endswith(f"# {words}"))


def lines(entry: Setting) -> list[int]:
    return [origin.where.line for origin in entry.origins if origin.where is not None]


def quad() -> None:
    glBegin(GL_QUADS)
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex2f(x, y)
    glEnd()


def test_who_set_what(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT1)  # light
        glShadeModel(GL_SMOOTH)  # as it was already
        glMatrixMode(GL_MODELVIEW)
        glLoadIdentity()  # identity
        gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)  # camera
        glLightfv(GL_LIGHT1, GL_POSITION, [1, 2, 3, 1])  # position
        glScalef(2, 2, 2)  # scale
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0, 0, 1])
        glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [0, 1, 0, 1])  # material
        glColor3f(1, 1, 0)  # colour
        quad()
        glDisable(GL_LIGHTING)  # lighting off
        quad()
    first, second = glsim.explain(frame)
    assert (first.draw, second.draw) == (0, 1)
    assert lines(setting(first, "SHADED")) == [line_of("as it was already")]
    assert lines(setting(first, "LIGHT_NUMBER[0]")) == [line_of("light")]
    assert setting(first, "LIGHT_IS_POSITIONAL[0]").value == "true"
    position = setting(first, "lights[1].position")
    assert position.value == "(1, 2, -2, 1)"
    assert lines(position) == [line_of("position")]
    assert "gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)" in position.note
    assert "0 0 1 -5" in position.note
    assert "glScalef" not in position.note
    modelview = setting(first, "transform.modelview")
    assert lines(modelview) == [line_of("identity"), line_of("camera"), line_of("scale")]
    assert modelview.origins[1].text.startswith("gluLookAt(0, 0, 5")
    assert lines(setting(first, "material.front.k_d")) == [line_of("material")]
    assert setting(first, "I_a_scene").origins == ()
    color = setting(first, "color")
    assert lines(color) == [line_of("colour")]
    assert "no effect" in color.note
    assert lines(setting(second, "LIGHTING")) == [line_of("lighting off")]
    assert not setting(second, "color").note


def test_lists_attributes_and_what_was_before(screen: glsim.Offscreen) -> None:
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    with capture(calls=True) as frame:
        number = glGenLists(1)
        glNewList(number, GL_COMPILE)
        glMaterialf(GL_FRONT, GL_SHININESS, 12)  # in the list
        glEndList()
        glFogf(GL_FOG_DENSITY, 0.5)  # density
        glEnable(GL_FOG)
        glPushAttrib(GL_FOG_BIT)
        glFogf(GL_FOG_DENSITY, 0.25)
        glPopAttrib()
        glCallList(number)
        quad()
    (found,) = glsim.explain(frame)
    shininess = setting(found, "material.front.n")
    assert lines(shininess) == [line_of("in the list")]
    assert "glCallList(1)" in shininess.origins[0].through
    assert setting(found, "fog_density").value == "0.5"
    assert lines(setting(found, "fog_density")) == [line_of("density")]
    assert setting(found, "LIGHTING").origins[0].text == "before the recording began"


def test_nested_lists_and_what_they_put_back(screen: glsim.Offscreen) -> None:
    """Each draw in a list is explained as things were when it was made."""
    with capture(calls=True) as frame:
        glEnable(GL_LIGHTING)
        glLoadIdentity()  # load
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 0, 1, 1])  # blue
        glNewList(1, GL_COMPILE)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0, 0, 1])  # red
        quad()
        glEndList()
        glNewList(2, GL_COMPILE)
        glPushAttrib(GL_LIGHTING_BIT | GL_CURRENT_BIT)
        glPushMatrix()
        glTranslatef(0.5, 0, 0)  # moved
        glColor3f(1, 1, 0)  # yellow
        glCallList(1)
        glPopMatrix()
        glPopAttrib()
        quad()
        glEndList()
        glCallList(2)
        glCallLists([2])
    red, blue, again, _ = glsim.explain(frame)
    for found in (red, again):
        assert lines(setting(found, "material.front.k_d")) == [line_of("red")]
        assert lines(setting(found, "transform.modelview")) == [line_of("load"), line_of("moved")]
        assert lines(setting(found, "color")) == [line_of("yellow")]
    assert "glCallList(2)" in setting(red, "material.front.k_d").origins[0].through
    assert "glCallLists" in setting(again, "material.front.k_d").origins[0].through
    assert lines(setting(blue, "material.front.k_d")) == [line_of("blue")]
    assert setting(blue, "material.front.k_d").origins[0].through == ""
    assert lines(setting(blue, "transform.modelview")) == [line_of("load")]
    assert lines(setting(blue, "color")) == []


def test_names_are_told_not_numbers(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glEnable(GL_LIGHT0 + 1)
        glEnable(GL_FOG)
        glFogi(GL_FOG_MODE, int(GL_LINEAR))
        quad()
    assert next(entry.text for entry in glsim.trace(frame).entries) == "glEnable(GL_LIGHT1)"
    (found,) = glsim.explain(frame)
    assert setting(found, "FOG").value == "GL_LINEAR"


def test_calls_must_be_there(screen: glsim.Offscreen) -> None:
    with capture() as frame:
        quad()
    with pytest.raises(ValueError, match=r"capture\(calls=True\)"):
        glsim.explain(frame)
    with capture(calls=True) as frame:
        quad()
    with pytest.raises(ValueError, match="1 draws"):
        glsim.explain(frame, 1)


@pytest.mark.slow
def test_folding_changes_no_picture(screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch) -> None:
    """A third of the oracle's programs, drawn with the folded GLSL."""
    full = programs.sources
    other = glsim.offscreen(128, 128)
    monkeypatch.setattr(programs, "sources", lambda key: {s: specialised(text) for s, text in full(key).items()})
    drawn = {}
    for name in list(PROGRAMS)[::3]:
        other.reset()
        other.make_current()
        with capture() as frame:
            PROGRAMS[name]()
        drawn[name] = frame, other.pixels()
    monkeypatch.undo()
    for name, (frame, picture) in drawn.items():
        screen.reset()
        screen.execute(frame.packets)
        assert np.array_equal(screen.pixels(), picture), name
    assert len(other._renderer.programs) > 30
    other.release()


def test_the_folded_source_has_only_what_runs(screen: glsim.Offscreen) -> None:
    with capture(calls=True) as frame:
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        quad()
        glShadeModel(GL_PHONG_WIN)
        glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM)
        quad()
    gouraud, phong = (entry.glsl for entry in glsim.explain(frame))
    for text in (*gouraud.values(), *phong.values()):
        assert not re.search(r"^\s*#(if|define|line)", text, re.MULTILINE)
        assert "TEXTURES" not in text
        assert text.count("{") == text.count("}")
    assert "(N.H)" not in gouraud["fragment"]
    assert "blinn_torrance" in gouraud["vertex"]
    assert "vec3 R = dot(N, L) * N + S;" in phong["fragment"]
    assert re.search(r"modelview_projection \* P; +// in clip space", gouraud["vertex"])
    assert "blinn_torrance" not in phong["fragment"]
    assert "spotlight(" not in gouraud["vertex"]
    assert len(gouraud["fragment"].splitlines()) < 40


def drawn_in_all_ways() -> None:
    """A display list, wide lines, glVertex4, outlines, merged objects, materials inside: each kind of program."""
    glNewList(1, GL_COMPILE)
    quad()
    glEndList()
    glCallList(1)
    glColor3f(1, 0, 0)
    for _ in range(3):
        glTranslatef(0.1, 0, 0)
        glCallList(1)
    glLineWidth(3)
    glBegin(GL_LINES)
    for w in (1, 2, 3, 4):
        glVertex4f(0.1 * w, -0.2, 0, w)
    glEnd()
    glEnable(GL_LINE_STIPPLE)
    quad()
    glRectf(0, 0, 1, 1)
    for _ in range(3):
        glRotatef(10, 0, 0, 1)
        quad()
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glShadeModel(GL_FLAT)
    glEnable(GL_POLYGON_OFFSET_LINE)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    quad()
    glEnable(GL_LINE_SMOOTH)
    quad()
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT)
    quad()
    glPolygonMode(GL_FRONT, GL_FILL)
    quad()
    glBegin(GL_TRIANGLES)
    for k in range(6):
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 6, 0, 0, 1])
        glVertex2f(k % 3, k * k % 3)
    glEnd()


@pytest.mark.parametrize("name", ["", *(name for k, name in enumerate(PROGRAMS) if k % 9 == 0)])
def test_the_explained_programs_are_those_that_are_drawn(
    name: str, screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawn = set()
    program = screen._renderer.program
    monkeypatch.setattr(screen._renderer, "program", lambda key: (drawn.add(key), program(key))[1])
    with capture(calls=True) as frame:
        PROGRAMS.get(name, drawn_in_all_ways)()
    explained = {explanation.program for explanation in glsim.explain(frame)}
    assert explained <= drawn
    if not name:
        assert {key.objects for key in explained} == {1, 256}
        for field in ("wide_lines", "has_w", "object_color", "depth_offset", "smooth_lines", "lit_elsewhere"):
            assert {getattr(key, field) for key in explained} == {True, False}, field


def test_program_source_is_what_is_drawn(screen: glsim.Offscreen, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn = []
    program = screen._renderer.program
    monkeypatch.setattr(screen._renderer, "program", lambda key: (drawn.append(key), program(key))[1])
    glEnable(GL_LIGHTING)
    glEnable(GL_FOG)
    text = glsim.program_source("fragment")
    quad()
    screen.pixels()
    assert [programs.sources(key)["fragment"] for key in drawn] == [text]
