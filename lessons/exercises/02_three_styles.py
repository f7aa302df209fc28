r"""The same torus in three styles, in three viewports of 128 x 128 pixels from left to right: as a **wireframe**, with **hidden lines
removed**, and **filled**, with light. A fragment is kept where

$$ z + o < z_\mathrm{buffer}(x, y), \qquad o = m \cdot \mathrm{factor} + r \cdot \mathrm{units} $$

$o$ is the offset of `glPolygonOffset(factor, units)`: $m$ is the slope of the polygon, $r$ the smallest step of the depth buffer.

- Lines are `INK`, one pixel wide, and not lit; the background is `PAPER`. Edges are drawn by `glPolygonMode`.
- In the middle nothing of an edge is seen that lies behind the torus itself; faces show the paper. Push the faces away from the eye
  with factor 1 and units 1, so that they do not hide their own edges.
- On the right the torus is lit by `GL_LIGHT0` as it is, with the diffuse and ambient reflectance `CLAY`.

Complete `display()`; `torus()` places the torus and draws it, without colour and without style.
"""

from collections.abc import Callable

import numpy as np

from glsim.course.exercise import Definition, Drawn, Picture
from glsim.machine import constants as gl
from glsim.machine.frame import Draw, Frame

STARTER = """\
from glsim.gl import *
from glsim.glu import *
from glsim.glut import *

PAPER = (0.95, 0.95, 0.9)
INK = (0.1, 0.1, 0.4)
CLAY = (0.8, 0.5, 0.2)


def torus():
    glLoadIdentity()
    gluLookAt(0, 3, 5, 0, 0, 0, 0, 1, 0)
    glRotatef(20, 1, 0, 0)
    glutSolidTorus(0.5, 1.2, 10, 18)


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glViewport(0, 0, 128, 128)
    glColor3fv(INK)
    torus()
    glViewport(128, 0, 128, 128)
    torus()
    glViewport(256, 0, 128, 128)
    torus()
    glutSwapBuffers()


glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(384, 128)
glutCreateWindow("Three styles")
glClearColor(*PAPER, 1)
glMatrixMode(GL_PROJECTION)
gluPerspective(35, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
"""

PAPER, INK, CLAY = (0.95, 0.95, 0.9), (0.1, 0.1, 0.4), (0.8, 0.5, 0.2)


def alike(a, b) -> bool:
    return bool(np.allclose(a, b, rtol=0, atol=2e-3))


def color(draw: Draw):
    """The colour of a Draw that is not lit: that of its first vertex."""
    return (
        draw.color[:3] if draw.color is not None else draw.block.rows[draw.first, 6:9]
    )


LINES = (gl.GL_LINES, gl.GL_LINE_STRIP, gl.GL_LINE_LOOP)


def mode(draw: Draw, back: bool = False) -> int:
    """How polygons are drawn that are seen from the front (or from behind); GL_LINE for lines."""
    polygon = draw.state.polygon
    return (
        gl.GL_LINE
        if draw.mode in LINES
        else polygon.back_mode
        if back
        else polygon.front_mode
    )


def column(
    number: int, what: str, judge: Callable[[list[Draw]], str | None]
) -> Callable[[Frame], str | None]:
    """Judges the Draws of one viewport."""

    def judged(frame: Frame) -> str | None:
        draws = [
            draw
            for draw in frame.draws
            if draw.count
            and tuple(draw.state.viewport[:4]) == (128 * number, 0, 128, 128)
        ]
        return (
            judge(draws)
            if draws
            else f"Nothing is drawn in the viewport {what}: ({128 * number}, 0, 128, 128)."
        )

    return judged


def edges(draws: list[Draw]) -> str | None:
    """What is wrong with the lines among some Draws."""
    if not draws:
        return "No lines are drawn here: polygons are filled unless glPolygonMode says otherwise."
    for draw in draws:
        if mode(draw, back=True) != gl.GL_LINE and not draw.state.polygon.cull:
            return "Polygons seen from behind are not drawn as lines: glPolygonMode takes the side first."
        if draw.state.lighting.enabled:
            return "The lines are lit: they have the colour of glColor only while lighting is off."
        if not alike(color(draw), INK):
            return "The lines have not the colour INK."
        if draw.state.line.width != 1:
            return "The lines are not one pixel wide."
    return None


def wireframe(draws: list[Draw]) -> str | None:
    if any(mode(draw) == gl.GL_FILL for draw in draws):
        return "The torus on the left is filled: a wireframe has edges alone."
    if any(draw.state.polygon.cull for draw in draws):
        return "Faces seen from behind are left out; a wireframe shows all edges."
    return edges([draw for draw in draws if mode(draw) == gl.GL_LINE])


def hidden(draws: list[Draw]) -> str | None:
    lines = [draw for draw in draws if mode(draw) == gl.GL_LINE]
    faces = [draw for draw in draws if mode(draw) == gl.GL_FILL]
    if not lines:
        return edges(lines)
    if not faces:
        if any(draw.state.polygon.cull for draw in lines):
            return "Leaving out what faces away is not enough: a torus hides parts of itself that face the eye."
        return "Nothing hides the lines behind: draw the faces, too, in a way that they cover what is behind and show only paper."
    wrong = edges(lines)
    if wrong:
        return wrong
    if not all(draw.state.depth.test for draw in draws):
        return "The depth test is off: nothing decides what is in front."
    for draw in faces:
        if not draw.state.depth.mask:
            return "The faces do not write their depth: so they hide nothing."
        invisible = not any(draw.state.color_buffer.mask[:3])
        if not invisible and (
            draw.state.lighting.enabled or not alike(color(draw), PAPER)
        ):
            return "The faces must look like the paper."
        polygon = draw.state.polygon
        if not polygon.offset_fill:
            return "Faces and edges have the same depth and fight for the pixels: push the faces away (glPolygonOffset, and enable it for filled polygons)."
        if polygon.offset_factor < 0 or polygon.offset_units < 0:
            return "The offset pulls the faces to the eye: they hide their own edges."
        if (polygon.offset_factor, polygon.offset_units) != (1, 1):
            return "The offset has factor 1 and units 1."
    return None


def filled(draws: list[Draw]) -> str | None:
    for draw in draws:
        lighting, polygon = draw.state.lighting, draw.state.polygon
        if mode(draw) != gl.GL_FILL or polygon.back_mode != gl.GL_FILL:
            return "The torus on the right is drawn as lines: glPolygonMode keeps its value until it is set again."
        if not lighting.enabled:
            return "Without light the torus on the right is a silhouette."
        if not lighting.light_enabled[0]:
            return "Lighting is on, but no lamp: GL_LIGHT0 must be enabled."
        if not draw.state.depth.test:
            return "The depth test is off: what is drawn later covers what is nearer."
        front = draw.material.front
        tracked = (
            lighting.color_material
            and lighting.color_material_mode == gl.GL_AMBIENT_AND_DIFFUSE
        )
        given = (
            (color(draw), color(draw))
            if tracked
            else (front.ambient[:3], front.diffuse[:3])
        )
        if alike(given[1], (0.8, 0.8, 0.8)):
            return "The torus on the right is grey: a lit surface takes its colour from its material."
        if not alike(given, [CLAY, CLAY]):
            return "Ambient and diffuse reflectance of the torus on the right must be CLAY."
    return None


EXERCISE = Definition(
    title="Wireframe, hidden lines, filled",
    lesson=2,
    starter=STARTER,
    program=True,
    parts=[
        Drawn("the wireframe, left", column(0, "on the left", wireframe)),
        Drawn("hidden lines removed, middle", column(1, "in the middle", hidden), points=2),
        Drawn("filled, right", column(2, "on the right", filled)),
        Picture("the picture", "02_three_styles.png",
                "Styles and colours are right, but the picture differs: is the window cleared once and with PAPER, and is the"
                " torus drawn by torus() alone?"),
    ],
)  # fmt: skip
