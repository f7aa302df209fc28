"""GLU's views: closed forms and round trips, and the answers of an installed libGLU, where there is one."""

from __future__ import annotations

import ctypes
import ctypes.util
import math

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import *

# ---------------------------------------------------------------- views


def camera() -> None:
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(50, 1.5, 0.5, 30)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(3, 2, 5, 0.5, 0, -1, 0.1, 1, 0)


def test_perspective_maps_the_frustum_to_the_cube(screen: glsim.Offscreen) -> None:
    glMatrixMode(GL_PROJECTION)
    gluPerspective(90, 2.0, 1.0, 11.0)
    for z, depth in ((-1, -1), (-11, 1)):
        x, y, d, w = np.array([2.0 * -z, -z, z, 1.0]) @ np.asarray(glGetDoublev(GL_PROJECTION_MATRIX), float)
        assert np.allclose([x / w, y / w, d / w], [1, 1, depth], atol=1e-6)


def test_look_at_puts_the_centre_on_the_axis(screen: glsim.Offscreen) -> None:
    camera()
    m = np.asarray(glGetDoublev(GL_MODELVIEW_MATRIX), float)
    assert np.allclose(m[:3, :3] @ m[:3, :3].T, np.identity(3), atol=1e-6)
    assert np.allclose(np.array([3, 2, 5, 1]) @ m, [0, 0, 0, 1], atol=1e-5)
    centre = np.array([0.5, 0, -1, 1]) @ m
    assert np.allclose(centre[:3], [0, 0, -math.dist((3, 2, 5), (0.5, 0, -1))], atol=1e-5)
    up = np.array([0.1, 1, 0, 0]) @ m
    assert abs(up[0]) < 1e-6
    assert up[1] > 0


def test_project_and_unproject_are_inverse(screen: glsim.Offscreen) -> None:
    camera()
    for point in ((0, 0, 0), (1, -0.5, 0.3), (-2, 1, -4)):
        window = gluProject(*point)
        assert np.allclose(gluUnProject(*window), point, atol=1e-5)
    assert np.allclose(gluProject(0.5, 0, -1)[:2], [64, 64], atol=1e-4)


def test_unproject4_gives_w_and_takes_a_depth_range(screen: glsim.Offscreen) -> None:
    camera()
    x, y, z = gluUnProject(30, 40, 0.75)
    a, b, c, d = gluUnProject4(30, 40, 0.2 + 0.75 * 0.4, 1.0, near=0.2, far=0.6)
    assert d != 1.0
    assert np.allclose([a / d, b / d, c / d], [x, y, z])


def test_what_has_no_place_raises_value_error(screen: glsim.Offscreen) -> None:
    zero, one = np.zeros((4, 4)), np.identity(4)
    with pytest.raises(ValueError, match=r"gluProject: .* plane of the eye"):
        gluProject(0, 0, 0, zero, one, [0, 0, 9, 9])
    with pytest.raises(ValueError, match=r"gluUnProject: .* no inverse"):
        gluUnProject(0, 0, 0, zero, one, [0, 0, 9, 9])


def test_pick_matrix_enlarges_a_pixel(screen: glsim.Offscreen) -> None:
    glMatrixMode(GL_PROJECTION)
    gluPickMatrix(10.5, 20.5, 1, 1, [0, 0, 128, 128])
    gluOrtho2D(0, 128, 0, 128)
    glRecti(10, 20, 11, 21)
    assert (screen.pixels()[..., :3] == 255).all()


@pytest.fixture(scope="module")
def library() -> ctypes.CDLL:
    """The installed GLU; only calls that need no context can be made."""
    path = ctypes.util.find_library("GLU")
    if path is None:
        pytest.skip("no libGLU is installed")
    return ctypes.CDLL(path)


def test_unproject4_is_that_of_the_installed_glu(screen: glsim.Offscreen, library: ctypes.CDLL) -> None:
    camera()
    matrices = [glGetDoublev(name) for name in (GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX)]
    result = (ctypes.c_double * 4)()
    pointers = [ctypes.byref(result, 8 * k) for k in range(4)]
    passed = [(ctypes.c_double * 16)(*np.ravel(m)) for m in matrices] + [(ctypes.c_int * 4)(1, 2, 80, 90)]
    numbers = [ctypes.c_double(n) for n in (12.0, 34.0, 0.4, 2.5)]
    assert library.gluUnProject4(*numbers, *passed, ctypes.c_double(0.1), ctypes.c_double(0.8), *pointers) == 1
    assert np.allclose(gluUnProject4(12, 34, 0.4, 2.5, *matrices, [1, 2, 80, 90], 0.1, 0.8), list(result))


def test_error_strings_are_those_of_the_installed_glu(library: ctypes.CDLL) -> None:
    library.gluErrorString.restype = ctypes.c_char_p
    for code in (*range(1280, 1290), *range(100150, 100160), *range(100250, 100290), *range(100900, 100906)):
        assert gluErrorString(code) == library.gluErrorString(code)


def test_strings() -> None:
    assert gluGetString(GLU_VERSION) == b"1.3"
    assert gluCheckExtension(b"GLU_EXT_nurbs_tessellator", gluGetString(GLU_EXTENSIONS))
    assert not gluCheckExtension("GLU_EXT", gluGetString(GLU_EXTENSIONS))
    with pytest.raises(GLUerror, match=r"gluGetString: name must be GLU_VERSION or GLU_EXTENSIONS, not 7"):
        gluGetString(7)
