"""Small programs, each about one thing.  ``PROGRAMS`` maps a name to a function that draws in a 128 x 128 picture."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np

from glsim.gl import *
from glsim.gl import GLfloat

PROGRAMS: dict[str, Callable[[], None]] = {}


def program(function: Callable[[], None]) -> Callable[[], None]:
    PROGRAMS[function.__name__] = function
    return function


# ---------------------------------------------------------------- building blocks


def camera(distance: float = 3.0) -> None:
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glFrustum(-0.4, 0.4, -0.4, 0.4, 1.0, 20.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glTranslatef(0.0, 0.0, -distance)
    glEnable(GL_DEPTH_TEST)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)


def lamp(light: int = GL_LIGHT0, position: tuple[float, ...] = (2.0, 2.0, 3.0, 1.0), **parameters: object) -> None:
    glEnable(GL_LIGHTING)
    glEnable(light)
    glPushMatrix()
    glLoadIdentity()
    glLightfv(light, GL_POSITION, position)
    glPopMatrix()
    for name, value in parameters.items():
        glLight(light, globals()["GL_" + name.upper()], value)


def material(face: int = GL_FRONT_AND_BACK, **parameters: object) -> None:
    for name, value in parameters.items():
        glMaterial(face, globals()["GL_" + name.upper()], value)


SHINY = dict(ambient=(0.1, 0.1, 0.1, 1), diffuse=(0.7, 0.3, 0.2, 1), specular=(0.6, 0.6, 0.6, 1), shininess=20.0)


QUAD = ((0, 0), (1, 0), (1, 1), (0, 1))
TWO_TRIANGLES = (QUAD[0], QUAD[1], QUAD[2], QUAD[0], QUAD[2], QUAD[3])


def ball(slices: int = 20, stacks: int = 14, radius: float = 1.0, scale: float = 1.0, mode: int = GL_QUADS) -> None:
    """A sphere with normals of length ``scale``.

    Mesa cuts a quad along v0-v2, but along v1-v3 if it must be clipped or has two sides: for those, GL_TRIANGLES.
    """

    def point(i: int, j: int) -> tuple[float, float, float]:
        theta, phi = math.pi * i / stacks, 2 * math.pi * j / slices
        return math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi)

    glBegin(mode)
    for i in range(stacks):
        for j in range(slices):
            for a, b in QUAD if mode == GL_QUADS else TWO_TRIANGLES:
                x, y, z = point(i + a, j + b)
                glNormal3f(x * scale, y * scale, z * scale)
                glVertex3f(x * radius, y * radius, z * radius)
    glEnd()


def lit_ball(**light: object) -> None:
    camera()
    lamp(**light)  # type: ignore[arg-type]
    material(**SHINY)
    glRotatef(25, 1, 0.5, 0)
    ball()


# ---------------------------------------------------------------- primitives x shade model x entry path

MODES = (
    GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_LINE_LOOP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
    GL_QUAD_STRIP, GL_POLYGON,
)  # fmt: skip


def vertices_for(mode: int) -> tuple[np.ndarray, np.ndarray]:
    """Positions and colours of about a dozen vertices that make sensible primitives of a mode."""
    rng = np.random.default_rng(int(mode) + 5)
    if mode in (GL_LINE_LOOP, GL_TRIANGLE_FAN, GL_POLYGON):
        angle = np.arange(9) * 2 * np.pi / 9
        points = np.stack([0.8 * np.cos(angle), 0.7 * np.sin(angle), 0 * angle], 1)
    elif mode in (GL_TRIANGLE_STRIP, GL_QUAD_STRIP, GL_LINE_STRIP):
        k = np.arange(11)
        points = np.stack([k / 6 - 0.83, np.where(k % 2, 0.6, -0.55) + 0.03 * k, 0 * k], 1)
        if mode == GL_QUAD_STRIP:
            points[:, 0] = (k // 2) / 3 - 0.8
    elif mode == GL_QUADS:
        corner = np.array([(0, 0), (0.7, 0), (0.7, 0.7), (0, 0.7)])
        offsets = ((-0.85, -0.8), (0.1, -0.75), (-0.8, 0.1))
        points = np.concatenate([np.c_[corner + offset, np.zeros(4)] for offset in offsets])
    else:
        points = np.c_[rng.uniform(-0.9, 0.9, (12, 2)), np.zeros(12)]
    colors = np.c_[rng.uniform(0.2, 1.0, (len(points), 3)), np.ones(len(points))]
    if mode in (GL_QUADS, GL_QUAD_STRIP, GL_POLYGON):
        # colours that are linear in x and y look the same however the polygon is cut into triangles: how is not
        # specified, and Mesa itself cuts glDrawElements' quads and strips along the other diagonal
        colors[:, :3] = 0.5 + 0.3 * points[:, [0, 1, 0]] * (1, 1, -1)
    return points.astype("f4"), colors.astype("f4")


def draw_primitive(mode: int, shade: int, path: str) -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glShadeModel(shade)
    points, colors = vertices_for(mode)
    if path == "begin":
        glBegin(mode)
        for p, c in zip(points.tolist(), colors.tolist()):
            glColor4fv(c)
            glVertex3fv(p)
        glEnd()
        return
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, points)
    glColorPointer(4, GL_FLOAT, 0, colors)
    if path == "arrays":
        glDrawArrays(mode, 0, len(points))
    else:
        order = np.arange(len(points), dtype=np.uint16)
        glDrawElements(mode, len(points), GL_UNSIGNED_SHORT, order)


for _mode in MODES:
    for _shade in (GL_FLAT, GL_SMOOTH):
        for _path in ("begin", "arrays", "elements"):
            _name = f"{_mode.name[3:]}_{_shade.name[3:]}_{_path}".lower()
            PROGRAMS[_name] = partial(draw_primitive, _mode, _shade, _path)


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


# ---------------------------------------------------------------- materials


def wheel(inside: Callable[[int], None], mode: int = GL_TRIANGLE_STRIP) -> None:
    """A lit ring; ``inside(k)`` is called before each pair of vertices."""
    glBegin(mode)
    for k in range(25):
        a = k * math.pi / 12
        inside(k)
        glNormal3f(0.4 * math.cos(a), 0.4 * math.sin(a), 0.83)
        glVertex3f(math.cos(a), math.sin(a), 0)
        glVertex3f(0.4 * math.cos(a), 0.4 * math.sin(a), 0.3)
    glEnd()


def material_inside(k: int) -> None:
    if k % 4 == 0:
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 25, 1 - k / 25, 0.5, 1.0])
    if k % 6 == 0:
        glMaterialf(GL_FRONT, GL_SHININESS, 5.0 + k)


for _shade in (GL_FLAT, GL_SMOOTH):

    @partial(PROGRAMS.__setitem__, f"material_changes_inside_begin_{_shade.name[3:].lower()}")
    def _material_changes(shade: int = _shade) -> None:
        glShadeModel(shade)
        camera()
        lamp()
        material(**SHINY)
        wheel(material_inside)


@program
def material_changes_in_quads() -> None:
    camera()
    lamp()
    glBegin(GL_QUADS)
    glNormal3f(0, 0, 1)
    for k in range(16):
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [k % 4 / 3, k // 4 / 3, 0.4, 1.0])
        x, y = k % 4 / 2 - 1, k // 4 / 2 - 1
        for dx, dy in ((0, 0), (0.45, 0), (0.45, 0.45), (0, 0.45)):
            glVertex2f(x + dx, y + dy)
    glEnd()


@program
def material_at_every_vertex() -> None:
    """More materials in one glBegin than a uniform block has rows."""
    camera()
    lamp()
    glBegin(GL_TRIANGLE_FAN)
    glNormal3f(0, 0, 1)
    glMaterialfv(GL_FRONT, GL_EMISSION, [0.3, 0.1, 0.2, 1.0])
    glVertex3f(0, 0, 0)
    for k in range(301):
        a = k * math.pi / 150
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k / 301, 1 - k / 301, k % 10 / 10, 1.0])
        glVertex3f(math.cos(a), math.sin(a), 0)
    glEnd()


COLOR_MATERIALS = (GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE, GL_SPECULAR, GL_EMISSION)
for _mode in COLOR_MATERIALS:

    @partial(PROGRAMS.__setitem__, f"color_material_{_mode.name[3:].lower()}")
    def _color_material(mode: int = _mode) -> None:
        camera()
        lamp(ambient=(0.3, 0.3, 0.3, 1))
        material(**SHINY)
        glColorMaterial(GL_FRONT, mode)
        glEnable(GL_COLOR_MATERIAL)
        wheel(lambda k: glColor3f(k / 25, 1 - k / 25, 0.5))


@program
def color_material_back_only() -> None:
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    glColorMaterial(GL_BACK, GL_DIFFUSE)
    glColor3f(0.9, 0.8, 0.1)
    glEnable(GL_COLOR_MATERIAL)
    bowl()


@program
def color_material_keeps_the_last_color() -> None:
    camera()
    lamp()
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(0.1, 0.9, 0.3)
    glDisable(GL_COLOR_MATERIAL)
    glColor3f(1.0, 0.0, 0.0)
    ball()


@program
def color_material_takes_the_color_at_once() -> None:
    camera()
    lamp()
    glColor3f(0.9, 0.2, 0.8)
    glEnable(GL_COLOR_MATERIAL)
    ball()


@program
def integer_parameters() -> None:
    camera()
    lamp()
    most = 2**31 - 1
    glLightiv(GL_LIGHT0, GL_DIFFUSE, [most, most // 2, most // 4, most])
    glLightiv(GL_LIGHT0, GL_POSITION, [1, 2, 1, 1])
    glMaterialiv(GL_FRONT, GL_SPECULAR, [most // 3, most, most // 2, most])
    glMateriali(GL_FRONT, GL_SHININESS, 12)
    ball()


# ---------------------------------------------------------------- entry paths


def lit_arrays(draw: Callable[[np.ndarray], None]) -> None:
    camera()
    lamp()
    material(**SHINY)
    theta, phi = np.meshgrid(np.linspace(0, np.pi, 15), np.linspace(0, 2 * np.pi, 21), indexing="ij")
    points = np.stack([np.sin(theta) * np.cos(phi), np.cos(theta), np.sin(theta) * np.sin(phi)], 2).reshape(-1, 3)
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_NORMAL_ARRAY)
    draw(points)


def grid_indices(rows: int = 14, columns: int = 20, dtype: str = "u4") -> np.ndarray:
    """Two triangles for each cell of a grid of points."""
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    a = (i * (columns + 1) + j).ravel()
    b = a + columns + 1
    return np.stack([a, b, b + 1, a, b + 1, a + 1], 1).astype(dtype).ravel()


@program
def arrays_of_doubles() -> None:
    def draw(points: np.ndarray) -> None:
        glVertexPointer(3, GL_DOUBLE, 0, points)
        glNormalPointer(GL_DOUBLE, 0, points)
        indices = grid_indices()
        glDrawElements(GL_TRIANGLES, len(indices), GL_UNSIGNED_INT, indices)

    lit_arrays(draw)


@program
def arrays_with_stride_and_shorts_as_normals() -> None:
    def draw(points: np.ndarray) -> None:
        mixed = np.zeros(len(points), [("p", "f4", 3), ("n", "i2", 4)])
        mixed["p"], mixed["n"][:, :3] = points, np.round(points * 32767)
        memory = mixed.tobytes()
        glVertexPointer(3, GL_FLOAT, 20, memory)
        glNormalPointer(GL_SHORT, 20, memory[12:])
        indices = grid_indices(dtype="u2")
        glDrawRangeElements(GL_TRIANGLES, 0, len(points) - 1, len(indices), GL_UNSIGNED_SHORT, indices)

    lit_arrays(draw)


@program
def arrays_interleaved() -> None:
    def draw(points: np.ndarray) -> None:
        glInterleavedArrays(GL_N3F_V3F, 0, np.concatenate([points, points], 1).astype("f4"))
        indices = grid_indices()
        glDrawElements(GL_TRIANGLES, len(indices), GL_UNSIGNED_INT, indices)

    lit_arrays(draw)


@program
def arrays_by_element() -> None:
    def draw(points: np.ndarray) -> None:
        glVertexPointer(3, GL_FLOAT, 0, points.astype("f4"))
        glNormalPointer(GL_FLOAT, 0, points.astype("f4"))
        glBegin(GL_TRIANGLES)
        for i in grid_indices():
            glArrayElement(int(i))
        glEnd()

    lit_arrays(draw)


@program
def arrays_homogeneous_and_colors_of_bytes() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    points = np.array([(-1.2, -1, 0, 2), (0.9, -0.7, 0, 1), (0.3, 0.4, 0, 0.5), (-0.5, 0.7, 0, 1)], "f4")
    colors = np.array([(255, 0, 0, 255), (0, 200, 30, 255), (90, 0, 255, 255), (255, 255, 0, 255)], "u1")
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_COLOR_ARRAY)
    glVertexPointer(4, GL_FLOAT, 0, points)
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors)
    glDrawArrays(GL_POLYGON, 0, 4)


@program
def suffix_variants() -> None:
    """One triangle for each kind of colour and vertex call."""
    glClear(GL_COLOR_BUFFER_BIT)
    colors = (
        (glColor3b, (127, -20, 60)), (glColor3s, (32767, 10000, -5)), (glColor3i, (2**31 - 1, 2**30, 0)),
        (glColor3f, (0.5, 0.25, 1.0)), (glColor3d, (0.1, 0.9, 0.3)), (glColor3ub, (255, 128, 7)),
        (glColor3us, (65535, 300, 40000)), (glColor3ui, (2**32 - 1, 2**31, 2**30)),
        (glColor4f, (0.5, 0.25, 1.0, 0.5)), (glColor4ub, (25, 128, 200, 255)),
    )  # fmt: skip
    vertices = (glVertex2i, glVertex2f, glVertex2d, glVertex2s)
    glOrtho(0, 40, 0, 40, -1, 1)
    for k, (color, values) in enumerate(colors):
        color(*values)
        vertex = vertices[k % 4]
        x, y = 2 + 12 * (k % 3), 1 + 9 * (k // 3)
        glBegin(GL_TRIANGLES)
        vertex(x, y)
        vertex(x + 10, y)
        vertex(x + 4, y + 7)
        glEnd()


@program
def vector_variants() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glBegin(GL_TRIANGLES)
    glColor3ubv([200, 100, 50])
    glVertex3fv((-0.9, -0.9, 0.0))
    glColor4fv(np.array([0.1, 0.8, 0.3, 1.0], "f4"))
    glVertex2dv([0.8, -0.7])
    glColor3dv((GLfloat * 3)(0.9, 0.1, 0.9))
    glVertex4f(0.2, 1.2, 0.0, 1.5)
    glEnd()


@program
def rectangles() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glColor3f(0.9, 0.5, 0.1)
    glRectf(-0.83, -0.71, 0.11, 0.23)
    glColor3f(0.1, 0.6, 0.8)
    glRectd(0.3, 0.3, 0.7, 0.9)
    glRectfv([-0.5, 0.5], [-0.2, 0.8])


@program
def incomplete_primitives() -> None:
    """Vertices that make no whole primitive are ignored."""
    glClear(GL_COLOR_BUFFER_BIT)
    for k, mode in enumerate(MODES):
        for count in (2, 3, 5, 7):  # with 0 or 1 Mesa 22.3.6 drops what follows; see gl/test_vertex.py
            glBegin(mode)
            for j in range(count):
                x = -0.95 + 0.19 * k + 0.08 * (j % 2)
                glColor3f(0.3 + 0.1 * j, 1 - 0.1 * k, 0.4)
                glVertex2f(x, -0.9 + count * 0.23 + 0.1 * (j // 2) + 0.0113 * j)
            glEnd()


# ---------------------------------------------------------------- matrices, clipping, depth, culling, masks


@program
def clipped_by_every_plane_flat() -> None:
    glShadeModel(GL_FLAT)
    clipped()


@program
def clipped_by_every_plane_smooth() -> None:
    clipped()


def clipped() -> None:
    camera(2.0)
    rng = np.random.default_rng(3)
    for mode in (GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINES, GL_LINE_LOOP, GL_POINTS):
        glBegin(mode)
        for _ in range(12):
            glColor3f(*rng.uniform(0.2, 1, 3))
            glVertex3f(*(rng.uniform(-1, 1, 3) * (2.5, 2.5, 4)))
        glEnd()
    glBegin(GL_POLYGON)
    glColor3f(0.9, 0.4, 0.2)
    for k in range(6):
        glVertex3f(3 * math.cos(k), 3 * math.sin(k), 1.2 * math.cos(k))
    glEnd()


@program
def near_plane_cuts_a_lit_polygon() -> None:
    camera(1.3)
    lamp()
    glRotatef(70, 1, 0, 0)
    glBegin(GL_POLYGON)
    for k in range(8):
        glNormal3f(0, 0.1 * k, 1)
        glVertex3f(1.5 * math.cos(k * math.pi / 4), 1.5 * math.sin(k * math.pi / 4), 0)
    glEnd()


@program
def matrix_stack() -> None:
    camera(5.0)
    lamp()
    for k in range(5):
        glPushMatrix()
        glRotatef(72 * k, 0, 0, 1)
        glTranslatef(1.3, 0, 0)
        glRotatef(20 * k, 1, 1, 0)
        glScalef(0.4, 0.4, 0.4)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.2 * k, 0.5, 1 - 0.2 * k, 1])
        ball(12, 8)
        glPopMatrix()


@program
def load_and_multiply() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadMatrixd(np.diag([0.9, 0.8, 1.0, 1.0]))
    glMatrixMode(GL_MODELVIEW)
    glLoadTransposeMatrixf([[1, 0, 0, 0.1], [0, 1, 0, -0.2], [0, 0, 1, 0], [0, 0, 0, 1]])
    glMultMatrixd([0.8, 0.3, 0, 0, -0.3, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
    glMultTransposeMatrixd([1, 0.2, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1])
    glRotated(33.0, 0.0, 0.0, -2.0)
    glBegin(GL_TRIANGLE_FAN)
    for k in range(7):
        glColor3f(k / 7, 0.5, 1 - k / 7)
        glVertex2d(0.8 * math.cos(k), 0.8 * math.sin(k))
    glEnd()


@program
def rotations() -> None:
    """About each axis and its opposite, and about others."""
    glClear(GL_COLOR_BUFFER_BIT)
    axes = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -3, 0), (0, 0, 1), (0, 0, -1), (1, 2, 3), (-1, 0.5, 0), (0, 1, 1)]
    for k, axis in enumerate(axes):
        glLoadIdentity()
        glTranslatef(k % 3 * 0.62 - 0.62, k // 3 * 0.62 - 0.62, 0)
        glRotatef(20 + 31 * k, *axis)
        glColor3f(1 - k / 9, 0.4, k / 9)
        glRectf(-0.25, -0.15, 0.25, 0.15)


@program
def ortho_and_viewport() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glViewport(20, 10, 90, 100)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-3, 5, -2, 4, -1, 7)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0.5, 0.5, -2)
    ball(12, 8)


@program
def depth_range_and_functions() -> None:
    glClearDepth(0.7)
    camera()
    glDisable(GL_DEPTH_TEST)
    glClear(GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    functions = (GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS)
    for k, function in enumerate(functions):
        glDepthRange(0.1 * k, 1 - 0.03 * k)
        glDepthFunc(function)
        glColor3f(1 - k / 8, k / 8, 0.5)
        glBegin(GL_TRIANGLES)
        glVertex3f(-1.2 + 0.2 * k, -1, 1.5)
        glVertex3f(-0.2 + 0.2 * k, -0.9, -2)
        glVertex3f(-0.8 + 0.2 * k, 1.2, -0.5)
        glEnd()


@program
def depth_mask() -> None:
    camera()
    glDepthMask(GL_FALSE)
    glColor3f(1, 0, 0)
    glRectf(-0.7, -0.7, 0.3, 0.3)
    glDepthMask(GL_TRUE)
    glTranslatef(0, 0, -1)
    glColor3f(0, 1, 0)
    glRectf(-0.3, -0.3, 0.9, 0.9)


@program
def color_mask() -> None:
    glClearColor(0.2, 0.3, 0.4, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE)
    glColor3f(1, 1, 0)
    glRectf(-0.7, -0.7, 0.3, 0.3)
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE)
    glRectf(-0.3, -0.3, 0.9, 0.9)


for _front in (GL_CCW, GL_CW):
    for _cull in (GL_FRONT, GL_BACK, GL_FRONT_AND_BACK):

        @partial(PROGRAMS.__setitem__, f"cull_{_cull.name[3:]}_{_front.name[3:]}".lower())
        def _culling(front: int = _front, cull: int = _cull) -> None:
            camera(1.8)
            glEnable(GL_CULL_FACE)
            glCullFace(cull)
            glFrontFace(front)
            lamp()
            glEnable(GL_COLOR_MATERIAL)
            glColor3f(0.3, 0.8, 0.6)
            ball(mode=GL_TRIANGLES)
            glNormal3f(0, 0, 1)
            glBegin(GL_LINES)
            glVertex3f(-0.5, 0.2, 0.6)
            glVertex3f(0.2, 0.1, 0.6)
            glEnd()


@program
def many_objects() -> None:
    """More objects than a uniform block has rows."""
    camera(6.0)
    lamp()
    for k in range(400):
        glPushMatrix()
        glTranslatef(k % 20 * 0.22 - 2.1, k // 20 * 0.22 - 2.1, 0)
        glRotatef(k, 1, 1, 0)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [k % 20 / 20, k // 20 / 20, 0.5, 1])
        glBegin(GL_QUADS)
        glNormal3f(0, 0, 1)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            glVertex2f(0.1 * x, 0.1 * y)
        glEnd()
        glPopMatrix()


@program
def mixed_primitives_in_order() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    rng = np.random.default_rng(11)
    for k in range(30):
        glShadeModel(GL_FLAT if k % 3 else GL_SMOOTH)
        glBegin(MODES[k % 10])
        for _ in range(4 + k % 5):
            glColor3fv(rng.uniform(0.2, 1, 3))
            glVertex2fv(rng.uniform(-0.9, 0.9, 2))
        glEnd()


# ---------------------------------------------------------------- coordinates exactly on or between pixels


def pixel_coordinates(shift: float) -> None:
    """A coordinate system of pixels, as two-dimensional programs use it."""
    glClear(GL_COLOR_BUFFER_BIT)
    glOrtho(0, 128, 0, 128, -1, 1)
    glTranslatef(shift, shift, 0)


@program
def points_between_pixels() -> None:
    pixel_coordinates(0.0)
    glBegin(GL_POINTS)
    for k in range(40):
        glVertex2i(3 * k + 2, k * 7 % 120 + 3)
    glEnd()


@program
def points_on_pixels() -> None:
    pixel_coordinates(0.5)
    glBegin(GL_POINTS)
    for k in range(40):
        glVertex2i(3 * k + 2, k * 7 % 120 + 3)
    glEnd()


@program
def lines_between_pixels() -> None:
    pixel_coordinates(0.0)
    for k in range(10):
        glBegin(GL_LINE_LOOP)
        for x, y in ((5, 5), (12, 5), (12, 100 - 5 * k), (5, 100 - 5 * k)):
            glVertex2i(x + 10 * k, y)
        glEnd()
    glBegin(GL_LINES)
    for k in range(20):
        glVertex2i(4 * k + 2, k * 7 % 120 + 3)
        glVertex2i(k * 37 % 120, 4 * k + 5)
    glEnd()


for _shift in (0.0, 0.5):

    @partial(PROGRAMS.__setitem__, "areas_on_pixels" if _shift else "areas_between_pixels")
    def _areas(shift: float = _shift) -> None:
        pixel_coordinates(shift)
        for k in range(10):
            glRecti(2 + 12 * k, 3 + 10 * k, 9 + 12 * k, 9 + 10 * k)
        glBegin(GL_TRIANGLES)
        for k in range(40):
            x, y = k % 8 * 15 + 3, k // 8 * 24 + 2
            glVertex2i(x, y)
            glVertex2i(x + k * 5 % 13 + 1, y + k * 3 % 7)
            glVertex2i(x + k * 7 % 11, y + 8 + k % 12)
        glEnd()
