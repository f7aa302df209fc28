"""The lighting equation, term by term; normals."""

from __future__ import annotations

import math
from functools import partial

from glsim.gl import *
from tests.drawing import SHINY, ball, camera, lamp, material
from tests.oracle.programs import PROGRAMS, program


def lit_ball(**light: object) -> None:
    camera()
    lamp(**light)  # type: ignore[arg-type]
    material(**SHINY)
    glRotatef(25, 1, 0.5, 0)
    ball()


# ---------------------------------------------------------------- the lighting equation, term by term

BLACK4, WHITE4 = (0.0, 0.0, 0.0, 1.0), (1.0, 1.0, 1.0, 1.0)


def only(**terms: object) -> None:
    """A ball whose material has nothing but the given terms."""
    camera()
    lamp(ambient=(0.3, 0.5, 0.4, 1), diffuse=(1.0, 0.9, 0.8, 1), specular=(0.8, 1.0, 0.9, 1))
    material(ambient=BLACK4, diffuse=BLACK4, specular=BLACK4, emission=BLACK4, shininess=0.0)
    material(**terms)
    ball()


TERMS = {
    "term_emission": dict(emission=(0.2, 0.5, 0.3, 1.0)),
    "term_ambient": dict(ambient=(0.9, 0.6, 0.3, 1.0)),
    "term_diffuse": dict(diffuse=(0.9, 0.6, 0.3, 1.0)),
    "term_specular_n0": dict(specular=(0.9, 0.6, 0.3, 1.0), shininess=0.0),
    "term_specular_n1": dict(specular=(0.9, 0.6, 0.3, 1.0), shininess=1.0),
    "term_specular_n10": dict(specular=(0.9, 0.6, 0.3, 1.0), shininess=10.0),
    "term_specular_n50": dict(specular=WHITE4, shininess=50.0),
    "term_specular_n128": dict(specular=WHITE4, shininess=128.0),
    "term_overexposed": dict(diffuse=(3.0, 2.0, 1.0, 1.0), specular=(4.0, 0.5, 2.0, 1.0), shininess=5.0),
    "term_negative": dict(diffuse=(-0.5, 0.5, 0.2, 1.0), emission=(0.2, 0.1, 0.3, 1.0)),
}
for _name, _terms in TERMS.items():
    PROGRAMS[_name] = partial(only, **_terms)

LIGHTS = {
    "light_default": {},
    "light_directional": dict(position=(1.0, 1.0, 1.0, 0.0)),
    "light_directional_long": dict(position=(10.0, -30.0, 20.0, 0.0)),
    "light_positional_w2": dict(position=(2.0, 3.0, 4.0, 2.0)),
    "light_behind": dict(position=(0.0, 2.0, -4.0, 1.0)),
    "light_inside_scene": dict(position=(0.5, 0.5, -1.7, 1.0)),
    "light_ambient": dict(ambient=(0.9, 0.2, 0.5, 1.0)),
    "light_diffuse": dict(diffuse=(0.2, 0.9, 0.5, 1.0)),
    "light_specular": dict(specular=(0.2, 0.4, 1.0, 1.0)),
    "attenuation_constant": dict(constant_attenuation=2.0),
    "attenuation_linear": dict(linear_attenuation=0.3),
    "attenuation_quadratic": dict(quadratic_attenuation=0.1),
    "attenuation_all": dict(constant_attenuation=0.5, linear_attenuation=0.1, quadratic_attenuation=0.05),
    "attenuation_directional_ignored": dict(position=(1.0, 1.0, 1.0, 0.0), quadratic_attenuation=5.0),
    "spot_45": dict(spot_cutoff=45.0, spot_direction=(-2.0, -2.0, -6.0)),
    "spot_20": dict(spot_cutoff=20.0, spot_direction=(-2.0, -2.0, -5.5)),
    "spot_exponent": dict(spot_cutoff=40.0, spot_direction=(-2.0, -2.0, -5.5), spot_exponent=30.0),
    "spot_90": dict(spot_cutoff=90.0, spot_direction=(-2.0, -1.0, -4.0), spot_exponent=2.0),
    "spot_attenuated": dict(
        spot_cutoff=30.0, spot_direction=(-2.0, -2.0, -5.5), spot_exponent=5.0, linear_attenuation=0.2
    ),
    "spot_directional": dict(
        position=(0.3, 0.4, 1.0, 0.0), spot_cutoff=30.0, spot_direction=(-0.3, -0.4, -1.0), spot_exponent=3.0
    ),
}
for _name, _parameters in LIGHTS.items():
    PROGRAMS[_name] = partial(lit_ball, **_parameters)


@program
def all_eight_lights() -> None:
    camera()
    for k in range(8):
        angle = k * math.pi / 4
        color = (0.3 + 0.1 * (k % 3), 0.3 - 0.02 * k, 0.2 + 0.05 * (k % 2), 1.0)
        position = (3 * math.cos(angle), 3 * math.sin(angle), 2.0, k % 2)
        lamp(GL_LIGHT0 + k, position, diffuse=color, specular=color)
    material(**SHINY)
    ball()


@program
def light_of_higher_number_only() -> None:
    camera()
    lamp(GL_LIGHT5, (2.0, -2.0, 3.0, 1.0), diffuse=(0.3, 0.9, 0.7, 1))
    material(**SHINY)
    ball()


@program
def no_light_enabled() -> None:
    camera()
    glEnable(GL_LIGHTING)
    material(ambient=(0.9, 0.5, 0.2, 1.0), emission=(0.1, 0.0, 0.2, 1.0))
    ball()


@program
def light_moves_with_the_modelview() -> None:
    camera()
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glPushMatrix()
    glRotatef(50, 0, 1, 0)
    glTranslatef(1.0, 1.0, 3.0)
    glLightfv(GL_LIGHT0, GL_POSITION, [0.0, 0.0, 0.0, 1.0])
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, [0.0, -0.2, -1.0])
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25.0)
    glPopMatrix()
    glScalef(1.1, 0.9, 1.0)
    ball()


@program
def directional_light_under_rotation_and_scale() -> None:
    camera()
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glRotatef(70, 1, 0, 0)
    glScalef(2.0, 1.0, 0.5)
    glLightfv(GL_LIGHT0, GL_POSITION, [0.5, 0.5, 1.0, 0.0])
    glScalef(0.5, 1.0, 2.0)
    ball()


@program
def light_model_ambient() -> None:
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.7, 0.1, 0.4, 1.0])
    camera()
    lamp()
    material(ambient=(0.8, 0.9, 0.5, 1.0), diffuse=(0.2, 0.3, 0.5, 1.0))
    ball()


@program
def local_viewer() -> None:
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE)
    lit_ball(position=(0.0, 0.0, 1.0, 0.0))


@program
def separate_specular_color() -> None:
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)
    camera()
    lamp()
    material(diffuse=(0.9, 0.8, 0.1, 1), specular=(0.2, 0.3, 0.9, 1.0), shininess=8.0)
    ball()


def bowl() -> None:
    """A sphere cut open by the near plane, so that its inside shows."""
    camera(1.6)
    lamp(position=(0.2, 0.5, 0.5, 1.0))
    material(GL_FRONT, **SHINY)
    material(GL_BACK, ambient=(0, 0.2, 0.1, 1), diffuse=(0.1, 0.6, 0.7, 1), specular=(0.5, 0.2, 0.5, 1), shininess=9.0)
    glRotatef(15, 1, 0, 0)
    ball(mode=GL_TRIANGLES)


@program
def inside_one_sided() -> None:
    bowl()


@program
def inside_two_sided() -> None:
    glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1.0)
    bowl()


@program
def inside_two_sided_flat() -> None:
    glShadeModel(GL_FLAT)
    glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1.0)
    bowl()


@program
def inside_two_sided_separate_specular() -> None:
    glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1.0)
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)
    bowl()


@program
def two_sided_clockwise() -> None:
    glLightModelf(GL_LIGHT_MODEL_TWO_SIDE, 1.0)
    glFrontFace(GL_CW)
    bowl()


# ---------------------------------------------------------------- normals


@program
def normals_scaled_by_modelview() -> None:
    camera()
    lamp()
    material(**SHINY)
    glScalef(0.5, 0.5, 0.5)
    ball(radius=2.0)


@program
def normals_normalize() -> None:
    glEnable(GL_NORMALIZE)
    camera()
    lamp()
    material(**SHINY)
    glScalef(0.4, 0.9, 1.4)
    ball(scale=3.0)


@program
def normals_rescale() -> None:
    glEnable(GL_RESCALE_NORMAL)
    camera()
    lamp()
    material(**SHINY)
    glScalef(0.6, 0.6, 0.6)
    ball(radius=1.5)


@program
def normals_not_unit() -> None:
    camera()
    lamp()
    material(**SHINY)
    ball(scale=1.7)


@program
def normals_under_shear() -> None:
    glEnable(GL_NORMALIZE)
    camera()
    lamp()
    material(**SHINY)
    glMultMatrixf([1, 0.2, 0, 0, 0.5, 1, 0, 0, 0, -0.3, 1, 0, 0, 0, 0, 1])
    ball(radius=0.8)


@program
def normals_mirrored() -> None:
    camera()
    lamp()
    material(**SHINY)
    glScalef(-1.0, 1.0, 1.0)
    ball()
