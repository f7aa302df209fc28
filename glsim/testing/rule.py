"""The rule: when a picture passes as its baseline, and the sentences that say why it does not.

A picture that equals any approved baseline passes.  Pictures of the renderer that made a baseline must be equal.
Another renderer rounds otherwise: then at most 2/255 may differ, more at 0.05 % of the pixels, and no block of 3 x 3
pixels may be brighter as a whole, or darker, by 2/255 or more.  Rounding scatters its differences; a wrong light, a
wrong normal or vertex moves whole regions one way, however little.  FLIP and SSIM are told and never decide.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf
from typing import NamedTuple

import numpy as np

from glsim.images import Pixels
from glsim.metrics import VISIBLE, difference, metrics, same_sign_blocks
from glsim.names import did_you_mean
from glsim.testing.baselines import Baseline, same_renderer

FEW = 0.0005  # the share of pixels that may differ by more than VISIBLE
HIGHEST = {
    "max": 255.0,
    "mean": 255.0,
    "rmse": 255.0,
    "different": 1.0,
    "ssim": 1.0,
    "flip": 1.0,
    "blocks": inf,
}
SAME = "The renderer is the one that made the baseline: then pictures must be equal."
UNKNOWN = "No renderer is known of this picture and of the baseline: then they must be equal."

Ranges = Mapping[str, tuple[float, float]]


class Verdict(NamedTuple):
    """passed: whether the picture did; exact: whether it equals a baseline.  closest: the most similar baseline, and
    its pixels.

    reason: sentences that say why the picture failed, or by what it passed although it is not equal."""

    passed: bool
    exact: bool
    closest: Baseline
    expected: Pixels
    reason: str


def ranges_of(tolerances: Mapping[str, object]) -> dict[str, tuple[float, float]]:
    """``{"max": 4, "mean": (0.5, 2)}`` as ranges (least, most).  One number is the largest value
    that passes; of ssim, which is 1 for equal pictures, the smallest.

    Raises TypeError, ValueError for names and values that are no tolerances."""
    ranges = {}
    for name, value in tolerances.items():
        if name not in HIGHEST:
            hint = did_you_mean(name, HIGHEST)
            raise TypeError(f"gl_snapshot: a tolerance is one of {', '.join(HIGHEST)}, not {name}{hint}")
        pair = value if isinstance(value, tuple) else (value, HIGHEST[name]) if name == "ssim" else (0.0, value)
        if len(pair) != 2 or not all(isinstance(n, (int, float)) for n in pair) or not pair[0] <= pair[1]:
            raise ValueError(f"gl_snapshot: {name} is a number or a range (least, most), not {value!r}")
        ranges[name] = (float(pair[0]), float(pair[1]))
    return ranges


def must_differ(ranges: Ranges) -> bool:
    """Whether a picture that equals its baseline would fail."""
    return any(not least <= (1.0 if name == "ssim" else 0.0) <= most for name, (least, most) in ranges.items())


def judge(
    actual: Pixels, made: Mapping[str, str], approved: Sequence[tuple[Baseline, Pixels]], ranges: Ranges | None = None
) -> Verdict:
    """Hold a picture against its approved baselines, at least one.

    made: the facts of the picture: its renderer and version.  ranges: tolerances instead of the rule; they are held
    against the closest baseline.
    """
    ordered = sorted(approved, key=lambda pair: _distance(pair[1], actual))
    closest, expected = ordered[0]
    if ranges:
        wrong = _outside(expected, actual, ranges)
        return Verdict(not wrong, False, closest, expected, wrong or "Within the tolerances that the test asks for.")
    if np.array_equal(expected, actual):
        return Verdict(True, True, closest, expected, "")
    if any(same_renderer(baseline.facts, made) for baseline, _ in approved):
        reason = "" if expected.shape != actual.shape else SAME if made.get("renderer") else UNKNOWN
        return Verdict(False, False, closest, expected, f"{told(expected, actual)} {reason}".strip())
    for baseline, pixels in ordered:
        if pixels.shape == actual.shape and not (reason := broken(pixels, actual)):
            reason = f"{told(pixels, actual)} This is within the rule for another renderer."
            return Verdict(True, False, baseline, pixels, reason)
    reason = broken(expected, actual) if expected.shape == actual.shape else ""
    return Verdict(False, False, closest, expected, f"{told(expected, actual)} {reason}".strip())


def _distance(expected: Pixels, actual: Pixels) -> float:
    """The mean difference; infinite if the sizes differ."""
    return float(np.abs(difference(expected, actual)).mean()) if expected.shape == actual.shape else inf


def counts(expected: Pixels, actual: Pixels) -> tuple[int, int]:
    """The number of pixels that differ by more than VISIBLE, and of blocks that are brighter or darker as a whole."""
    more = (np.abs(difference(expected, actual)) > VISIBLE).any(axis=2)
    return int(more.sum()), same_sign_blocks(expected, actual)


def broken(expected: Pixels, actual: Pixels) -> str:
    """In words, what two pictures of one size break of the rule for another renderer; "" if nothing."""
    more, blocks = counts(expected, actual)
    pixels = actual.shape[0] * actual.shape[1]
    parts = []
    if more > FEW * pixels:
        parts.append(
            f"{more} pixels ({more / pixels:.2%}) differ by more than {VISIBLE}/255, and {FEW:.2%} are allowed"
        )
    if blocks:
        parts.append(
            f"{blocks} blocks of 3 x 3 pixels are brighter or darker as a whole, which is no rounding: a light, a"
            " normal, a colour or a vertex is another one"
        )
    return f"The baseline is of another renderer: {'; and '.join(parts)}." if parts else ""


def _outside(expected: Pixels, actual: Pixels, ranges: Ranges) -> str:
    """Which tolerances the picture is outside of; "" if of none."""
    if expected.shape != actual.shape:
        return told(expected, actual)
    values = {**metrics(expected, actual), "blocks": float(same_sign_blocks(expected, actual))}
    parts = []
    for name, (least, most) in ranges.items():
        if name not in values:
            raise ModuleNotFoundError("gl_snapshot: flip needs the package flip-evaluator (pip install flip-evaluator)")
        if not least <= values[name] <= most:
            parts.append(f"{name} is {values[name]:.4g}, and the test asks for {least:g} to {most:g}")
    return f"{'; '.join(parts)}." if parts else ""


def told(expected: Pixels, actual: Pixels) -> str:
    """How a picture differs from its baseline, in sentences."""
    if expected.shape != actual.shape:
        sizes = [f"{picture.shape[1]} x {picture.shape[0]}" for picture in (actual, expected)]
        return f"The picture is {sizes[0]} pixels, the baseline {sizes[1]}."
    d = np.abs(difference(expected, actual))
    numbers = metrics(expected, actual)
    differs = d.any(axis=2)
    sentences = [
        f"{int(differs.sum())} of {differs.size} pixels differ, by at most {int(d.max())}/255 (mean"
        f" {numbers['mean']:.3g}, SSIM {numbers['ssim']:.4f}{_flip(numbers)})."
    ]
    if alpha := int(d[..., 3].astype(bool).sum()):
        y, x = np.argwhere(d[..., 3])[0]
        sentences.append(
            f"Alpha differs at {alpha} pixels, first at x = {x}, y = {y}: {actual[y, x, 3]} instead of"
            f" {expected[y, x, 3]}."
        )
    return " ".join(sentences + _suspicions(expected, actual))


def _flip(numbers: Mapping[str, float]) -> str:
    return f", FLIP {numbers['flip']:.4f}" if "flip" in numbers else ""


def _suspicions(expected: Pixels, actual: Pixels) -> list[str]:
    """Sentences for mistakes that are made with whole pictures."""
    found = []
    if np.array_equal(expected, actual):
        return []
    if sentence := empty(actual):
        found.append(sentence)
    if np.array_equal(expected, actual[::-1]):
        found.append('The picture is upside down: origin="lower" says that the first row is at the bottom.')
    if np.array_equal(expected, actual[..., [2, 1, 0, 3]]):
        found.append("Red and blue are exchanged.")
    grey = [not np.ptp(picture[..., :3], axis=2).any() for picture in (actual, expected)]
    if grey == [True, False]:
        found.append("The picture is grey, the baseline has colours.")
    elif grey == [False, True]:
        found.append("The picture has colours, the baseline is grey.")
    return found


def empty(picture: Pixels) -> str:
    """A sentence if all pixels are the same, else ""."""
    first = picture[0, 0]
    same = bool((picture == first).all())
    return f"All pixels are {tuple(int(c) for c in first)}: was anything drawn?" if same else ""
