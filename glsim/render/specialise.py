"""The GLSL of one program with its constants folded: no branch that cannot be taken, no name that is not used.

A compiler does this to every program; here it is done to the text, so that a student reads only what runs.  The
language is the part of GLSL 330 that shaders/ is written in.
"""

from __future__ import annotations

import re
from functools import lru_cache

from glsim.render.fold import Folder, value_text
from glsim.render.glsl import Constants, Token, Value, preprocessed, tokens_of, top_level
from glsim.render.programs import ES_FRONT, FRONT


def specialised(source: str) -> str:
    """The source (programs.sources) after preprocessing, folding and dropping what is not used."""
    front, text = split(source)
    return front + specialised_body(text, front == ES_FRONT)


def split(source: str) -> tuple[str, str]:
    """The lines in front (FRONT or ES_FRONT), and the text behind them."""
    front = ES_FRONT if source.startswith(ES_FRONT) else FRONT
    return front, source.removeprefix(front)


@lru_cache(maxsize=256)
def specialised_body(body: str, es: bool = False) -> str:
    """The text behind the lines in front, specialised.  es: for OpenGL ES."""
    text, constants = preprocessed(body, es)
    pieces = top_level(tokens_of(text))
    folded = [Folder(constants, piece).piece() for piece in pieces]
    chosen = used([piece for piece in folded if piece], constants)
    body = "".join(token.space + token.text for piece in chosen for token in piece)
    body = re.sub(r"[ \t]+\n", "\n", body)
    body = re.sub(r"(\);)(// )", r"\1\n\n\2", body)
    return re.sub(r"\n{3,}", "\n\n", body).strip() + "\n"


KEYWORDS = {
    "void", "bool", "int", "uint", "float", "vec2", "vec3", "vec4", "ivec2", "ivec3", "ivec4", "bvec4", "uvec4",
    "mat3", "mat4", "in", "out", "inout", "const", "flat", "smooth", "noperspective", "uniform", "layout",
    "struct", "std140", "location",
}  # fmt: skip


def used(pieces: list[list[Token]], constants: Constants) -> list[list[Token]]:
    """Without functions, variables and structures that main does not need; the constant arrays it needs in front."""
    arrays = [_array(name, values) for name, values in constants.arrays.items()]
    pieces = arrays + pieces
    names = [_declares(piece) for piece in pieces]
    words = [{token.text for token in piece if re.match(r"[A-Za-z_]", token.text)} for piece in pieces]
    needed = {"main"}
    chosen: set[int] = set()
    growing = True
    while growing:
        growing = False
        for k, declared in enumerate(names):
            if k not in chosen and declared & needed:
                chosen.add(k)
                needed |= words[k] - KEYWORDS
                growing = True
    return [piece for k, piece in enumerate(pieces) if k in chosen]


def _array(name: str, values: list[Value]) -> list[Token]:
    size = f"{'bool' if isinstance(values[0], bool) else 'int'}[{len(values)}]"
    return tokens_of(f"\nconst {size} {name} = {size}({', '.join(map(value_text, values))});")


def _declares(piece: list[Token]) -> set[str]:
    """The names that a top-level piece makes known."""
    words = [token.text for token in piece]
    if words[0] == "layout" and "{" not in words:
        words = words[words.index(")") + 1 :]
    if words[0] == "struct":
        return {words[1]}
    if "{" in words and words[0] == "layout":  # a uniform block: its members
        inner = words[words.index("{") + 1 :]
        return set(re.findall(r"(\w+)(?: \[ \w+ \])? ;", " ".join(inner)))
    head = words[: words.index("=")] if "=" in words and "{" not in words else words
    head = head[: head.index("(")] if "(" in head else head
    text = re.sub(r"\[ \w* \]", "", " ".join(head))
    names = [word for word in re.findall(r"[A-Za-z_]\w*", text) if word not in KEYWORDS]
    return set(names[-1:])
