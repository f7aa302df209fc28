"""glsim.metrics: numbers with a known value."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter

from glsim import metrics


def grey(value: int, size: tuple[int, int] = (16, 16)) -> np.ndarray:
    return np.full((*size, 4), value, np.uint8)


def test_values_of_equal_and_of_uniform_pictures() -> None:
    equal = metrics.metrics(grey(90), grey(90))
    assert {name: equal[name] for name in ("max", "mean", "rmse", "different", "ssim")} == {
        "max": 0.0, "mean": 0.0, "rmse": 0.0, "different": 0.0, "ssim": 1.0
    }  # fmt: skip
    brighter = metrics.metrics(grey(90), grey(93))
    assert (brighter["max"], brighter["mean"], brighter["different"]) == (3.0, 3.0, 1.0)
    assert brighter["rmse"] == pytest.approx(3.0)
    c_1 = (0.01 * 255) ** 2  # uniform pictures: only the factor of the means remains
    assert brighter["ssim"] == pytest.approx((2 * 90 * 93 + c_1) / (90**2 + 93**2 + c_1))
    one = grey(0)
    one[3, 4, 1] = 8
    assert metrics.metrics(grey(0), one)["rmse"] == pytest.approx(8 / (16 * 16 * 4) ** 0.5)


def test_blocks_of_one_sign() -> None:
    a = grey(100, (20, 30))
    for change, least, expected in ((2, 2, 1), (-2, 2, 1), (1, 2, 0), (1, 1, 1), (-300, 2, 1)):
        b = a.astype(int)
        b[5:8, 9:12, 2] += change
        assert metrics.same_sign_blocks(a, np.clip(b, 0, 255).astype(np.uint8), least) == expected, change
    b = a.astype(int)
    b[5:8, 9:12, 2] += 5
    b[6, 10, 2] -= 10  # one pixel the other way
    assert metrics.same_sign_blocks(a, b.astype(np.uint8)) == 0
    b[5:8, 9:12] = 100
    b[5:8, 9:11, 1] += 5
    b[5:8, 11, 2] += 5  # nine pixels, but no channel has all
    assert metrics.same_sign_blocks(a, b.astype(np.uint8)) == 0
    assert metrics.same_sign_blocks(a[:2], a[:2] + 9) == 0, "too small for a block"


def test_pictures_of_two_sizes_get_a_sentence() -> None:
    with pytest.raises(ValueError, match="not 16 x 16 with 4 channels and 16 x 8 with 4 channels"):
        metrics.metrics(grey(1), grey(1, (8, 16)))


@pytest.mark.parametrize("shape", [(1, 1), (3, 40), (37, 24)])
def test_the_window_is_scipys_gaussian_filter(shape: tuple[int, int]) -> None:
    values = np.random.default_rng(5).random(shape) * 255.0
    expected = gaussian_filter(values, 1.5, truncate=5 / 1.5)
    assert np.allclose(metrics.windowed(values), expected, rtol=0.0, atol=1e-9)
