"""What gluNewNurbsRenderer makes: the properties of NURBS, and what is being described."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.glu.constants import NAMES
from glsim.glu.errors import warn
from glsim.glu.spline import Spline

Float = NDArray[np.float64]
TOLERANCE, DISPLAY_MODE, SAMPLING_METHOD, U_STEP, V_STEP, AUTO_LOAD_MATRIX, CULLING, PARAMETRIC_TOLERANCE, MODE = (
    NAMES[f"GLU_{name}"]
    for name in (
        "SAMPLING_TOLERANCE", "DISPLAY_MODE", "SAMPLING_METHOD", "U_STEP", "V_STEP", "AUTO_LOAD_MATRIX", "CULLING",
        "PARAMETRIC_TOLERANCE", "NURBS_MODE",
    )
)  # fmt: skip
RENDERER = NAMES["GLU_NURBS_RENDERER"]
OBJECT_METHODS: tuple[int, ...] = (NAMES["GLU_OBJECT_PATH_LENGTH"], NAMES["GLU_OBJECT_PARAMETRIC_ERROR"])
CHOICES: dict[int, tuple[int, ...]] = {
    DISPLAY_MODE: (NAMES["GLU_FILL"], NAMES["GLU_OUTLINE_POLYGON"], NAMES["GLU_OUTLINE_PATCH"]),
    SAMPLING_METHOD: (
        NAMES["GLU_PATH_LENGTH"], NAMES["GLU_PARAMETRIC_ERROR"], NAMES["GLU_DOMAIN_DISTANCE"], *OBJECT_METHODS,
    ),
    MODE: (RENDERER, NAMES["GLU_NURBS_TESSELLATOR"]),
}  # fmt: skip


class Nurbs:
    """gluNewNurbsRenderer: properties, and what is being described between Begin and End."""

    def __init__(self) -> None:
        self.properties: dict[int, float] = {
            TOLERANCE: 50.0, DISPLAY_MODE: NAMES["GLU_FILL"], SAMPLING_METHOD: NAMES["GLU_PATH_LENGTH"], U_STEP: 100.0,
            V_STEP: 100.0, AUTO_LOAD_MATRIX: 1.0, CULLING: 0.0, PARAMETRIC_TOLERANCE: 0.5, MODE: RENDERER,
        }  # fmt: skip
        self.begun = ""  # "Curve" or "Surface"
        self.maps: dict[str, Spline] = {}
        self.trims: list[list[Float]] = []
        self.trimming = False
        self.matrices: tuple[Float, Float, Float] | None = None
        self.callbacks: dict[str, tuple[Callable[..., Any], bool]] = {}  # name -> function, whether it wants the data
        self.data: Any = None

    def fail(self, error: str | int, sentence: str) -> None:
        """Call the error callback, or issue a GLUWarning.  error: name of the code, or k of GLU_NURBS_ERRORk."""
        code = NAMES[error if isinstance(error, str) else f"GLU_NURBS_ERROR{error}"]
        if "ERROR" not in self.callbacks:
            warn(code, sentence)
        else:
            self.callbacks["ERROR"][0](code)

    def call(self, name: str, *arguments: Any) -> None:
        if name in self.callbacks:
            function, wants_data = self.callbacks[name]
            function(*arguments, *((self.data,) if wants_data else ()))
