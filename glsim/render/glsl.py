"""Reading GLSL: the preprocessor, the printed constants, tokens.  Of GLSL 330 the part that shaders/ is written in."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

TOKEN = re.compile(
    r"(?P<space>(?:\s+|//[^\n]*|/\*.*?\*/)+)|(?P<word>[A-Za-z_]\w*)|(?P<number>\d+\.?\d*(?:[eE][-+]?\d+)?[uf]?|\.\d+)"
    r"|(?P<operator>\+\+|--|<<|>>|<=|>=|==|!=|&&|\|\||[-+*/%&|^]=|[-+*/%<>=!&|^~?:;,.(){}\[\]])",
    re.DOTALL,
)
Value = bool | int


@dataclass
class Token:
    """space: white space and comments in front of it."""

    text: str
    space: str = ""


@dataclass
class Constants:
    """scalars: name -> value; arrays: name -> values."""

    scalars: dict[str, Value] = field(default_factory=dict)
    arrays: dict[str, list[Value]] = field(default_factory=dict)


def preprocessed(source: str, es: bool = False) -> tuple[str, Constants]:
    """The text as the preprocessor leaves it, without the constants in front; and those constants.

    es: for OpenGL ES, where GL_ES is defined."""
    macros: dict[str, str] = {"GL_ES": "1"} if es else {}
    constants = Constants()
    active = [True]
    lines = []
    begun = 0  # where the part of the present file begins
    for line in source.splitlines():
        directive = re.match(r"\s*#\s*(\w+)\s*(.*)", line)
        if directive is None:
            constant = re.match(r"const (?:bool|int)(\[\d+\])? (\w+) = (.*);$", line)
            if constant is not None and active[-1]:
                _note(constants, constant[2], constant[3], bool(constant[1]))
            elif active[-1]:
                lines.append(line)
            continue
        word, rest = directive[1], directive[2].split("//")[0].strip()
        if word == "line":
            if not any(text.split("//")[0].strip() for text in lines[begun:]):
                del lines[begun:]  # nothing but comments is left of it
            begun = len(lines)
        if word in ("ifdef", "ifndef"):
            rest = f"{'!' * (word == 'ifndef')}defined({rest})"
        if word in ("if", "ifdef", "ifndef"):
            active.append(active[-1] and _true(rest, macros))
        elif word == "elif":
            before = active.pop()
            active.append(active[-1] and not before and _true(rest, macros))
        elif word == "else":
            active.append(not active.pop() and active[-1])
        elif word == "endif":
            active.pop()
        elif word == "define" and active[-1]:
            name, _, value = rest.partition(" ")
            macros[name] = value.strip()
    text = re.sub(r"\b[A-Z][A-Z_0-9]*\b", lambda found: macros.get(found[0], found[0]), "\n".join(lines))
    return text, constants


def _note(constants: Constants, name: str, value: str, array: bool) -> None:
    """Keep the value that a ``const`` line gives a constant: "true", "3", or "bool[2](true, false)"."""
    words = re.findall(r"true|false|-?\d+", value.split("(", 1)[1] if array else value)
    values: list[Value] = [word == "true" if word in ("true", "false") else int(word) for word in words]
    if array:
        constants.arrays[name] = values
    else:
        constants.scalars[name] = values[0]


def _true(condition: str, macros: dict[str, str]) -> bool:
    """Whether the condition of an #if holds: one or more of "NAME", "NAME == OTHER", "NAME != OTHER", "defined(NAME)"
    and "!defined(NAME)", joined by &&."""
    return all(_holds(part.strip(), macros) for part in condition.split("&&"))


def _holds(part: str, macros: dict[str, str]) -> bool:
    asked = re.fullmatch(r"(!?)defined\((\w+)\)", part)
    if asked is not None:
        return (asked[2] in macros) != bool(asked[1])
    left, operator, right = re.fullmatch(r"(\w+)\s*(==|!=)?\s*(\w+)?", part).groups()  # type: ignore[union-attr]
    a = int(macros.get(left, left) or 0)
    if operator is None:
        return a != 0
    b = int(macros.get(right, right))
    return (a == b) == (operator == "==")


def tokens_of(text: str) -> list[Token]:
    """Words, numbers and operators, each with the white space and comments in front of it."""
    tokens, space = [], ""
    for match in TOKEN.finditer(text):
        if match.lastgroup == "space":
            space += match[0]
        else:
            tokens.append(Token(match[0], space))
            space = ""
    return tokens


def top_level(tokens: list[Token]) -> list[list[Token]]:
    """The declarations and functions of a text, each with the comment on the line it ends in."""
    pieces: list[list[Token]] = []
    piece: list[Token] = []
    depth = 0
    for k, token in enumerate(tokens):
        piece.append(token)
        depth += (token.text in "{(") - (token.text in "})")
        function = token.text == "}" and not piece[0].text.startswith(("struct", "layout"))
        if depth == 0 and (token.text == ";" or function):
            if k + 1 < len(tokens):
                trailing, rest = _trailing_comment(tokens[k + 1].space)
                tokens[k + 1].space = rest
                piece.append(Token("", trailing))
            pieces.append(piece)
            piece = []
    return pieces


def _trailing_comment(space: str) -> tuple[str, str]:
    """White space and comments: what still stands on the line before, and the rest."""
    line, newline, rest = space.partition("\n")
    return line, newline + rest
