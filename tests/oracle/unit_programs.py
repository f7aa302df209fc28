"""Several texture units, GL_COMBINE, generated coordinates."""

from __future__ import annotations

from functools import partial

import numpy as np

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material
from tests.oracle.programs import PROGRAMS, program
from tests.oracle.texture_programs import filters, texels, upload


def two_units(number: int = 2) -> None:
    """Different small textures on the first units, all enabled."""
    glClearColor(0.2, 0.3, 0.4, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    for unit in range(number):
        glActiveTexture(GL_TEXTURE0 + unit)
        glBindTexture(GL_TEXTURE_2D, 10 + unit)
        upload(texels(4 + unit, 4))
        filters()
        glEnable(GL_TEXTURE_2D)


def multi_square(units: int = 2) -> None:
    glColor4f(0.8, 0.7, 0.9, 0.6)
    glBegin(GL_QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        for unit in range(units):
            glMultiTexCoord2f(GL_TEXTURE0 + unit, s * (1 + 0.3 * unit), t * (1 - 0.2 * unit))
        glVertex2f(1.8 * s - 0.9, 1.8 * t - 0.9)
    glEnd()


for _first in (GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD):
    for _second in (GL_MODULATE, GL_DECAL, GL_ADD):

        @partial(PROGRAMS.__setitem__, f"two_units_{_first.name[3:].lower()}_{_second.name[3:].lower()}")
        def _two(first: int = _first, second: int = _second) -> None:
            two_units()
            for unit, mode in ((0, first), (1, second)):
                glActiveTexture(GL_TEXTURE0 + unit)
                glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode)
                glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [0.2, 0.7, 0.4 + unit / 3, 0.5])
            multi_square()


@program
def four_units() -> None:
    two_units(4)
    for unit in (1, 2, 3):
        glActiveTexture(GL_TEXTURE0 + unit)
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD if unit % 2 else GL_DECAL)
    multi_square(4)


@program
def a_unit_with_a_matrix_of_its_own() -> None:
    two_units()
    glMatrixMode(GL_TEXTURE)
    glActiveTexture(GL_TEXTURE1)
    glRotatef(30, 0, 0, 1)
    glScalef(2, 1, 1)
    glActiveTexture(GL_TEXTURE0)
    glTranslatef(0.3, 0.1, 0)
    glMatrixMode(GL_MODELVIEW)
    multi_square()


@program
def second_unit_alone() -> None:
    two_units()
    glActiveTexture(GL_TEXTURE0)
    glDisable(GL_TEXTURE_2D)
    multi_square()


@program
def units_from_arrays() -> None:
    two_units()
    points = np.array([(-0.9, -0.9), (0.9, -0.8), (0.8, 0.9), (-0.8, 0.7)], "f4")
    glEnableClientState(GL_VERTEX_ARRAY)
    glVertexPointer(2, GL_FLOAT, 0, points)
    for unit in range(2):
        glClientActiveTexture(GL_TEXTURE0 + unit)
        glEnableClientState(GL_TEXTURE_COORD_ARRAY)
        glTexCoordPointer(2, GL_FLOAT, 0, points * (0.5 + unit))
    glDrawArrays(GL_POLYGON, 0, 4)
    for unit in range(2):
        glClientActiveTexture(GL_TEXTURE0 + unit)
        glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    glClientActiveTexture(GL_TEXTURE0)


@program
def units_in_a_list() -> None:
    two_units()
    glNewList(1, GL_COMPILE)
    multi_square()
    glEndList()
    glScalef(0.5, 0.5, 1)
    glTranslatef(-0.9, 0, 0)
    glCallList(1)
    glTranslatef(1.9, 0.3, 0)
    glCallList(1)


@program
def attributes_of_units_are_popped() -> None:
    two_units()
    glPushAttrib(GL_TEXTURE_BIT)
    glActiveTexture(GL_TEXTURE1)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glBindTexture(GL_TEXTURE_2D, 10)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
    glActiveTexture(GL_TEXTURE0)
    glPopAttrib()
    multi_square()


# ---------------------------------------------------------------- GL_COMBINE


def combine(**parameters: int) -> None:
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE)
    for name, value in parameters.items():
        glTexEnvi(GL_TEXTURE_ENV, globals()["GL_" + name.upper()], value)


for _mode in (GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA):

    @partial(PROGRAMS.__setitem__, f"combine_{_mode.name[3:].lower()}")
    def _combine(mode: int = _mode) -> None:
        two_units(1)
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [0.7, 0.2, 0.4, 0.6])
        alpha = mode if mode not in (GL_DOT3_RGB, GL_DOT3_RGBA) else GL_MODULATE
        combine(combine_rgb=mode, combine_alpha=alpha)
        multi_square(1)


for _scale in (2, 4):

    @partial(PROGRAMS.__setitem__, f"combine_scaled_by_{_scale}")
    def _scaled(scale: int = _scale) -> None:
        two_units(1)
        combine(rgb_scale=scale, alpha_scale=scale)
        multi_square(1)


@program
def combine_operands() -> None:
    two_units(1)
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [0.7, 0.2, 0.4, 0.6])
    combine(
        combine_rgb=GL_INTERPOLATE, source0_rgb=GL_CONSTANT, operand0_rgb=GL_ONE_MINUS_SRC_COLOR,
        source1_rgb=GL_PRIMARY_COLOR, operand1_rgb=GL_SRC_ALPHA, source2_rgb=GL_TEXTURE,
        operand2_rgb=GL_ONE_MINUS_SRC_ALPHA, combine_alpha=GL_ADD, source0_alpha=GL_TEXTURE,
        operand0_alpha=GL_ONE_MINUS_SRC_ALPHA, source1_alpha=GL_CONSTANT,
    )  # fmt: skip
    multi_square(1)


@program
def combine_the_unit_before() -> None:
    two_units(3)
    for unit in (1, 2):
        glActiveTexture(GL_TEXTURE0 + unit)
        glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [0.3, 0.6, 0.9, 0.5])
        combine(combine_rgb=GL_INTERPOLATE, combine_alpha=GL_REPLACE, source0_alpha=GL_PREVIOUS)
    multi_square(3)


@program
def combine_across_units() -> None:
    two_units(2)
    glActiveTexture(GL_TEXTURE0)
    combine(combine_rgb=GL_SUBTRACT, source0_rgb=GL_TEXTURE1, source1_rgb=GL_TEXTURE0)
    glActiveTexture(GL_TEXTURE1)
    combine(combine_rgb=GL_ADD_SIGNED, source0_rgb=GL_PREVIOUS, source1_rgb=GL_TEXTURE0)
    multi_square(2)


@program
def combine_lit_and_bumped() -> None:
    """A normal map with GL_DOT3_RGB, as books do bump mapping."""
    glClear(GL_COLOR_BUFFER_BIT)
    bumps = texels(8, 8, 3)
    glBindTexture(GL_TEXTURE_2D, 12)
    upload(bumps, GL_RGB, GL_RGB)
    filters()
    glEnable(GL_TEXTURE_2D)
    combine(combine_rgb=GL_DOT3_RGB, source1_rgb=GL_PRIMARY_COLOR)
    glBegin(GL_QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glColor3f(s, t, 0.9)
        glTexCoord2f(s, t)
        glVertex2f(1.8 * s - 0.9, 1.8 * t - 0.9)
    glEnd()


# ---------------------------------------------------------------- generated coordinates


def generate(modes: dict[int, int], **planes: list[float]) -> None:
    for coordinate, mode in modes.items():
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode)
        glEnable({GL_S: GL_TEXTURE_GEN_S, GL_T: GL_TEXTURE_GEN_T, GL_R: GL_TEXTURE_GEN_R}[coordinate])


def textured_ball(target: int = GL_TEXTURE_2D) -> None:
    glEnable(target)
    lamp()
    material(**SHINY)
    glRotatef(20, 1, 1, 0)
    ball(mode=GL_TRIANGLES)


@program
def texgen_object_linear() -> None:
    camera()
    upload(texels())
    filters()
    glTexGenfv(GL_S, GL_OBJECT_PLANE, [0.5, 0.2, 0, 0.5])
    glTexGenfv(GL_T, GL_OBJECT_PLANE, [0.1, 0.6, 0.3, 0.2])
    generate({GL_S: GL_OBJECT_LINEAR, GL_T: GL_OBJECT_LINEAR})
    textured_ball()


@program
def texgen_eye_linear() -> None:
    camera()
    upload(texels())
    filters()
    glRotatef(40, 0, 0, 1)
    glTexGenfv(GL_S, GL_EYE_PLANE, [0.5, 0.2, 0, 0.5])
    glTexGenfv(GL_T, GL_EYE_PLANE, [0.1, 0.6, 0.3, 0.2])
    generate({GL_S: GL_EYE_LINEAR, GL_T: GL_EYE_LINEAR})
    textured_ball()


@program
def texgen_sphere_map() -> None:
    camera()
    upload(texels(16, 16))
    filters()
    generate({GL_S: GL_SPHERE_MAP, GL_T: GL_SPHERE_MAP})
    textured_ball()


@program
def texgen_sphere_map_normalized_and_unlit() -> None:
    camera()
    upload(texels(16, 16))
    filters()
    generate({GL_S: GL_SPHERE_MAP, GL_T: GL_SPHERE_MAP})
    glEnable(GL_TEXTURE_2D)
    glEnable(GL_NORMALIZE)
    glScalef(0.7, 0.9, 0.8)
    ball(scale=2.5, mode=GL_TRIANGLES)


@program
def texgen_one_coordinate_of_two() -> None:
    camera()
    upload(texels())
    filters()
    glTexGenfv(GL_S, GL_OBJECT_PLANE, [0.7, 0, 0, 0.5])
    generate({GL_S: GL_OBJECT_LINEAR})
    glTexCoord2f(0.3, 0.6)
    textured_ball()


@program
def texgen_in_a_second_unit() -> None:
    two_units()
    camera()
    glActiveTexture(GL_TEXTURE1)
    generate({GL_S: GL_SPHERE_MAP, GL_T: GL_SPHERE_MAP})
    glActiveTexture(GL_TEXTURE0)
    generate({GL_S: GL_OBJECT_LINEAR, GL_T: GL_OBJECT_LINEAR})
    textured_ball()


@program
def texgen_in_a_list() -> None:
    camera(4.0)
    upload(texels())
    filters()
    glEnable(GL_TEXTURE_2D)
    generate({GL_S: GL_OBJECT_LINEAR, GL_T: GL_EYE_LINEAR})
    glNewList(1, GL_COMPILE)
    ball(mode=GL_TRIANGLES)
    glEndList()
    for x in (-0.6, 0.6):
        glPushMatrix()
        glTranslatef(x, x / 2, 0)
        glScalef(0.6, 0.6, 0.6)
        glCallList(1)
        glPopMatrix()
