"""Projections and viewing transformations, and their way back."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim import gl

Float = NDArray[np.float64]


def gluPerspective(fovy: float, aspect: float, zNear: float, zFar: float) -> None:
    """Multiply the current matrix by a perspective projection (gluPerspective's manual page, GLU 1.3).

    fovy: the angle between the lowest and the highest ray, in degrees.  aspect: width / height of the picture.
    zNear, zFar: distances from the eye to the near and the far clipping plane along the line of sight, both positive,
    in the units of eye coordinates.  Nothing happens if fovy or aspect is 0, or zNear is zFar.
    """
    radians = math.radians(float(fovy) / 2)
    depth, sine = zFar - zNear, math.sin(radians)
    if depth == 0 or sine == 0 or aspect == 0:
        return
    cotangent = math.cos(radians) / sine
    m = np.zeros((4, 4))
    m[0, 0], m[1, 1] = cotangent / aspect, cotangent
    m[2, 2], m[2, 3], m[3, 2] = -(zFar + zNear) / depth, -1.0, -2.0 * zNear * zFar / depth
    gl.glMultMatrixd(m)


def gluOrtho2D(left: float, right: float, bottom: float, top: float) -> None:
    """Multiply the current matrix by a parallel projection for drawing in the plane, glOrtho with z from -1 to 1.

    left, right, bottom, top: eye coordinates at the edges of the picture.
    """
    gl.glOrtho(left, right, bottom, top, -1, 1)


def gluLookAt(
    eyeX: float, eyeY: float, eyeZ: float, centerX: float, centerY: float, centerZ: float, upX: float, upY: float,
    upZ: float,
) -> None:  # fmt: skip
    """Multiply the current matrix so that the camera stands at the eye and looks at the centre.

    eyeX, eyeY, eyeZ: where the camera stands.  centerX, centerY, centerZ: the point in the middle of the picture.
    upX, upY, upZ: the direction that points upwards in the picture.  All in the coordinates that the matrix takes.
    """
    forward = _unit(np.array([centerX - eyeX, centerY - eyeY, centerZ - eyeZ], np.float32))
    side = _unit(np.cross(forward, np.array([upX, upY, upZ], np.float32)))
    up = np.cross(side, forward)
    m = np.identity(4, np.float32)
    m[:3, 0], m[:3, 1], m[:3, 2] = side, up, -forward
    gl.glMultMatrixf(m)
    gl.glTranslated(-eyeX, -eyeY, -eyeZ)


def _unit(v: NDArray[np.float32]) -> NDArray[np.float32]:
    length = np.sqrt((v * v).sum(dtype=np.float32))
    return v / length if length else v


def gluPickMatrix(x: float, y: float, deltax: float, deltay: float, viewport: Any = None) -> None:
    """Multiply the current matrix so that a few pixels fill the whole viewport: for picking in GL_SELECT mode.

    x, y: the middle of these pixels, from the lower left corner of the window.  deltax, deltay: how many there are,
    across and up; nothing happens unless both are positive.  viewport: x, y, width, height in pixels; None for the
    current one.
    """
    if deltax <= 0 or deltay <= 0:
        return
    left, bottom, width, height = gl.glGetIntegerv(gl.GL_VIEWPORT) if viewport is None else np.ravel(viewport)[:4]
    gl.glTranslatef((width - 2 * (x - left)) / deltax, (height - 2 * (y - bottom)) / deltay, 0)
    gl.glScalef(width / deltax, height / deltay, 1.0)


def matrices(model: Any, proj: Any, view: Any) -> tuple[Float, Float, Float]:
    """The arguments, or for None the context's state: modelview (4, 4), projection (4, 4), viewport (4,)."""
    modelview = np.asarray(gl.glGetDoublev(gl.GL_MODELVIEW_MATRIX) if model is None else model, np.float64)
    projection = np.asarray(gl.glGetDoublev(gl.GL_PROJECTION_MATRIX) if proj is None else proj, np.float64)
    viewport = np.asarray(gl.glGetIntegerv(gl.GL_VIEWPORT) if view is None else view, np.float64)
    return modelview.reshape(4, 4), projection.reshape(4, 4), viewport.reshape(4)


def gluProject(
    objX: float, objY: float, objZ: float, model: Any = None, proj: Any = None, view: Any = None
) -> tuple[float, float, float]:
    """Window coordinates of a point: x and y in pixels from the lower left corner, depth in [0, 1].

    objX, objY, objZ: the point in object coordinates.  model, proj: matrices of 16 numbers, column first; view: x, y,
    width, height in pixels; None for what the context has.  Raises ValueError if w of the point in clip coordinates
    is 0.
    """
    modelview, projection, viewport = matrices(model, proj, view)
    clip = np.array([objX, objY, objZ, 1.0]) @ modelview @ projection
    if clip[3] == 0.0:
        raise ValueError("gluProject: the point lies in the plane of the eye, so it has no place on the screen")
    ndc = clip[:3] / clip[3] * 0.5 + 0.5
    x, y = ndc[:2] * viewport[2:] + viewport[:2]
    return float(x), float(y), float(ndc[2])


def gluUnProject(
    winX: float, winY: float, winZ: float, model: Any = None, proj: Any = None, view: Any = None
) -> tuple[float, float, float]:
    """Object coordinates (x, y, z) of a point in the window: the inverse of gluProject.

    winX, winY: pixels from the lower left corner.  winZ: depth in [0, 1].  model, proj, view: as gluProject takes them.
    Raises ValueError if modelview times projection has no inverse.
    """
    x, y, z, _ = _unproject(winX, winY, winZ, 1.0, model, proj, view, 0.0, 1.0, "gluUnProject")
    return x, y, z


def gluUnProject4(
    winX: float, winY: float, winZ: float, clipW: float, model: Any = None, proj: Any = None, view: Any = None,
    near: float = 0.0, far: float = 1.0,
) -> tuple[float, float, float, float]:  # fmt: skip
    """Window coordinates and w of clip space -> homogeneous object coordinates, for a depth range [near, far]."""
    return _unproject(winX, winY, winZ, clipW, model, proj, view, near, far, "gluUnProject4")


def _unproject(
    x: float, y: float, z: float, w: float, model: Any, proj: Any, view: Any, near: float, far: float, name: str
) -> tuple[float, float, float, float]:
    modelview, projection, viewport = matrices(model, proj, view)
    try:
        inverse = np.linalg.inv(modelview @ projection)
    except np.linalg.LinAlgError:
        raise ValueError(f"{name}: modelview times projection has no inverse") from None
    if viewport[2] == 0 or viewport[3] == 0:
        raise ValueError(f"{name}: the viewport is empty")
    place = np.array([(x - viewport[0]) / viewport[2], (y - viewport[1]) / viewport[3], (z - near) / (far - near)])
    given = np.array([*(place * 2.0 - 1.0), w])
    a, b, c, d = (given @ inverse).tolist()
    if name == "gluUnProject4":
        return a, b, c, d
    if d == 0.0:
        raise ValueError(f"{name}: the point is infinitely far away")
    return a / d, b / d, c / d, 1.0
