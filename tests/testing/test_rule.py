"""The rule: mistakes fail, harmless differences pass, and sentences say why."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from glsim.images import Pixels
from glsim.testing.baselines import Baseline
from glsim.testing.rule import Verdict, empty, judge, must_differ, ranges_of
from tests.testing.sensitivity import HARMLESS, MISTAKES, TINY, passes

HERE = {"renderer": "here", "version": "1"}
ELSEWHERE = {"renderer": "elsewhere", "version": "1"}


def picture(height: int = 40, width: int = 60, seed: int = 1) -> Pixels:
    """Random colours, opaque."""
    pixels = np.random.default_rng(seed).integers(0, 256, (height, width, 4), dtype=np.uint8)
    pixels[..., 3] = 255
    return pixels


def judged(actual: Pixels, *expected: Pixels, facts: dict[str, str] = HERE, **tolerances: object) -> Verdict:
    approved = [(Baseline(Path(f"{k}.png"), facts), pixels) for k, pixels in enumerate(expected)]
    return judge(actual, HERE, approved, ranges_of(tolerances))


def test_the_table_is_long_enough() -> None:
    assert len(MISTAKES) >= 15
    assert len(HARMLESS) >= 6


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_fails(name: str) -> None:
    pair = MISTAKES[name]()
    assert not passes(pair)
    assert not passes(pair, "this")


@pytest.mark.parametrize("name", TINY)
def test_a_mistake_of_the_size_of_rounding_fails_where_the_baseline_was_made(name: str) -> None:
    assert not passes(TINY[name](), "this")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow if "softpipe" in name else ()) for name in HARMLESS]
)
def test_a_harmless_difference_passes(name: str) -> None:
    assert passes(HARMLESS[name]())


def test_one_step_in_one_pixel_fails_with_the_same_renderer_only() -> None:
    expected = picture()
    actual = expected.copy()
    actual[7, 9, 1] ^= 1
    verdict = judged(actual, expected)
    assert not verdict.passed
    assert "1 of 2400 pixels differ, by at most 1/255" in verdict.reason
    assert "made the baseline: then pictures must be equal" in verdict.reason
    assert judged(actual, expected, facts=ELSEWHERE).passed


def test_any_approved_baseline_may_match_and_the_closest_is_named() -> None:
    a, b, c = (picture(seed=seed) for seed in (1, 2, 3))
    assert judged(b, a, b, c).exact
    near = b.copy()
    near[0, 0] = 0
    verdict = judged(near, a, b, c)
    assert not verdict.passed
    assert verdict.closest.path.name == "1.png"


@pytest.mark.parametrize("facts", [HERE, ELSEWHERE])
def test_sizes(facts: dict[str, str]) -> None:
    verdict = judged(picture(60, 100), picture(100, 100), facts=facts)
    assert not verdict.passed
    assert verdict.reason == "The picture is 100 x 60 pixels, the baseline 100 x 100."


def test_sentences_for_whole_pictures() -> None:
    expected = picture()
    clear, grey, black = expected.copy(), expected.copy(), np.zeros_like(expected)
    clear[3, 5, 3] = 128
    grey[..., :3] = grey[..., :1]
    black[..., 3] = 255
    assert "Alpha differs at 1 pixels, first at x = 5, y = 3: 128 instead of 255." in judged(clear, expected).reason
    assert "The picture is grey, the baseline has colours." in judged(grey, expected).reason
    assert "The picture has colours, the baseline is grey." in judged(expected, grey).reason
    assert "All pixels are (0, 0, 0, 255): was anything drawn?" in judged(black, expected).reason
    assert "upside down" in judged(expected[::-1], expected).reason
    assert "Red and blue are exchanged." in judged(expected[..., [2, 1, 0, 3]], expected).reason
    assert empty(expected) == ""


def test_tolerances_have_both_ends() -> None:
    expected = picture()
    actual = expected.copy()
    actual[..., 0] ^= 4
    assert judged(actual, expected, max=4, ssim=0.9).passed
    assert not judged(actual, expected, max=3).passed
    assert judged(actual, expected, max=(1, 4)).passed
    assert judged(expected, expected, max=4).passed
    same = judged(expected, expected, max=(1, 4))
    assert not same.passed
    assert same.reason == "max is 0, and the test asks for 1 to 4."
    assert judged(actual, expected, different=(0.99, 1.0), mean=(0.9, 1.1)).passed
    assert not judged(picture(10, 10), expected, max=255).passed


def test_what_is_no_tolerance() -> None:
    with pytest.raises(TypeError, match="did you mean 'mean'"):
        ranges_of({"meen": 1})
    for value in ((2, 1), (1, 2, 3), "4", (float("nan"), 1)):
        with pytest.raises(ValueError, match="a number or a range"):
            ranges_of({"max": value})
    assert must_differ(ranges_of({"mean": (0.1, 5)}))
    assert must_differ(ranges_of({"ssim": (0.1, 0.9)}))
    assert not must_differ(ranges_of({"ssim": 0.9, "max": 3}))


def test_pictures_smaller_than_a_block() -> None:
    expected = picture(2, 2)
    assert judged(expected, expected, facts=ELSEWHERE).passed
    assert not judged(255 - expected, expected, facts=ELSEWHERE).passed
