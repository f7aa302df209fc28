"""Programs written for Python 2: recognized, and converted in memory by a fork of 2to3."""

from __future__ import annotations

import ast
import logging
import warnings
from importlib import import_module
from typing import Any


class ConversionError(Exception):
    """A program is neither Python 3 nor something that can be converted."""


def is_python_3(source: bytes, name: str) -> bool:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(source, name)
    except (SyntaxError, ValueError):
        return False
    return True


def converted(source: bytes, name: str) -> str:
    """The program in Python 3.  Raises ConversionError with the reason."""
    driver = _driver()
    encodings = ("utf-8", "latin-1")
    text = next(source.decode(e) for e in encodings if _decodes(source, e)).replace("\r\n", "\n").expandtabs(8)
    try:
        return str(driver(text + ("" if text.endswith("\n") else "\n"), name))
    except Exception as error:
        raise ConversionError(f"it is no Python 3, and as Python 2 it cannot be converted: {error}") from None


def _decodes(source: bytes, encoding: str) -> bool:
    try:
        source.decode(encoding)
    except UnicodeDecodeError:
        return False
    return True


def _driver() -> Any:
    warnings.simplefilter("ignore", DeprecationWarning)
    try:
        refactor = import_module("fissix.refactor")
    except ImportError:
        try:
            refactor = import_module("lib2to3.refactor")
        except ImportError:
            raise ConversionError(
                "it looks like Python 2: install glsim with `pip install glsim[python2]` to convert it"
            ) from None
    logging.getLogger("RefactoringTool").setLevel(logging.ERROR)
    package = refactor.__name__.partition(".")[0]
    names = refactor.get_fixers_from_package(f"{package}.fixes")
    tool = refactor.RefactoringTool([n for n in names if not n.endswith((".fix_import", ".fix_asserts"))])
    return tool.refactor_string
