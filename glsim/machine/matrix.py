"""Matrices of the transformation stacks, in float32 and in the order of operations that Mesa uses.

A ``Matrix`` is a node: its parent and what was multiplied to it.  glTranslate, glRotate and glScale only make a node;
numbers are computed when somebody needs them, for all matrices of a frame at once.  Values are arrays of shape (4, 4)
whose first index is the COLUMN, so that the sixteen numbers lie in memory as glLoadMatrixf wants them.

    top = identity()                               # value: np.eye(4)
    top = Matrix(top, "translate", (1, 2, 3))      # what glTranslatef(1, 2, 3) does: no arithmetic, value is None
    top = Matrix(top, "rotate", (90, 0, 0, 1))     # glRotatef(90, 0, 0, 1)
    evaluate([top, ...])                           # at the flush: first all translations of a level, then all rotations
    top.get()[3]                                   # [1, 2, 3, 1]: the LAST ROW of the array is the last column of M

So a row of points p (n, 4) is transformed by ``p @ value``, which is M p for each of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

Float32 = NDArray[np.float32]


class Matrix:
    """parent * operation(arguments), evaluated late.  ``value``: (4, 4) float32, column first."""

    __slots__ = ("arguments", "operation", "parent", "value")

    def __init__(self, parent: Matrix | None, operation: str, arguments: object, value: Float32 | None = None) -> None:
        self.parent = parent
        self.operation = operation
        self.arguments = arguments
        self.value = value

    def get(self) -> Float32:
        """The numbers, computed now if need be."""
        if self.value is None:
            evaluate((self,))
        assert self.value is not None
        return self.value


def leaf(value: Float32) -> Matrix:
    return Matrix(None, "", None, value)


def identity() -> Matrix:
    return leaf(np.eye(4, dtype=np.float32))


def evaluate(matrices: Iterable[Matrix]) -> None:
    """Compute the value of every matrix given, level by level, all nodes with the same operation in one go."""
    depth: dict[Matrix, int] = {}
    levels: list[dict[str, list[Matrix]]] = []
    for matrix in matrices:
        chain: list[Matrix] = []
        node: Matrix | None = matrix
        while node is not None and node.value is None and node not in depth:
            chain.append(node)
            node = node.parent
        level = depth.get(node, -1) if node is not None else -1
        for node in reversed(chain):
            level += 1
            depth[node] = level
            if level == len(levels):
                levels.append({})
            levels[level].setdefault(node.operation, []).append(node)
    for groups in levels:
        for operation, nodes in groups.items():
            parents = np.array([node.parent.value for node in nodes])  # type: ignore[union-attr]
            arguments = np.array([node.arguments for node in nodes], np.float32)
            with np.errstate(all="ignore"):
                values = OPERATIONS[operation](parents, arguments)
            for node, value in zip(nodes, values, strict=True):
                node.value, node.parent = value, None


def multiply(a: Float32, b: Float32) -> Float32:
    """a * b for stacks of matrices (n, 4, 4): c_ij = a_i0 b_0j + a_i1 b_1j + a_i2 b_2j + a_i3 b_3j, in that order."""
    products = b[..., :, :, None] * a[..., None, :, :]  # indices: column j, summand k, row i
    return ((products[..., 0, :] + products[..., 1, :]) + products[..., 2, :]) + products[..., 3, :]  # type: ignore[no-any-return]


def transform(matrix: Float32, vector: Float32) -> Float32:
    """matrix * vector for a column vector of four numbers."""
    c = matrix * vector[:, None]
    return ((c[0] + c[1]) + c[2]) + c[3]  # type: ignore[no-any-return]


def transform_direction(matrix: Float32, vector: Float32) -> Float32:
    """The upper left 3x3 part of the matrix times a direction of three numbers."""
    c = matrix[:3, :3] * vector[:, None]
    return (c[0] + c[1]) + c[2]  # type: ignore[no-any-return]


def _translate(parents: Float32, offsets: Float32) -> Float32:
    values = parents.copy()
    c = parents[:, :3] * offsets[:, :, None]
    values[:, 3] = ((c[:, 0] + c[:, 1]) + c[:, 2]) + parents[:, 3]
    return values


def _scale(parents: Float32, factors: Float32) -> Float32:
    values = parents.copy()
    values[:, :3] *= factors[:, :, None]
    return values


def _rotate(parents: Float32, arguments: Float32) -> Float32:
    rotations = np.array([rotation(*row) for row in arguments.tolist()], np.float32)
    return multiply(parents, rotations)


OPERATIONS: dict[str, Callable[[Float32, Float32], Float32]] = {
    "translate": _translate,
    "scale": _scale,
    "rotate": _rotate,
    "multiply": multiply,
}


def rotation(angle: float, x: float, y: float, z: float) -> Float32:
    """Rotation by ``angle`` degrees about (x, y, z), section 2.11.2; the identity if the axis is (0, 0, 0)."""
    matrix = np.eye(4, dtype=np.float32)
    f = np.float32
    radians = float(f(angle * math.pi / 180.0))
    if not math.isfinite(radians):
        return np.full((4, 4), np.nan, np.float32)
    s, c = f(math.sin(radians)), f(math.cos(radians))
    if [x, y, z].count(0.0) == 2:  # about a coordinate axis: exact zeros and ones
        i, j = (1, 2) if x else (2, 0) if y else (0, 1)
        matrix[i, i] = matrix[j, j] = c
        matrix[i, j], matrix[j, i] = (s, -s) if x + y + z > 0 else (-s, s)
        return matrix
    length = np.sqrt(f(x) * f(x) + f(y) * f(y) + f(z) * f(z))
    if not length > 1e-4:
        return matrix
    ux, uy, uz = f(x) / length, f(y) / length, f(z) / length
    t = f(1) - c
    matrix[0, :3] = t * (ux * ux) + c, t * (ux * uy) + uz * s, t * (uz * ux) - uy * s
    matrix[1, :3] = t * (ux * uy) - uz * s, t * (uy * uy) + c, t * (uy * uz) + ux * s
    matrix[2, :3] = t * (uz * ux) + uy * s, t * (uy * uz) - ux * s, t * (uz * uz) + c
    return matrix


@np.errstate(all="ignore")
def frustum(left: float, right: float, bottom: float, top: float, near: float, far: float) -> Float32:
    """Perspective projection, OpenGL 1.5 section 2.11.2."""
    l, r, b, t, n, f = (np.float32(v) for v in (left, right, bottom, top, near, far))  # noqa: E741
    two = np.float32(2)
    matrix = np.zeros((4, 4), np.float32)
    matrix[0, 0], matrix[1, 1] = (two * n) / (r - l), (two * n) / (t - b)
    matrix[2] = (r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1
    matrix[3, 2] = -(two * f * n) / (f - n)
    return matrix


@np.errstate(all="ignore")
def ortho(left: float, right: float, bottom: float, top: float, near: float, far: float) -> Float32:
    """Parallel projection, OpenGL 1.5 section 2.11.2."""
    l, r, b, t, n, f = (np.float32(v) for v in (left, right, bottom, top, near, far))  # noqa: E741
    two = np.float32(2)
    matrix = np.zeros((4, 4), np.float32)
    matrix[0, 0], matrix[1, 1], matrix[2, 2] = two / (r - l), two / (t - b), -two / (f - n)
    matrix[3] = -(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1
    return matrix


def inverse_transpose(matrices: Float32) -> Float32:
    """The normal matrices of modelview matrices (n, 4, 4): (n, 3, 3), like these with the COLUMN as first index.

    Each is the transpose of the inverse of the upper left 3x3 part; where that has no inverse, the part itself.
    """
    upper = matrices[:, :3, :3].astype(np.float64)
    with np.errstate(all="ignore"):
        determinant = np.linalg.det(upper)
    usable = np.isfinite(determinant) & (np.abs(determinant) > 1e-300)
    result = upper.copy()
    result[usable] = np.linalg.inv(upper[usable]).transpose(0, 2, 1)
    with np.errstate(all="ignore"):
        return result.astype(np.float32)
