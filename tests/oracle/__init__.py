"""Programs that are drawn by glsim and by the driver's own fixed function, and compared."""

from tests.oracle import (  # noqa: F401  they add to PROGRAMS
    array_programs,
    bitmap_programs,
    evaluator_programs,
    form_programs,
    fragment_programs,
    light_programs,
    line_programs,
    list_programs,
    material_programs,
    pixel_programs,
    target_programs,
    texture_programs,
    unit_programs,
    wrap_programs,
)
from tests.oracle.programs import PROGRAMS as PROGRAMS
