"""Matrix stacks, viewport and depth range: section 2.11 of the specification."""

from __future__ import annotations

from typing import Any

import numpy as np

from glsim.gl.arguments import as_int32, exactly, matrix16, unit
from glsim.machine import constants as gl
from glsim.machine import matrix
from glsim.machine.errors import invalid_enum, invalid_value, stack_overflow, stack_underflow
from glsim.machine.machine import STACK_DEPTH, Machine
from glsim.machine.matrix import Matrix
from glsim.machine.state import MAX_CLIP_PLANES, Color

NAMES: dict[int, str] = {gl.GL_MODELVIEW: "modelview", gl.GL_PROJECTION: "projection", gl.GL_TEXTURE: "texture"}


def glMatrixMode(m: Machine, mode: int) -> None:
    if mode not in m.stacks:
        raise invalid_enum("mode", mode, "GL_MODELVIEW, GL_PROJECTION or GL_TEXTURE")
    m.transform = m.transform._replace(matrix_mode=mode)
    m.stack = m.stacks[mode]


def glPushMatrix(m: Machine) -> None:
    stack = m.stack
    if len(stack) >= 32:
        mode = m.transform.matrix_mode
        if len(stack) >= STACK_DEPTH[mode]:
            raise stack_overflow(
                f"the {NAMES[mode]} stack holds {STACK_DEPTH[mode]} matrices and is full: is a glPopMatrix missing?"
            )
    stack.append(stack[-1])


def glPopMatrix(m: Machine) -> None:
    stack = m.stack
    if len(stack) == 1:
        name = NAMES[m.transform.matrix_mode]
        raise stack_underflow(f"only one matrix is left on the {name} stack: more glPopMatrix than glPushMatrix")
    stack.pop()


def glLoadIdentity(m: Machine) -> None:
    m.stack[-1] = matrix.identity()


def glLoadMatrix(m: Machine, values: Any) -> None:
    m.stack[-1] = matrix.leaf(matrix16(values))


def glLoadTransposeMatrix(m: Machine, values: Any) -> None:
    m.stack[-1] = matrix.leaf(matrix16(values).T.copy())


def glMultMatrix(m: Machine, values: Any) -> None:
    m.stack[-1] = Matrix(m.stack[-1], "multiply", matrix16(values))


def glMultTransposeMatrix(m: Machine, values: Any) -> None:
    m.stack[-1] = Matrix(m.stack[-1], "multiply", matrix16(values).T)


def glTranslate(m: Machine, x: float, y: float, z: float) -> None:
    m.stack[-1] = Matrix(m.stack[-1], "translate", (float(x), float(y), float(z)))


def glScale(m: Machine, x: float, y: float, z: float) -> None:
    m.stack[-1] = Matrix(m.stack[-1], "scale", (float(x), float(y), float(z)))


def glRotate(m: Machine, angle: float, x: float, y: float, z: float) -> None:
    m.stack[-1] = Matrix(m.stack[-1], "rotate", (float(angle), float(x), float(y), float(z)))


def glFrustum(m: Machine, left: float, right: float, bottom: float, top: float, zNear: float, zFar: float) -> None:
    if not (zNear > 0 and zFar > 0):
        raise invalid_value("zNear and zFar", (zNear, zFar), "positive: they are distances in front of the eye")
    _check_box(left, right, bottom, top, zNear, zFar)
    m.stack[-1] = Matrix(m.stack[-1], "multiply", matrix.frustum(left, right, bottom, top, zNear, zFar))


def glOrtho(m: Machine, left: float, right: float, bottom: float, top: float, zNear: float, zFar: float) -> None:
    _check_box(left, right, bottom, top, zNear, zFar)
    m.stack[-1] = Matrix(m.stack[-1], "multiply", matrix.ortho(left, right, bottom, top, zNear, zFar))


def _check_box(left: float, right: float, bottom: float, top: float, near: float, far: float) -> None:
    for a, b, names in (
        (left, right, "left and right"),
        (bottom, top, "bottom and top"),
        (near, far, "zNear and zFar"),
    ):
        if float(a) == float(b):
            raise invalid_value(names, (a, b), "two different numbers")


def glViewport(m: Machine, x: int, y: int, width: int, height: int) -> None:
    if width < 0 or height < 0:
        raise invalid_value("width and height", (width, height), "at least 0")
    largest = 16384
    size = min(int(width), largest), min(int(height), largest)
    m.viewport = m.viewport._replace(x=as_int32(x), y=as_int32(y), width=size[0], height=size[1])


def glDepthRange(m: Machine, zNear: float, zFar: float) -> None:
    m.viewport = m.viewport._replace(near=unit(zNear), far=unit(zFar))


def glClipPlane(m: Machine, plane: int, equation: Any) -> None:
    """Keeps a x + b y + c z + d w >= 0; taken to eye space NOW by the inverse of the modelview (section 2.12)."""
    number = plane - gl.GL_CLIP_PLANE0
    if not 0 <= number < MAX_CLIP_PLANES:
        raise invalid_enum("plane", plane, f"GL_CLIP_PLANE0 to GL_CLIP_PLANE{MAX_CLIP_PLANES - 1}")
    a, b, c, d = exactly(equation, 4, "equation")
    planes = list(m.transform.clip_planes)
    planes[number] = in_eye_space(m, (a, b, c, d))
    m.transform = m.transform._replace(clip_planes=tuple(planes))


def in_eye_space(m: Machine, plane: Color) -> Color:
    """A plane of object space times the inverse of the modelview as it is now."""
    modelview = m.modelview[-1].get().T.astype(np.float64)  # rows and columns as in mathematics
    try:
        eye = np.array(plane) @ np.linalg.inv(modelview)
    except np.linalg.LinAlgError:
        eye = np.array(plane)
    a, b, c, d = eye.astype(np.float32).tolist()
    return a, b, c, d


def glGetClipPlane(m: Machine, plane: int) -> Any:
    number = plane - gl.GL_CLIP_PLANE0
    if not 0 <= number < MAX_CLIP_PLANES:
        raise invalid_enum("plane", plane, f"GL_CLIP_PLANE0 to GL_CLIP_PLANE{MAX_CLIP_PLANES - 1}")
    return np.array(m.transform.clip_planes[number], np.float64)
