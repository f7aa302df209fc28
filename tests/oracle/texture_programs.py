"""Textures: formats, environments, wrapping, filters, matrices, entry paths."""

from __future__ import annotations

from functools import partial

import numpy as np

from glsim.gl import *
from tests.drawing import SHINY, camera, lamp, material
from tests.oracle.programs import PROGRAMS, program

# Where a texel begins is a matter of the last bit, so pictures with sharp texels may differ in single pixels there.


def texels(width: int = 8, height: int = 8, components: int = 4) -> np.ndarray:
    rng = np.random.default_rng(width * 100 + height * 10 + components)
    return rng.integers(0, 256, (height, width, components), np.uint8)


def upload(data: np.ndarray, internal: int = GL_RGBA, format: int = GL_RGBA, level: int = 0) -> None:
    height, width = data.shape[:2]
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexImage2D(GL_TEXTURE_2D, level, internal, width, height, 0, format, GL_UNSIGNED_BYTE, data)


def filters(minify: int = GL_LINEAR, magnify: int = GL_LINEAR) -> None:
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify)


def square(low: float = 0.0, high: float = 1.0, size: float = 0.9) -> None:
    glBegin(GL_QUADS)
    for s, t, x, y in ((low, low, -1, -1), (high, low, 1, -1), (high, high, 1, 1), (low, high, -1, 1)):
        glTexCoord2f(s, t)
        glVertex2f(size * x, size * y)
    glEnd()


FORMATS = {
    "alpha": (GL_ALPHA, GL_ALPHA, 1),
    "luminance": (GL_LUMINANCE, GL_LUMINANCE, 1),
    "luminance_alpha": (GL_LUMINANCE_ALPHA, GL_LUMINANCE_ALPHA, 2),
    "intensity": (GL_INTENSITY, GL_LUMINANCE, 1),
    "rgb": (GL_RGB, GL_RGB, 3),
    "rgba": (GL_RGBA, GL_RGBA, 4),
}
for _environment in (GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD):
    for _name, _format in FORMATS.items():
        if _environment == GL_DECAL and _name not in ("rgb", "rgba"):
            continue  # undefined

        @partial(PROGRAMS.__setitem__, f"texenv_{_environment.name[3:].lower()}_{_name}")
        def _texenv(environment: int = _environment, format: tuple[int, int, int] = _format) -> None:
            internal, source, components = format
            glClearColor(0.2, 0.3, 0.4, 1)
            glClear(GL_COLOR_BUFFER_BIT)
            glEnable(GL_TEXTURE_2D)
            upload(texels(components=components), internal, source)
            filters()
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environment)
            glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [0.8, 0.3, 0.1, 0.5])
            glColor4f(0.4, 0.7, 0.9, 0.8)
            square()


for _wrap in (GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT):

    @partial(PROGRAMS.__setitem__, f"wrap_{_wrap.name[3:].lower()}")
    def _wrapping(wrap: int = _wrap) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_TEXTURE_2D)
        upload(texels())
        filters()
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap)
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE if wrap == GL_REPEAT else wrap)
        glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, [1.0, 0.5, 0.0, 1.0])
        square(-0.8, 1.7)


def receding(minify: int) -> None:
    """A floor that goes away from the viewer, so that every level of the mipmap shows."""
    camera()
    glEnable(GL_TEXTURE_2D)
    colors = [(255, 255, 255), (255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0), (0, 255, 255), (255, 0, 255)]
    for level, color in enumerate(colors):
        size = 64 >> level
        checks = (np.indices((size, size)).sum(axis=0) % 2 * 200 + 55).astype(np.uint8)
        upload((checks[..., None] * (np.array(color) / 255)).astype(np.uint8), GL_RGB, GL_RGB, level)
    filters(minify)
    glTranslatef(0, -0.6, 0)
    glBegin(GL_QUADS)
    for s, t, x, z in ((0, 0, -1.5, 1.5), (4, 0, 1.5, 1.5), (4, 16, 1.5, -12), (0, 16, -1.5, -12)):
        glTexCoord2f(s, t)
        glVertex3f(x, 0, z)
    glEnd()


for _filter in (GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_LINEAR):
    PROGRAMS[f"minify_{_filter.name[3:].lower()}"] = partial(receding, _filter)


@program
def texture_modulates_light() -> None:
    camera()
    lamp()
    material(**SHINY)
    glEnable(GL_TEXTURE_2D)
    upload(texels(16, 4, 3), GL_RGB, GL_RGB)
    filters()
    glRotatef(40, 1, 1, 0)
    glBegin(GL_TRIANGLE_STRIP)
    for k in range(11):
        x = k / 5 - 1
        for y in (-0.7, 0.7):
            glNormal3f(0.5 * x, 0.4 * y, 0.8)
            glTexCoord2d(k / 5, y)
            glVertex3f(x, y, 0.3 * x * x)
    glEnd()


@program
def separate_specular_after_texturing() -> None:
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)
    texture_modulates_light()


@program
def texture_matrix() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    upload(texels())
    filters()
    glMatrixMode(GL_TEXTURE)
    glTranslatef(0.3, 0.1, 0)
    glRotatef(30, 0, 0, 1)
    glScalef(1.5, 0.8, 1)
    glMatrixMode(GL_MODELVIEW)
    square()


@program
def projective_coordinates() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    upload(texels())
    filters()
    glBegin(GL_TRIANGLES)
    for x, y, q in ((-0.9, -0.9, 1.0), (0.9, -0.8, 2.0), (0, 0.9, 0.5)):
        glTexCoord4f(x * q, y * q, 0, q)
        glVertex2f(x, y)
    glEnd()


@program
def one_dimensional_texture() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_1D)
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels(16, 1))
    glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.9, -0.9), (0.9, -0.8), (0, 0.9)):
        glTexCoord1f(x + y / 2)
        glVertex2f(x, y)
    glEnd()


@program
def several_texture_objects() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    for name in (1, 2, 3):
        glBindTexture(GL_TEXTURE_2D, name)
        upload(texels(4 * name, 4))
        filters()
    for k, name in enumerate((2, 1, 3, 2)):
        glBindTexture(GL_TEXTURE_2D, name)
        glPushMatrix()
        glTranslatef(k % 2 - 0.5, k // 2 - 0.5, 0)
        square(size=0.45)
        glPopMatrix()


@program
def a_texture_that_changes_between_draws() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    upload(texels())
    filters()
    glTranslatef(-0.5, 0, 0)
    square(size=0.45)
    part = np.full((3, 4, 4), 255, np.uint8)
    glTexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 4, 3, GL_RGBA, GL_UNSIGNED_BYTE, part)
    glTranslatef(1.0, 0, 0)
    square(size=0.45)


@program
def incomplete_textures_are_off() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    upload(texels())  # the minification filter wants mipmaps, and there are none
    glColor3f(0.2, 0.9, 0.4)
    square()


@program
def generated_mipmap() -> None:
    camera()
    glEnable(GL_TEXTURE_2D)
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE)
    upload(texels(4, 4))  # two levels: each is rounded, by every driver in its way
    filters(GL_LINEAR_MIPMAP_LINEAR)
    glTranslatef(0, 0, -5)
    square(0, 3)


@program
def pixel_store() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    filters()
    data = texels(13, 12, 3)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 13)
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 3)
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 4)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_BGR, GL_UNSIGNED_BYTE, data)
    square()


for _type, _dtype in ((GL_FLOAT, "f4"), (GL_UNSIGNED_SHORT, "u2"), (GL_SHORT, "i2"), (GL_INT, "i4")):

    @partial(PROGRAMS.__setitem__, f"texels_of_{_type.name[3:].lower()}")
    def _types(type: int = _type, dtype: str = _dtype) -> None:
        glClear(GL_COLOR_BUFFER_BIT)
        glEnable(GL_TEXTURE_2D)
        filters()
        unit = texels(8, 8, 3) / 255
        data = unit.astype("f4") if dtype == "f4" else (unit * np.iinfo(dtype).max).astype(dtype)
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, type, data)
        square()


@program
def texture_coordinates_as_array_and_in_a_list() -> None:
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_TEXTURE_2D)
    upload(texels())
    filters()
    points = np.array([(-0.9, -0.9), (0.0, -0.9), (0.0, 0.8), (-0.9, 0.8)], "f4")
    glEnableClientState(GL_VERTEX_ARRAY)
    glEnableClientState(GL_TEXTURE_COORD_ARRAY)
    glVertexPointer(2, GL_FLOAT, 0, points)
    glTexCoordPointer(2, GL_FLOAT, 0, points * 0.7)
    glDrawArrays(GL_POLYGON, 0, 4)
    glNewList(1, GL_COMPILE)
    glTranslatef(0.5, 0.2, 0)
    square(size=0.4)
    glEndList()
    glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    glCallList(1)


@program
def copied_from_the_framebuffer() -> None:
    glClearColor(0.1, 0.2, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glBegin(GL_TRIANGLES)
    for color, x, y in (((1, 0, 0), -1, -1), ((0, 1, 0), 0, -1), ((0, 0, 1), -0.5, 0)):
        glColor3fv(color)
        glVertex2f(x, y)
    glEnd()
    glColor3f(1, 1, 1)
    glEnable(GL_TEXTURE_2D)
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 64, 64, 0)
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 10, 20, 30, 5, 16, 8)
    filters()
    glTranslatef(0.5, 0.5, 0)
    square(size=0.45)
