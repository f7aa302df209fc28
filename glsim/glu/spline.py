"""B-splines of one or two parameters: L. Piegl and W. Tiller, The NURBS Book (1997), chapters 2 and 3."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Float = NDArray[np.float64]


class Spline:
    """A B-spline of one or two parameters: knots for each, control points (n, k) or (n, m, k)."""

    def __init__(self, knots: list[Float], points: Float) -> None:
        self.knots, self.points = knots, points
        self.orders = [len(t) - n for t, n in zip(knots, points.shape, strict=False)]

    def domain(self, axis: int) -> tuple[float, float]:
        order, t = self.orders[axis], self.knots[axis]
        return float(t[order - 1]), float(t[len(t) - order])

    def spans(self, axis: int) -> Float:
        """The different knots inside the domain."""
        low, high = self.domain(axis)
        t = np.unique(self.knots[axis])
        return t[(t >= low) & (t <= high)]

    def __call__(self, *places: Float, derive: int | None = None) -> Float:
        """At places (n,) for each parameter -> (n, k); derive: the derivative by that parameter."""
        bases = [_basis(self.knots[axis], self.orders[axis], t, int(derive == axis)) for axis, t in enumerate(places)]
        letters = "ni,ik->nk" if len(places) == 1 else "ni,nj,ijk->nk"
        return np.asarray(np.einsum(letters, *bases, self.points))

    def grid(self, *places: Float, derive: int | None = None) -> Float:
        """A surface at u (n,) and v (m,), each u with each v -> (n * m, k), v changing fastest; derive: as above."""
        along_u, along_v = (_basis(self.knots[k], self.orders[k], t, int(derive == k)) for k, t in enumerate(places))
        points = np.einsum("ui,ijk->ujk", along_u, self.points)
        return np.asarray(np.einsum("vj,ujk->uvk", along_v, points).reshape(-1, self.points.shape[-1]))


def _basis(knots: Float, order: int, t: Float, derivative: int) -> Float:
    """B-spline basis functions, or their derivatives, at t (n,): (n, len(knots) - order), by Cox and de Boor."""
    last = np.searchsorted(knots, knots[len(knots) - order], side="left") - 1
    span = np.clip(np.searchsorted(knots, t, side="right") - 1, order - 1, max(last, order - 1))
    N = np.zeros((len(t), len(knots) - 1))
    N[np.arange(len(t)), span] = 1.0
    for degree in range(1, order):
        count = len(knots) - 1 - degree
        left = knots[degree : degree + count] - knots[:count]
        right = knots[degree + 1 : degree + 1 + count] - knots[1 : 1 + count]
        with np.errstate(all="ignore"):
            a, b = np.where(left > 0, 1.0 / left, 0.0), np.where(right > 0, 1.0 / right, 0.0)
        lower, upper = N[:, :count], N[:, 1 : count + 1]
        if derivative and degree == order - 1:
            N = degree * (lower * a - upper * b)
        else:
            N = lower * a * (t[:, None] - knots[:count]) + upper * b * (
                knots[degree + 1 : degree + 1 + count] - t[:, None]
            )
    return N[:, : len(knots) - order]
