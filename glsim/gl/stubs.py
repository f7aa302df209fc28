"""The type stubs of gl, glu and glut: what editors and type checkers know of them."""

from __future__ import annotations

import ctypes
import inspect
from importlib import import_module
from types import ModuleType
from typing import Any

from glsim.machine.commands import COMMANDS

PYTHON_TYPE = {"f": "float", "d": "float", "data": "Numbers", "any": "Any"}  # others: int

GL = '''\
"""Signatures and manual of the gl commands.  Written by ``python -m glsim.gl.generate``; do not edit."""

import ctypes
from collections.abc import Sequence
from typing import Any

from glsim.machine.constants import Enum
from glsim.machine.errors import GLError as GLError
from glsim.machine.errors import NoContextError as NoContextError

Numbers = float | Sequence[Any] | Any  # a number, a sequence of numbers, a numpy or ctypes array
'''


def gl_stubs() -> str:
    """glsim/gl/__init__.pyi: the signature and manual of every command, the type of every constant."""
    values = _public("glsim.gl")
    declared = [_declaration(name, value) for name, value in values.items() if name != "GLError"]
    functions = [_function(name, value) for name, value in values.items() if inspect.isfunction(value)]
    return "\n".join([GL, _all(values), *filter(None, declared), "", *functions]) + "\n"


def library_stubs(library: str) -> str:
    """glsim/glu/__init__.pyi or glsim/glut/__init__.pyi: functions and classes from the files that define them."""
    values = _public(f"glsim.{library}")
    about = f'"""What {library} gives.  Written by ``python -m glsim.gl.generate``; do not edit."""'
    imports = ["from collections.abc import Callable", "from typing import Any"]
    defined = {name: value for name, value in values.items() if inspect.isfunction(value) and not _is_written(value)}
    for name, value in values.items():
        if name not in defined and _is_defined(value):
            imports.append(f"from {value.__module__} import {value.__name__} as {name}")
        elif name not in defined and type(value) not in (bool, int, float, ModuleType):
            imports.append(f"from {type(value).__module__} import {type(value).__name__}")
    declared = [_declaration(name, value) for name, value in values.items()]
    functions = [
        _signature(name, str(inspect.signature(value)).replace("'", ""), value) for name, value in defined.items()
    ]
    lines = [about, "", *dict.fromkeys(imports), "", _all(values), *filter(None, declared), "", *functions]
    return "\n".join(lines) + "\n"


def _public(module: str) -> dict[str, Any]:
    exported: Any = import_module(module)
    return {name: getattr(exported, name) for name in sorted(exported.__all__)}


def _is_defined(value: Any) -> bool:
    return inspect.isfunction(value) or inspect.isclass(value)


def _is_written(function: Any) -> bool:
    """Whether its file has a def for it, which type checkers and editors find."""
    return f"def {function.__name__}(" in inspect.getsource(import_module(function.__module__))


def _all(values: dict[str, Any]) -> str:
    return "\n".join(["__all__ = [", *(f'    "{name}",' for name in values), "]", ""])


def _declaration(name: str, value: Any) -> str:
    """The line that gives a name its type, "" for functions and for classes of glsim."""
    if isinstance(value, ModuleType):
        return f"import {value.__name__} as {name}"
    if inspect.isclass(value) and issubclass(value, ctypes.Array):
        return f"{name}: type[ctypes.Array[ctypes.{value._type_.__name__}]]"
    if inspect.isclass(value) and issubclass(value, ctypes._SimpleCData):
        return f"{name} = ctypes.{value.__name__}"
    return "" if _is_defined(value) else f"{name}: {type(value).__name__ if value is not None else None}"


def _function(name: str, function: Any) -> str:
    command = COMMANDS.get(name)
    kinds = dict(command.arguments) if command else {}
    parameters = inspect.signature(function).parameters.values()
    several_forms = any(parameter.default is not parameter.empty for parameter in parameters)  # PyOpenGL's, too
    words = []
    for parameter in parameters:
        kind = kinds.get(parameter.name, "any")
        written = PYTHON_TYPE.get(kind, "int") if kind == "enum" or not several_forms else "Any"
        star = "*" if parameter.kind is parameter.VAR_POSITIONAL else ""
        default = " = ..." if parameter.default is not parameter.empty else ""
        words.append(f"{star}{parameter.name}: {written}{default}")
    returns = "None" if command and not command.result else "Any"
    return _signature(name, f"({', '.join(words)}) -> {returns}", function)


def _signature(name: str, signature: str, function: Any) -> str:
    text = function.__doc__.replace("\n", "\n    ").replace("\n    \n", "\n\n")
    return f'def {name}{signature}:\n    """{text}"""\n'
