"""Fixtures of several files: form factors of the closed Cornell box, and its path-traced radiosity."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

if TYPE_CHECKING:
    from glsim.radiosity.formfactors import FormFactors

# Without the packages of glsim[radiosity] none of these files can be imported.
collect_ignore_glob = [] if find_spec("numba") and find_spec("embreex") else ["test_*.py"]


QUICK = {"test_bad_input.py", "test_files.py", "test_rooms.py", "test_patches.py"}


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What solves whole scenes is slow."""
    for item in items:
        if item.path.parent == Path(__file__).parent and item.path.name not in QUICK:
            item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="package")
def closed() -> FormFactors:
    from glsim.radiosity.methods import compute
    from glsim.radiosity.scenes import BUILT_IN
    from glsim.radiosity.subdivide import subdivide

    return compute(subdivide(BUILT_IN["cornell-closed"].make().checked(), 900))


@pytest.fixture(scope="package")
def traced() -> dict[str, np.ndarray]:
    from tests.radiosity.helpers import REFERENCE

    with np.load(REFERENCE / "cornell_black_front.npz") as stored:
        return {name: stored[name] for name in stored.files}
