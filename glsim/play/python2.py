"""Programs written for Python 2: recognized, and converted in memory by a fork of 2to3."""

from __future__ import annotations

import ast
import builtins
import logging
import string
import sys
import types
import warnings
from functools import cache
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, SourceFileLoader
from numbers import Integral
from typing import Any

NOT_INSTALLED = "install glsim with `pip install glsim[python2]` to have it converted"


class ConversionError(Exception):
    """A program is neither Python 3 nor something that can be converted."""


def compiled_program(source: bytes, name: str, convert: bool = True) -> tuple[types.CodeType, bool]:
    """The code of a program, and whether it was converted from Python 2.

    convert: whether conversion is allowed.  Raises SyntaxError, with Python 3's own message and line, if the program
    neither compiles as Python 3 nor converts, or if its only mistake is that it mixes tabs and spaces.
    """
    if not convert or is_python_3(source.expandtabs(8), name):
        return compile(source, name, "exec"), False
    try:
        code = compiled(source, name)
    except ConversionError as reason:
        raise _mistake(source, name, str(reason)) from None
    prepare()
    return code, True


def _mistake(source: bytes, name: str, reason: str) -> Exception:
    """Why Python 3 does not take a program; reason: why it was not converted."""
    try:
        compile(source, name, "exec")
    except (SyntaxError, ValueError) as mistake:
        if reason == NOT_INSTALLED:
            mistake.add_note(f"If it is Python 2: {reason}")
        return mistake
    return SyntaxError(reason)


def is_python_3(source: bytes, name: str) -> bool:
    """Whether a program is one of Python 3, as far as its syntax tells."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(source, name)
    except (SyntaxError, ValueError):
        return False
    return not any(map(_prints_to_a_file, ast.walk(tree)))


def _prints_to_a_file(node: ast.AST) -> bool:
    """Whether a node is ``print >>log``: valid syntax in Python 3, but only meaningful in Python 2."""
    shifted = isinstance(node, ast.BinOp) and isinstance(node.op, ast.RShift)
    return shifted and isinstance(node.left, ast.Name) and node.left.id == "print"  # type: ignore[attr-defined]


def converted(source: bytes, name: str) -> str:
    """The program in Python 3.  Raises ConversionError with the reason."""
    driver = _driver()
    encodings = ("utf-8", "latin-1")
    text = next(source.decode(e) for e in encodings if _decodes(source, e)).replace("\r\n", "\n").expandtabs(8)
    try:
        return str(driver(text + ("" if text.endswith("\n") else "\n"), name))
    except Exception as error:
        raise ConversionError(f"it is no Python 3, and as Python 2 it cannot be converted: {error}") from None


def compiled(source: bytes, name: str) -> types.CodeType:
    """The code of a program of Python 2, in which / of two integers gives an integer.  Raises ConversionError."""
    tree = ast.fix_missing_locations(_CharacterArrays().visit(ast.parse(converted(source, name), name)))
    future = [node for node in tree.body if isinstance(node, ast.ImportFrom) and node.module == "__future__"]
    if not any(alias.name == "division" for node in future for alias in node.names):
        tree = ast.fix_missing_locations(_Division().visit(tree))
    builtins.__dict__[DIVIDE], builtins.__dict__[CHARACTERS] = divide, Characters
    return compile(tree, name, "exec")


DIVIDE = "_python_2_division"


def divide(a: Any, b: Any) -> Any:
    """a / b as Python 2 has it."""
    if type(a) is float or type(b) is float:
        return a / b
    whole = all(isinstance(x, Integral) or getattr(getattr(x, "dtype", None), "kind", "") in ("i", "u") for x in (a, b))
    return a // b if whole else a / b


class _Division(ast.NodeTransformer):
    """a / b -> divide(a, b)."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        if not isinstance(node.op, ast.Div):
            return node
        return ast.copy_location(self._call(node.left, node.right), node)

    def visit_AugAssign(self, node: ast.AugAssign) -> ast.AST:
        self.generic_visit(node)
        if not isinstance(node.op, ast.Div) or not isinstance(node.target, ast.Name):
            return node
        before = ast.copy_location(ast.Name(node.target.id, ast.Load()), node)
        return ast.copy_location(ast.Assign([node.target], self._call(before, node.value)), node)

    def _call(self, left: ast.expr, right: ast.expr) -> ast.Call:
        return ast.Call(ast.Name(DIVIDE, ast.Load()), [left, right], [])


CHARACTERS = "_python_2_characters"


class _CharacterArrays(ast.NodeTransformer):
    """array("c", ...) -> Characters(...)."""

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name == "array" and node.args and isinstance(node.args[0], ast.Constant) and node.args[0].value == "c":
            return ast.copy_location(ast.Call(ast.Name(CHARACTERS, ast.Load()), node.args[1:], node.keywords), node)
        return node


class Characters(bytearray):
    """Python 2's array("c"): bytes that are read and written as characters."""

    typecode, itemsize = "c", 1

    def __init__(self, characters: Any = "") -> None:
        super().__init__(_as_bytes(characters))

    def __getitem__(self, place: Any) -> Any:
        characters = super().__getitem__(place)
        return Characters(characters) if isinstance(place, slice) else chr(characters)

    def __setitem__(self, place: Any, value: Any) -> None:
        characters = _as_bytes(value)
        super().__setitem__(place, characters if isinstance(place, slice) else characters[0])

    def __iter__(self) -> Any:
        return map(chr, bytes(self))

    def __add__(self, other: Any) -> Any:
        return Characters(bytes(self) + _as_bytes(other))

    def __mul__(self, count: Any) -> Any:
        return Characters(bytes(self) * count)

    def append(self, character: Any) -> None:
        super().append(_as_bytes(character)[0])

    def extend(self, characters: Any) -> None:
        super().extend(_as_bytes(characters))

    fromstring = fromlist = extend

    def tostring(self) -> str:
        return self.decode("latin-1")

    def tolist(self) -> list[str]:
        return list(map(chr, bytes(self)))


def _as_bytes(characters: Any) -> bytes:
    if isinstance(characters, (bytes, bytearray)):
        return bytes(characters)
    return "".join(characters).encode("latin-1")


# ---------------------------------------------------------------- what such programs import

OLD_MODULES = {
    "Image": "PIL.Image", "ImageDraw": "PIL.ImageDraw", "ImageFont": "PIL.ImageFont", "Numeric": "numpy",
    "numarray": "numpy",
}  # fmt: skip


@cache
def prepare() -> None:
    """Make modules and string functions of Python 2 importable under their old names."""
    sys.meta_path.append(_OldModules())
    for name in ("split", "join", "lower", "upper", "replace", "strip", "lstrip", "rstrip", "find", "count"):
        if not hasattr(string, name):
            setattr(string, name, getattr(str, name))
    extra = {"join": lambda words, between=" ": between.join(words), "atoi": int, "atof": float}
    for name, function in extra.items():
        setattr(string, name, function)
    string.letters = string.ascii_letters  # type: ignore[attr-defined]


class ConvertingLoader(SourceFileLoader):
    """Loads modules of Python 3, and those of Python 2 converted."""

    def source_to_code(self, data: Any, path: Any, *, _optimize: int = -1) -> Any:  # type: ignore[override]
        return compiled_program(bytes(data), str(path))[0]

    def cache_from_source(self, path: str) -> str:
        raise NotImplementedError  # nothing is written beside the program


class _OldModules(MetaPathFinder, Loader):
    """``import Image`` gives PIL.Image."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        return ModuleSpec(name, self) if name in OLD_MODULES else None

    def exec_module(self, module: types.ModuleType) -> None:
        """Nothing is left to do."""

    def create_module(self, spec: ModuleSpec) -> types.ModuleType:
        name = spec.name
        module: Any = import_module(OLD_MODULES[name])
        if name == "Image":
            module.Image.tostring = module.Image.tobytes
            module.fromstring = module.frombytes
        copy = types.ModuleType(name)
        copy.__dict__.update({key: value for key, value in vars(module).items() if not key.startswith("__")})
        return copy


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
            raise ConversionError(NOT_INSTALLED) from None
    logging.getLogger("RefactoringTool").setLevel(logging.ERROR)
    package = refactor.__name__.partition(".")[0]
    names = refactor.get_fixers_from_package(f"{package}.fixes")
    tool = refactor.RefactoringTool([n for n in names if not n.endswith((".fix_import", ".fix_asserts"))])
    return tool.refactor_string
