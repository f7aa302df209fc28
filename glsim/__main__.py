"""``python -m glsim`` is the command ``glsim``."""

import sys

if not sys.flags.safe_path and sys.path:
    del sys.path[0]  # the folder of the program that is run: its random.py must not stand in for Python's

from glsim.cli import main

sys.exit(main())
