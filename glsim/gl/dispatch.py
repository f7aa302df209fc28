"""From the command table and the hand-written bodies to the public functions.

A body, such as ``glLight`` in light.py, takes the machine and the arguments in their plainest form.  Its public
functions (glLightf, glLightfv, glLighti, glLightiv) convert what they are given, refuse to run between glBegin and
glEnd if the table says so, hand the call to the recorder if there is one, and put the name of the call into errors.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache, wraps
from typing import Any

import numpy as np

from glsim.gl import immediate
from glsim.gl.arguments import numbers, retry, signed_colour
from glsim.gl.query import COLOURS, answer, into
from glsim.machine.commands import FAMILIES, Command
from glsim.machine.constants import GL_AMBIENT_AND_DIFFUSE
from glsim.machine.errors import GLError, show
from glsim.machine.sentences import MISUSE, explain, explained, is_a_sentence
from glsim.machine.types import SUFFIXES

Function = Callable[..., Any]
ERRORS = (GLError, MemoryError, *MISUSE)

# `current` is a global of immediate.py: the machine.  The local name is not m, which is an argument of glLoadMatrixf.
_TEMPLATE = """
def bind(name, body, errors, retry):
    def command({arguments}{rest}):
        machine = current
        if machine.{flag}:
            return machine.{route}(name, ({tuple}{rest}))
        try:
            return body(machine{call})
        except errors as error:
            return retry(error, name, ({tuple}))
    return command
"""
_binders: dict[tuple[int, bool, bool], Function] = {}
EXACT = ("glBegin", "glEnd")  # PyOpenGL's are Python functions, which take no surplus arguments


def _binder(count: int, inside: bool, exact: bool) -> Function:
    """The function that makes a public function of ``count`` arguments from a name and a body.

    Surplus arguments are ignored, as they are by PyOpenGL, whose commands are C functions; a recorder sees them.
    """
    if (count, inside, exact) not in _binders:
        words = [f"a{k}" for k in range(count)]
        flag, route = ("recorder", "recorder") if inside else ("busy", "intercept")
        source = _TEMPLATE.format(
            arguments="".join(f"{word}, " for word in words),
            rest="" if exact else "*surplus,",
            tuple="".join(f"{word}, " for word in words),
            call="".join(f", {word}" for word in words),
            flag=flag,
            route=route,
        )
        scope: dict[str, Any] = {}
        exec(compile(source, f"<gl command of {count} arguments>", "exec"), vars(immediate), scope)
        _binders[count, inside, exact] = scope["bind"]
    return _binders[count, inside, exact]


@cache
def _signature(parameters: tuple[str, ...], defaults: tuple[Any, ...] | None) -> inspect.Signature:
    """The specification's arguments, without the surplus ones."""
    values = (*[inspect.Parameter.empty] * (len(parameters) - len(defaults or ())), *(defaults or ()))
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    return inspect.Signature(
        [inspect.Parameter(name, kind, default=value) for name, value in zip(parameters, values, strict=True)]
    )


def public(command: Command, body: Function, parameters: tuple[str, ...], defaults: tuple[Any, ...] | None) -> Function:
    """A public function with the command's own name and argument names.

    All commands of three arguments share the code that ``_binder`` compiled once; only names differ, and a copy of the
    code with other names costs less than compiling it again.  For glTranslatef:

        code = made.__code__                               # def command(a0, a1, a2, *surplus): machine = current ...
        code.co_varnames                                   # ("a0", "a1", "a2", "surplus", "machine", "error")
        made.__code__ = code.replace(co_varnames=("x", "y", "z", "surplus", ...), co_name="glTranslatef")
        glTranslatef(x=1.0, y=0.0, z=0.0)                  # so keywords, tracebacks and help() have the true names
    """
    made = _binder(len(parameters), command.inside, command.name in EXACT)(command.name, body, ERRORS, retry)
    code = made.__code__
    made.__code__ = code.replace(
        co_name=command.name, co_varnames=(*parameters, *code.co_varnames[len(parameters) :]), co_qualname=command.name
    )
    made.__name__ = made.__qualname__ = command.name
    made.__module__ = "glsim.gl"
    made.__defaults__ = defaults
    made.__signature__ = _signature(parameters, defaults)
    return made  # type: ignore[no-any-return]


def variant(command: Command, body: Function) -> Function:
    """The public function of one row of the table, from the body of its family."""
    family = FAMILIES[command.family]
    if (len(family) == 1 and not command.vector) or body.__name__ == command.name:
        parameters = body.__code__.co_varnames[1 : body.__code__.co_argcount]
        return public(command, body, parameters, body.__defaults__)
    if command.result:  # PyOpenGL's last argument of a query: an array to fill
        return public(command, _adapt(command, body), (*command.parameters, "params"), (None,))
    return public(command, _adapt(command, body), command.parameters, None)


def _adapt(command: Command, body: Function) -> Function:
    """The body with this variant's arguments turned into the plain ones."""
    kind = command.type
    if command.result:  # glGetLightfv: numbers -> an array of the variant's type
        return lambda m, *a: into(a[-1], answer(body(m, *a[:-1]), kind, a[-2] in COLOURS))
    if command.family == "glRect" and command.vector:
        return lambda m, v1, v2: body(m, *numbers(v1)[:2], *numbers(v2)[:2])
    if command.size == 0 or command.arguments[-1][0] == "param":  # a named parameter
        return _integer_parameter(body) if kind == "i" else body
    if command.family == "glSecondaryColor" and kind in _SCALES:
        body = _scaled(body, _SCALES[kind])
    if command.vector and command.size != 16:
        many = len(command.arguments) - 1
        return lambda m, *a: body(m, *a[:many], *numbers(a[many])[: command.size])
    return body


# glSecondaryColor's integers, like glColor's (table 2.9)
_SCALES: dict[str, Callable[[float], float]] = {
    "ub": lambda x: x / 255.0,
    "us": lambda x: x / 65535.0,
    "ui": lambda x: x / 4294967295.0,
    "b": lambda x: (2 * x + 1) / 255.0,
    "s": lambda x: (2 * x + 1) / 65535.0,
    "i": signed_colour,
}


def _scaled(body: Function, scale: Callable[[float], float]) -> Function:
    return lambda m, *a: body(m, *map(scale, a))


def _integer_parameter(body: Function) -> Function:
    """glLightiv and the like: integers that are colours map linearly onto [-1, 1], others are taken as they are."""

    def integers(m: Any, *arguments: Any) -> Any:
        *first, params = arguments
        if first[-1] in COLOURS or first[-1] == GL_AMBIENT_AND_DIFFUSE:
            params = tuple(map(signed_colour, numbers(params)))
        return body(m, *first, params)

    return integers


def suffix_free(family: str, functions: dict[str, Function]) -> Function:
    """PyOpenGL's glVertex, glColor, glLight, ...: the variant follows from what is passed."""
    rows = FAMILIES[family]
    if rows[0].arguments[-1][0] == "param":
        call = _suffix_free_parameter(family, functions)
    else:
        call = _suffix_free_components(family, functions)
    call.__name__ = call.__qualname__ = family
    call.__module__ = "glsim.gl"
    return call


def _suffix_free_parameter(family: str, functions: dict[str, Function]) -> Function:
    scalar, vector = functions[f"{family}f"], functions.get(f"{family}fv")
    names = (*FAMILIES[family][0].parameters[:-1], "params")

    def call(*arguments: Any) -> Any:
        if len(arguments) < len(names):
            raise TypeError(f"{family} takes {len(names)} arguments ({', '.join(names)}), not {len(arguments)}")
        one = isinstance(arguments[len(names) - 1], (int, float)) or vector is None
        return (scalar if one else vector)(*arguments)  # type: ignore[misc]

    return explained(family, call)


def _suffix_free_components(family: str, functions: dict[str, Function]) -> Function:
    rows = FAMILIES[family]
    by_count = {row.size: functions[row.name] for row in rows if not row.vector and row.type == "d"}
    leading = len(rows[0].arguments) - rows[0].size  # glMultiTexCoord's target

    def call(*arguments: Any) -> Any:  # called once a vertex: no function around it
        try:
            rest = arguments[leading:]
            if len(rest) == 1 and not isinstance(rest[0], (int, float)):
                rest = numbers(rest[0])
            elif family == "glRect" and len(rest) == 2:
                rest = (*numbers(rest[0]), *numbers(rest[1]))
            function = by_count.get(len(rest))
            if function is None:
                counts = " or ".join(map(str, sorted(by_count)))
                raise TypeError(f"{family} takes {counts} numbers, or a sequence of them, not {len(rest)}")
            return function(*arguments[:leading], *rest)
        except Exception as error:
            raise explain(error, family, arguments, ()) from None

    return call


SUFFIX_FREE = (
    "glVertex", "glNormal", "glColor", "glTexCoord", "glMultiTexCoord", "glSecondaryColor", "glFogCoord", "glIndex",
    "glRect", "glRotate", "glTranslate", "glScale", "glRasterPos", "glWindowPos", "glEvalCoord", "glMaterial",
    "glLight", "glLightModel", "glFog", "glTexEnv", "glTexGen", "glTexParameter", "glPixelStore", "glPixelTransfer",
    "glPointParameter",
)  # fmt: skip


def _typed_last(function: Function, gl_type: int, leading: int) -> Function:
    """glReadPixelsf(x, y, width, height, format): bytes for unsigned bytes, else an array."""

    def call(*arguments: Any, array: Any = None, outputType: Any = bytes) -> Any:
        return function(*arguments[:leading], gl_type, *arguments[leading:] or (array, outputType))

    return call


def _typed_image(function: Function, gl_type: int, leading: int) -> Function:
    """glTexImage2Df(target, level, internalformat, border, format, pixels), glDrawPixelsub(format, pixels): the size is
    that of the array, width first, as PyOpenGL has it."""
    dimensions = next((n for n in (1, 2, 3) if f"{n}D" in function.__name__), 2)

    def call(*arguments: Any) -> Any:
        *before, format, pixels = arguments
        size = np.shape(pixels)[:dimensions]
        if len(size) < dimensions:
            raise ValueError(f"pixels must be an array of {dimensions} or more dimensions, not {show(pixels)}")
        return function(*before[:leading], *size, *before[leading:], format, gl_type, pixels)

    return call


def typed_arrays(functions: dict[str, Function]) -> dict[str, Function]:
    """glVertexPointerf(array), glColorPointerub(array), glDrawElementsui(mode, indices), ... as PyOpenGL has them."""

    def pointer(name: str, gl_type: int, sized: bool) -> Function:
        def call(array: Any) -> Any:
            in_buffer = hasattr(array, "bind")  # OpenGL.arrays.vbo.VBO
            values = np.asarray(array.data if in_buffer else array)
            size = (values.shape[-1] if values.ndim > 1 else 3,) if sized else ()
            return functions[name](*size, gl_type, 0, array if in_buffer else values)

        return call

    def draw_elements(gl_type: int) -> Function:
        return lambda mode, indices: functions["glDrawElements"](mode, np.size(indices), gl_type, indices)

    typed: dict[str, Function] = {}
    for suffix, gl_type in SUFFIXES.items():
        for array in ("Vertex", "Color", "TexCoord", "SecondaryColor"):
            typed[f"gl{array}Pointer{suffix}"] = pointer(f"gl{array}Pointer", gl_type, True)
        for array in ("Normal", "Index"):
            typed[f"gl{array}Pointer{suffix}"] = pointer(f"gl{array}Pointer", gl_type, False)
        if suffix in ("ub", "us", "ui"):
            typed[f"glDrawElements{suffix}"] = draw_elements(gl_type)
    for suffix, gl_type in SUFFIXES.items():
        typed[f"glReadPixels{suffix}"] = _typed_last(functions["glReadPixels"], gl_type, 5)
        typed[f"glGetTexImage{suffix}"] = _typed_last(functions["glGetTexImage"], gl_type, 3)
    for suffix, gl_type in SUFFIXES.items():
        for name, leading in (("glTexImage1D", 3), ("glTexImage2D", 3), ("glTexImage3D", 3), ("glTexSubImage1D", 3),
                              ("glTexSubImage2D", 4), ("glTexSubImage3D", 5), ("glDrawPixels", 0)):  # fmt: skip
            typed[f"{name}{suffix}"] = _typed_image(functions[name], gl_type, leading)
    typed["glEdgeFlagPointerb"] = lambda array: functions["glEdgeFlagPointer"](0, array)
    typed["glGetPolygonStippleub"] = lambda: np.frombuffer(functions["glGetPolygonStipple"](), np.uint8)
    for name, function in typed.items():
        function.__name__ = function.__qualname__ = name
    return {name: explained(name, _of_arrays(function)) for name, function in typed.items()}


def _of_arrays(function: Function) -> Function:
    """The function, which raises a TypeError with a sentence if NumPy cannot convert its last argument."""

    @wraps(function)
    def call(*arguments: Any, **named: Any) -> Any:
        try:
            return function(*arguments, **named)
        except MISUSE as error:
            if is_a_sentence(error) or not arguments:
                raise
            raise TypeError(f"an array of numbers is needed, not {show(arguments[-1])}") from None

    return call
