"""Programs that are drawn by glsim and by the driver's own fixed function, and compared."""

from tests.oracle import (  # noqa: F401  they add to PROGRAMS
    form_programs,
    fragment_programs,
    line_programs,
    list_programs,
    pixel_programs,
    texture_programs,
    unit_programs,
    wrap_programs,
)
from tests.oracle.programs import PROGRAMS as PROGRAMS
