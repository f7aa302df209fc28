"""What the tests of whole runs share: an outside project with a picture."""

from __future__ import annotations

from pathlib import Path

import pytest

BALL = """
    import numpy as np
    def test_ball(gl_snapshot):
        picture = np.full((20, 30, 3), [200, 100, {blue}], np.uint8)
        gl_snapshot(picture)
"""
DRAWN = """
    import pytest
    import glsim
    from glsim.gl import *
    def draw():
        glClearColor(0.0, 0.0, 1.0, 1.0)
        glClear(GL_COLOR_BUFFER_BIT)
        glBegin(GL_TRIANGLES)
        for x, y in ((-0.8, -0.8), (0.8, -0.8), (0.0, 0.8)):
            glVertex2f(x, y)
        glEnd()
"""


def ball(project: pytest.Pytester, blue: int = 0, more: str = "") -> None:
    project.makepyfile(test_ball=BALL.replace("{blue}", str(blue)) + more)


def png(project: pytest.Pytester, name: str = "test_ball", file: str = "test_ball") -> Path:
    return project.path / "__gl_snapshots__" / file / f"{name}.png"
