"""``python -m glsim`` is the command ``glsim``."""

import sys

from glsim.cli import main

sys.exit(main())
