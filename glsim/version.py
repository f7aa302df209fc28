"""The version of glsim."""

__version__ = "0.1.0"
