"""Programs that are drawn by glsim and by the driver's own fixed function, and compared."""

from tests.oracle import fragment_programs, list_programs, texture_programs  # noqa: F401  they add to PROGRAMS
from tests.oracle.programs import PROGRAMS as PROGRAMS
