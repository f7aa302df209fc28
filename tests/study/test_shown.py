"""What the results show: one line in a shell, tables and pictures in Jupyter."""

from __future__ import annotations

import pytest
from rich.text import Text

import glsim
from glsim.gl import *
from glsim.study.report import html


@pytest.fixture(scope="module")
def frame() -> glsim.Frame:
    def draw() -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_LIGHTING)
        glEnable(GL_LIGHT0)
        glNormal3f(0, 0, 2)
        glBegin(GL_TRIANGLES)
        for x, y in ((-1, -1), (1, -1), (0, 1)):
            glVertex2f(x, y)
        glEnd()

    return glsim.frame_of(draw, size=32, calls=True)


def test_results_are_one_line(frame: glsim.Frame) -> None:
    assert repr(frame) == "<Frame 32 x 32: 2 packets, 1 draws, 9 calls>"
    assert repr(glsim.trace(frame)) == "<Trace: 7 entries, 1 mistakes: normals-not-unit>"
    assert repr(glsim.probe(frame, 16, 16)).startswith("<Probe (16, 16): pixel (")
    assert "seen is draw 0, triangle 0 of GL_TRIANGLES" in repr(glsim.probe(frame, 16, 16))
    assert repr(glsim.probe(frame, 0, 0)).endswith("0 fragments, seen is the background>")
    lit = int(glsim.terms(frame).lit.sum())
    assert repr(glsim.terms(frame)).startswith(f"<Terms 32 x 32: {lit} pixels covered, {lit} lit, ")
    sheet = glsim.compare("cube", size=32, modes=["flat", "phong"], lobes=["blinn"])
    assert repr(sheet) == "<Comparison cube 32 x 32: flat, phong; blinn>"


def test_jupyter_shows_tables_and_pictures(frame: glsim.Frame) -> None:
    drawn, traced = frame._repr_html_(), glsim.trace(frame)._repr_html_()
    assert "<td>1<td>GL_TRIANGLES, 3 vertices<td>" in drawn
    assert "normals-not-unit" in traced
    assert "glEnable(GL_LIGHTING)" in traced
    for picture in (glsim.terms(frame), glsim.compare("cube", size=32)):
        assert (picture._repr_png_() or b"")[:8] == b"\x89PNG\r\n\x1a\n"
    assert "frac" in glsim.probe(frame, 16, 16)._repr_latex_() or "$" in glsim.probe(frame, 16, 16)._repr_latex_()
    assert "&lt;script&gt;" in html(Text("<script>"))
