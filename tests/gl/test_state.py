"""Matrices, lights, materials, queries and read-back."""

from __future__ import annotations

import ctypes

import numpy as np
import pytest

import glsim
from glsim import gl
from glsim.gl import *
from glsim.render.native import Native


def modelview() -> np.ndarray:
    return glGetFloatv(GL_MODELVIEW_MATRIX)


# ---------------------------------------------------------------- matrices


def test_matrices_are_column_first(screen: glsim.Offscreen) -> None:
    glLoadMatrixf(np.arange(16.0))
    assert modelview().tolist() == np.arange(16.0).reshape(4, 4).tolist()
    assert glGetFloatv(GL_TRANSPOSE_MODELVIEW_MATRIX).tolist() == np.arange(16.0).reshape(4, 4).T.tolist()
    glLoadTransposeMatrixd(np.arange(16.0))
    assert modelview().tolist() == np.arange(16.0).reshape(4, 4).T.tolist()


def test_products(screen: glsim.Offscreen) -> None:
    rng = np.random.default_rng(0)
    a, b = rng.normal(size=(2, 4, 4))
    glLoadMatrixd(a)
    glMultMatrixd(b)
    assert np.allclose(modelview().T, a.T @ b.T, atol=1e-5)
    glMultTransposeMatrixf(b)
    assert np.allclose(modelview().T, a.T @ b.T @ b, atol=1e-4)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, -2, 0), (0, 0, 3), (1, 2, 3), (-0.5, 0, 0.1)])
def test_rotation_matches_rodrigues(screen: glsim.Offscreen, axis: tuple[float, ...]) -> None:
    glRotatef(37.0, *axis)
    u = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    angle = np.radians(37.0)
    expected = np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k
    assert np.allclose(modelview().T[:3, :3], expected, atol=1e-6)


def test_no_axis_no_rotation(screen: glsim.Offscreen) -> None:
    glRotatef(37.0, 0, 0, 0)
    assert np.array_equal(modelview(), np.eye(4))


def test_stacks(screen: glsim.Offscreen) -> None:
    for mode, name, depth in (
        (GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MAX_MODELVIEW_STACK_DEPTH),
        (GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_MAX_PROJECTION_STACK_DEPTH),
        (GL_TEXTURE, GL_TEXTURE_STACK_DEPTH, GL_MAX_TEXTURE_STACK_DEPTH),
    ):
        glMatrixMode(mode)
        assert glGetIntegerv(name) == 1
        most = glGetIntegerv(depth)
        assert most >= (32 if mode == GL_MODELVIEW else 2)
        for _ in range(most - 1):
            glPushMatrix()
        assert glGetIntegerv(name) == most
        with pytest.raises(GLError, match=r"glPushMatrix: .* is a glPopMatrix missing") as caught:
            glPushMatrix()
        assert caught.value.err == GL_STACK_OVERFLOW
        glTranslatef(1, 0, 0)
        glPopMatrix()
        for _ in range(most - 2):
            glPopMatrix()
        with pytest.raises(GLError, match="more glPopMatrix than glPushMatrix") as caught:
            glPopMatrix()
        assert caught.value.err == GL_STACK_UNDERFLOW
    assert np.array_equal(modelview(), np.eye(4))


def test_a_thousand_turns_are_evaluated_late_and_kept_short(screen: glsim.Offscreen) -> None:
    for _ in range(1000):
        glRotatef(0.36, 0, 0, 1)
    assert np.allclose(modelview(), np.eye(4), atol=1e-3)
    assert screen.machine.modelview[-1].parent is None


@pytest.mark.parametrize(
    ("call", "sentence"),
    [
        (lambda: glFrustum(-1, 1, -1, 1, 0, 10), "glFrustum: zNear and zFar must be positive"),
        (lambda: glFrustum(1, 1, -1, 1, 1, 10), "glFrustum: left and right must be two different numbers"),
        (lambda: glOrtho(0, 1, 2, 2, 1, 10), "glOrtho: bottom and top must be"),
        (lambda: glMatrixMode(GL_LIGHT0), "glMatrixMode: mode must be GL_MODELVIEW, GL_PROJECTION or GL_TEXTURE"),
        (lambda: glViewport(0, 0, -1, 5), "glViewport: width and height must be at least 0"),
        (lambda: glLoadMatrixf([1, 2, 3]), "glLoadMatrixf: a matrix has 16 numbers, not 3"),
        (lambda: glLightfv(GL_LIGHT0 + 9, GL_DIFFUSE, [1] * 4), "glLightfv: light must be GL_LIGHT0 to GL_LIGHT7"),
        (lambda: glLightfv(GL_LIGHT0, GL_LIGHTING, [1] * 4), "glLightfv: pname must be a light parameter"),
        (lambda: glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 91), r"glLightf: GL_SPOT_CUTOFF must be an angle in \[0, 90\]"),
        (lambda: glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1), "glLightf: GL_SPOT_EXPONENT"),
        (lambda: glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1), "glLightf: the attenuation must be at least 0"),
        (lambda: glLightfv(GL_LIGHT0, GL_POSITION, [1, 2]), "glLightfv: GL_POSITION needs four numbers"),
        (lambda: glMaterialf(GL_FRONT, GL_SHININESS, 129), r"glMaterialf: GL_SHININESS must be in \[0, 128\]"),
        (lambda: glMaterialf(GL_FRONT, GL_SHININESS, float("nan")), "glMaterialf: GL_SHININESS must be in"),
        (lambda: glMaterialfv(GL_LEFT, GL_DIFFUSE, [1] * 4), "glMaterialfv: face must be GL_FRONT, GL_BACK"),
        (lambda: glMaterialfv(GL_FRONT, GL_POSITION, [1] * 4), "glMaterialfv: pname must be GL_AMBIENT"),
        (lambda: glColorMaterial(GL_FRONT, GL_SHININESS), "glColorMaterial: mode must be"),
        (lambda: glShadeModel(GL_LINES), "glShadeModel: mode must be GL_FLAT, GL_SMOOTH or GL_PHONG_WIN"),
        (lambda: glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, 7), "param must be GL_BLINN_TORRANCE_GLSIM or"),
        (lambda: glEnable(0x1234), "glEnable: cap must be something that can be enabled.*4660"),
        (lambda: glDepthFunc(GL_LIGHTING), "glDepthFunc: func must be a comparison"),
        (lambda: glCullFace(GL_CW), "glCullFace: mode must be"),
        (lambda: glFrontFace(GL_BACK), "glFrontFace: mode must be GL_CW or GL_CCW"),
        (lambda: glClear(GL_LIGHTING), "glClear: mask must be a sum of"),
        (lambda: glGetFloatv(0x9999), "glGetFloatv: pname must be a state variable"),
        (lambda: glHint(GL_LIGHTING, GL_NICEST), "glHint: target must be a hint"),
        (lambda: glDrawArrays(GL_LIGHTING, 0, 3), "glDrawArrays: mode must be one of the ten"),
        (lambda: glDrawArrays(GL_TRIANGLES, 0, -3), "glDrawArrays: first and count must be at least 0"),
        (lambda: glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, [0]), "glDrawElements: type must be"),
        (lambda: glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, [0]), "indices holds 1 numbers, but count is 3"),
        (lambda: glNormalPointer(GL_UNSIGNED_BYTE, 0, [0.0]), "glNormalPointer: type must be GL_BYTE or GL_SHORT"),
        (lambda: glDrawElements(GL_POINTS, 1, GL_UNSIGNED_BYTE, np.array([256])), "indices from 256 to 256 do not fit"),
        (lambda: glDrawElements(GL_POINTS, 1, GL_UNSIGNED_INT, np.array([-1])), "indices from -1 to -1 do not fit"),
        (lambda: glVertexPointer(5, GL_FLOAT, 0, [0.0]), "glVertexPointer: size must be 2 or 3 or 4, not 5"),
        (lambda: glEnableClientState(GL_LIGHTING), "glEnableClientState: array must be"),
        (lambda: glInterleavedArrays(GL_LINES, 0, [0.0]), "glInterleavedArrays: format must be"),
        (lambda: glReadPixels(0, 0, 1, 1, GL_LIGHTING, GL_FLOAT), "glReadPixels: format must be"),
        (lambda: glReadPixels(0, 0, 1, 1, GL_RGB, GL_LIGHTING), "glReadPixels: type must be"),
        (lambda: glReadPixels(0, 0, -1, 1, GL_RGB, GL_FLOAT), "glReadPixels: width and height"),
    ],
)
def test_errors_name_call_argument_and_expectation(screen: glsim.Offscreen, call: object, sentence: str) -> None:
    with pytest.raises((GLError, ValueError), match=sentence):
        call()  # type: ignore[operator]
    assert glGetError() == 0


def test_an_array_that_is_too_short(screen: glsim.Offscreen) -> None:
    glEnableClientState(GL_VERTEX_ARRAY)
    glVertexPointer(3, GL_FLOAT, 0, np.zeros((2, 3), "f4"))
    with pytest.raises(ValueError, match="glDrawArrays: element 2 was asked of a vertex array of 2 elements"):
        glDrawArrays(GL_TRIANGLES, 0, 3)


# ---------------------------------------------------------------- lights and materials


def test_light_defaults(screen: glsim.Offscreen) -> None:
    assert glGetLightfv(GL_LIGHT0, GL_DIFFUSE).tolist() == [1, 1, 1, 1]
    assert glGetLightfv(GL_LIGHT1, GL_DIFFUSE).tolist() == [0, 0, 0, 1]
    assert glGetLightfv(GL_LIGHT3, GL_POSITION).tolist() == [0, 0, 1, 0]
    assert glGetLightfv(GL_LIGHT3, GL_SPOT_DIRECTION).tolist() == [0, 0, -1]
    assert glGetLightfv(GL_LIGHT7, GL_SPOT_CUTOFF) == 180
    assert glGetLightfv(GL_LIGHT7, GL_CONSTANT_ATTENUATION) == 1
    assert np.allclose(glGetMaterialfv(GL_BACK, GL_AMBIENT), [0.2, 0.2, 0.2, 1])
    assert np.allclose(glGetFloatv(GL_LIGHT_MODEL_AMBIENT), [0.2, 0.2, 0.2, 1])


def test_position_is_taken_to_eye_space_at_the_call(screen: glsim.Offscreen) -> None:
    glTranslatef(1, 2, 3)
    glRotatef(90, 0, 0, 1)
    glLightfv(GL_LIGHT2, GL_POSITION, [1, 0, 0, 1])
    glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, [1, 0, 0])
    glLoadIdentity()
    assert np.allclose(glGetLightfv(GL_LIGHT2, GL_POSITION), [1, 3, 3, 1], atol=1e-6)
    assert np.allclose(glGetLightfv(GL_LIGHT2, GL_SPOT_DIRECTION), [0, 1, 0], atol=1e-6)


def test_sides_of_a_material(screen: glsim.Offscreen) -> None:
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, [0.5, 0.25, 0, 1])
    glMaterialfv(GL_FRONT, GL_EMISSION, [0.125, 0, 0, 1])
    assert glGetMaterialfv(GL_BACK, GL_DIFFUSE).tolist() == [0.5, 0.25, 0, 1]
    assert glGetMaterialfv(GL_BACK, GL_AMBIENT).tolist() == [0.5, 0.25, 0, 1]
    assert np.allclose(glGetMaterialfv(GL_FRONT, GL_DIFFUSE), [0.8, 0.8, 0.8, 1])
    assert glGetMaterialfv(GL_FRONT, GL_EMISSION)[0] == 0.125


def test_color_material_is_read_back_from_the_material(screen: glsim.Offscreen) -> None:
    glColorMaterial(GL_FRONT, GL_DIFFUSE)
    glColor3f(0.5, 0, 0)
    glEnable(GL_COLOR_MATERIAL)
    assert glGetMaterialfv(GL_FRONT, GL_DIFFUSE).tolist() == [0.5, 0, 0, 1]
    glColor3f(0, 0.5, 0)
    assert glGetMaterialfv(GL_FRONT, GL_DIFFUSE).tolist() == [0, 0.5, 0, 1]
    assert np.allclose(glGetMaterialfv(GL_BACK, GL_DIFFUSE), [0.8, 0.8, 0.8, 1])
    glDisable(GL_COLOR_MATERIAL)
    glColor3f(0, 0, 1)
    assert glGetMaterialfv(GL_FRONT, GL_DIFFUSE).tolist() == [0, 0.5, 0, 1]


def test_extensions_are_queryable(screen: glsim.Offscreen) -> None:
    assert glGetIntegerv(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM) == GL_BLINN_TORRANCE_GLSIM
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM)
    assert glGetIntegerv(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM) == GL_PHONG_LOBE_GLSIM
    assert glGetIntegerv(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM) == GL_CLAMP_NORMAL_GLSIM
    glLightModelf(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, GL_FLIP_NORMAL_GLSIM)
    assert glGetIntegerv(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM) == GL_FLIP_NORMAL_GLSIM
    glShadeModel(GL_PHONG_WIN)
    assert glGetIntegerv(GL_SHADE_MODEL) == GL_PHONG_WIN
    assert b"GL_WIN_phong_shading" in glGetString(GL_EXTENSIONS).split()


def test_a_program_of_later_versions_learns_where_it_is(screen: glsim.Offscreen) -> None:
    version = f"{glGetIntegerv(GL_MAJOR_VERSION)}.{glGetIntegerv(GL_MINOR_VERSION)}".encode()
    assert glGetString(GL_VERSION).split()[0] == version == b"1.5"
    names = [glGetStringi(GL_EXTENSIONS, k) for k in range(glGetIntegerv(GL_NUM_EXTENSIONS))]
    assert b" ".join(names) == glGetString(GL_EXTENSIONS)
    with pytest.raises(GLError, match="glGetStringi: index must be from 0 to"):
        glGetStringi(GL_EXTENSIONS, len(names))
    language = glGetString(GL_SHADING_LANGUAGE_VERSION).decode()
    assert float(language.split()[0]) < 1.1
    assert "no shaders" in language


# ---------------------------------------------------------------- queries as PyOpenGL 3.1.10 answers them


@pytest.mark.parametrize(
    ("query", "name", "dtype", "values"),
    [
        (glGetFloatv, GL_VIEWPORT, "f4", [0, 0, 128, 128]),
        (glGetIntegerv, GL_VIEWPORT, "i4", [0, 0, 128, 128]),
        (glGetBooleanv, GL_VIEWPORT, "u1", [0, 0, 1, 1]),
        (glGetDoublev, GL_DEPTH_RANGE, "f8", [0, 1]),
        (glGetIntegerv, GL_CURRENT_COLOR, "i4", [2147483647] * 4),
        (glGetIntegerv, GL_LIGHT_MODEL_AMBIENT, "i4", [429496735] * 3 + [2147483647]),
        (glGetBooleanv, GL_COLOR_WRITEMASK, "u1", [1, 1, 1, 1]),
        (glGetIntegerv, GL_POLYGON_MODE, "i4", [6914, 6914]),
    ],
)
def test_array_answers(screen: glsim.Offscreen, query: object, name: int, dtype: str, values: list[float]) -> None:
    answer = query(name)  # type: ignore[operator]
    assert answer.dtype == dtype
    assert answer.tolist() == values


@pytest.mark.parametrize(
    ("query", "name", "dtype", "value"),
    [
        (glGetIntegerv, GL_MAX_LIGHTS, "i4", 8),
        (glGetFloatv, GL_LIGHTING, "f4", 0),
        (glGetIntegerv, GL_SHADE_MODEL, "i4", 7425),
        (glGetBooleanv, GL_LIGHT_MODEL_TWO_SIDE, "u1", 0),
        (glGetDoublev, GL_DEPTH_CLEAR_VALUE, "f8", 1),
        (glGetIntegerv, GL_PERSPECTIVE_CORRECTION_HINT, "i4", GL_DONT_CARE),
    ],
)
def test_single_answers_are_numpy_scalars(
    screen: glsim.Offscreen, query: object, name: int, dtype: str, value: float
) -> None:
    answer = query(name)  # type: ignore[operator]
    assert answer.shape == ()
    assert answer.dtype == dtype
    assert answer == value


def test_other_return_types(screen: glsim.Offscreen) -> None:
    assert glGetFloatv(GL_MODELVIEW_MATRIX).shape == (4, 4)
    assert glIsEnabled(GL_DITHER) == 1
    assert type(glIsEnabled(GL_LIGHTING)) is int
    assert isinstance(glGetString(GL_VENDOR), bytes)
    assert glIsEnabled(GL_VERTEX_ARRAY) == 0
    answer = [0] * 16
    assert glGetFloatv(GL_MODELVIEW_MATRIX, answer) is answer
    assert answer[0] == answer[15] == 1
    assert glGetString(GL_VERSION).startswith(b"1.5 ")
    target = np.zeros(4, "f4")
    assert glGetFloatv(GL_CURRENT_COLOR, target) is target
    assert target.tolist() == [1, 1, 1, 1]


def test_arrays_of_every_kind_are_taken(screen: glsim.Offscreen) -> None:
    for values in ([0.5, 0, 0, 1], (0.5, 0, 0, 1), np.array([0.5, 0, 0, 1]), (ctypes.c_float * 4)(0.5, 0, 0, 1)):
        glMaterialfv(GL_FRONT, GL_DIFFUSE, values)
        assert glGetMaterialfv(GL_FRONT, GL_DIFFUSE).tolist() == [0.5, 0, 0, 1]
        glColor4fv(values)
        assert glGetFloatv(GL_CURRENT_COLOR).tolist() == [0.5, 0, 0, 1]
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [0, 0, 0, 1])


# ---------------------------------------------------------------- read-back


def test_read_pixels(screen: glsim.Offscreen) -> None:
    glClearColor(1, 0.5, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glColor3f(0, 0, 1)
    glRectf(-1, -1, 0, 0)
    data = glReadPixels(0, 0, 128, 128, GL_RGB, GL_UNSIGNED_BYTE)
    assert type(data) is bytes
    picture = np.frombuffer(data, "u1").reshape(128, 128, 3)
    assert picture[0, 0].tolist() == [0, 0, 255]
    assert picture[127, 127].tolist() == [255, 128, 0]
    floats = glReadPixels(62, 0, 4, 2, GL_RGBA, GL_FLOAT)
    assert floats.dtype == np.float32
    assert floats.shape == (4, 2, 4)
    assert floats.reshape(2, 4, 4)[0, 0].tolist() == [0, 0, 1, 1]
    buffer = np.zeros((2, 4, 3), "u1")
    assert glReadPixels(62, 0, 4, 2, GL_RGB, GL_UNSIGNED_BYTE, buffer) is buffer
    assert buffer[0, 3].tolist() == [255, 128, 0]
    assert glReadPixels(0, 0, 2, 1, GL_BGRA, GL_UNSIGNED_BYTE) == bytes([255, 0, 0, 255] * 2)


def test_depth_is_read_back(screen: glsim.Offscreen) -> None:
    glEnable(GL_DEPTH_TEST)
    glClear(GL_DEPTH_BUFFER_BIT)
    glTranslatef(0, 0, -0.5)
    glRectf(-1, -1, 1, 0)
    depth = glReadPixels(0, 0, 128, 128, GL_DEPTH_COMPONENT, GL_FLOAT).reshape(128, 128)
    assert np.allclose(depth[:64], 0.25, atol=1e-6)
    assert (depth[64:] == 1).all()
    assert np.array_equal(screen.depth()[::-1], depth)


# Limits and buffers that are another implementation's business, and what the oracle itself has pushed.
OWN = """
GL_MAJOR_VERSION GL_MINOR_VERSION GL_NUM_EXTENSIONS
GL_ACCUM_RED_BITS GL_ACCUM_GREEN_BITS GL_ACCUM_BLUE_BITS GL_ACCUM_ALPHA_BITS GL_ATTRIB_STACK_DEPTH GL_DRAW_BUFFER
GL_READ_BUFFER GL_MAX_CLIP_PLANES GL_MAX_MODELVIEW_STACK_DEPTH GL_MAX_TEXTURE_SIZE GL_MAX_TEXTURE_STACK_DEPTH
GL_PACK_ALIGNMENT GL_STENCIL_VALUE_MASK GL_STENCIL_WRITEMASK GL_CLIENT_ATTRIB_STACK_DEPTH GL_MAX_3D_TEXTURE_SIZE
GL_MAX_ELEMENTS_INDICES GL_MAX_ELEMENTS_VERTICES GL_MAX_CUBE_MAP_TEXTURE_SIZE GL_MAX_TEXTURE_UNITS
GL_COMPRESSED_TEXTURE_FORMATS GL_NUM_COMPRESSED_TEXTURE_FORMATS GL_MAX_TEXTURE_LOD_BIAS GL_DOUBLEBUFFER
GL_MAX_PROJECTION_STACK_DEPTH GL_MAX_LIST_NESTING GL_MAX_EVAL_ORDER GL_DEPTH_BITS GL_SUBPIXEL_BITS GL_TEXTURE_BINDING_1D
GL_POINT_SIZE_RANGE GL_LINE_WIDTH_RANGE GL_POINT_SIZE_GRANULARITY GL_LINE_WIDTH_GRANULARITY GL_MAX_VIEWPORT_DIMS
"""


def test_every_state_variable_begins_with_the_drivers_value(screen: glsim.Offscreen, native: Native) -> None:
    """And has as many numbers, and every name that the driver answers to is answered."""
    native = Native(native.width, native.height)  # one in which nothing was ever called
    native.loader.make_current()
    get = ctypes.CFUNCTYPE(None, ctypes.c_uint, ctypes.c_void_p)(native.loader.load("glGetFloatv"))
    asked = 0
    for name in gl.__all__:
        if not name.startswith("GL_") or "GLSIM" in name or name in OWN:
            continue
        values = np.full(1024, -777.25, np.float32)
        get(int(getattr(gl, name)), values.ctypes.data)
        if native.error():
            continue
        theirs = values[values != -777.25]
        ours = np.ravel(gl.glGetFloatv(getattr(gl, name)))
        assert ours.shape == theirs.shape, name
        assert ours == pytest.approx(theirs, abs=1e-6), name
        asked += 1
    native.release()
    assert asked > 250
