"""Which boxes overlap: the question behind polygons that touch, and layers that lie on each other."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.radiosity.compiled import jit

Float = NDArray[np.float64]
Int = NDArray[np.int64]


def overlapping(one: tuple[Float, Float], two: tuple[Float, Float]) -> tuple[Int, Int]:
    """Return all pairs of boxes that overlap: the numbers of the first (k,) and of the second (k,), by the first.

    one, two: the lowest and the highest corners of boxes, (n, 3) and (m, 3) each.  The boxes are sorted along the axis
    on which they are spread most, so that most pairs are never looked at.
    """
    axis = int(np.argmax(np.std(np.concatenate([one[0], two[0]]), axis=0)))
    order = np.argsort(two[0][:, axis], kind="stable")
    low, high = two[0][order], two[1][order]
    highest = np.maximum.accumulate(high[:, axis])  # from where on a box may reach back to a place
    first = np.searchsorted(highest, one[0][:, axis])
    last = np.searchsorted(low[:, axis], one[1][:, axis], side="right")
    rows, columns = _overlapping(*one, low, high, first, last)
    columns = order[columns]
    sorted_ = np.lexsort((columns, rows))
    return rows[sorted_], columns[sorted_]


@jit
def _overlapping(low_1: Any, high_1: Any, low_2: Any, high_2: Any, first: Any, last: Any) -> Any:
    """Return the pairs of ``overlapping``, of which box i of the first needs only ``first[i]`` to ``last[i]``."""
    rows, columns = np.empty(0, np.int64), np.empty(0, np.int64)
    for again in range(2):  # first they are counted
        found = 0
        for i in range(len(low_1)):
            for j in range(first[i], last[i]):
                apart = False
                for k in range(3):
                    apart |= low_1[i, k] > high_2[j, k] or low_2[j, k] > high_1[i, k]
                if not apart:
                    if again:
                        rows[found], columns[found] = i, j
                    found += 1
        if not again:
            rows, columns = np.empty(found, np.int64), np.empty(found, np.int64)
    return rows, columns
