"""Folding constants in GLSL: an expression whose value is known becomes that value, an if becomes the branch it takes.

if (LIGHTING && PER_FRAGMENT) { a(); } else { b(); }      with LIGHTING = true, PER_FRAGMENT = false      b();
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from glsim.render.glsl import Constants, Token, Value

PRECEDENCE = [
    ("||",), ("&&",), ("|",), ("^",), ("&",), ("==", "!="), ("<", ">", "<=", ">="), ("<<", ">>"), ("+", "-"),
    ("*", "/", "%"),
]  # fmt: skip
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "|=", "&=", "^="}
FOLDS: dict[str, Callable[[Value, Value], Value]] = {
    "||": lambda a, b: bool(a or b), "&&": lambda a, b: bool(a and b), "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b, "<": lambda a, b: a < b, ">": lambda a, b: a > b, "<=": lambda a, b: a <= b,
    ">=": lambda a, b: a >= b, "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b,
}  # fmt: skip


@dataclass
class Expression:
    """Its tokens, and its value if it is constant."""

    tokens: list[Token]
    value: Value | None = None


class Folder:
    """Reads one function or declaration and writes it folded."""

    def __init__(self, constants: Constants, tokens: list[Token]) -> None:
        self.constants, self.tokens, self.position = constants, tokens, 0

    def peek(self, ahead: int = 0) -> str:
        return self.tokens[self.position + ahead].text if self.position + ahead < len(self.tokens) else ""

    def take(self, expected: str = "") -> Token:
        token = self.tokens[self.position]
        if expected and token.text != expected:
            raise ValueError(f"{expected} was expected, not {token.text}")
        self.position += 1
        return token

    def piece(self) -> list[Token]:
        if any(token.text == "{" for token in self.tokens) and self.tokens[0].text not in ("struct", "layout"):
            known = dict(self.constants.scalars)
            result = []
            while self.peek() != "{":
                result.append(self.take())
            result += self.block() + self.tokens[self.position :]
            self.constants.scalars = known
            return result
        return [self._literal(token) for token in self.tokens]

    def _literal(self, token: Token) -> Token:
        value = self.constants.scalars.get(token.text)
        return Token(value_text(value), token.space) if value is not None else token

    # ---- statements

    def block(self) -> list[Token]:
        """{ ... }, without what comes after a return."""
        opening = self.take("{")
        result: list[Token] = []
        ended = False
        while self.peek() != "}":
            statement = self.statement()
            if not ended:
                result += statement
            words = [token.text for token in statement if token.text]
            ended = ended or (bool(words) and words[0] in ("return", "discard"))
        closing = self.take("}")
        if ended:  # comments in front of the brace belong to what is gone
            closing = Token("}", "\n" + closing.space.rpartition("\n")[2])
        if [token.text for token in result[-2:]] == ["return", ";"]:
            result = result[:-2]
        return [opening, *result, closing]

    def statement(self) -> list[Token]:
        word = self.peek()
        if word == "{":
            return self.block()
        if word == "if":
            return self._if()
        if word == "for":
            return self._for()
        if word == "return" and self.peek(1) != ";":
            start = self.take()
            return [start, *self.expression().tokens, self.take(";")]
        if word in ("return", "discard", "break", "continue"):
            return [self.take(), self.take(";")]
        return self._simple()

    def _simple(self) -> list[Token]:
        """A declaration or an expression, up to its semicolon.  A bool that is declared with a constant stays that."""
        result: list[Token] = []
        name = self.peek(1)
        if self.peek() == "bool" and self.peek(2) == "=":
            self.position += 3
            value = self.expression().value
            if value is not None and self.peek() == ";":
                self.take()
                self.constants.scalars[name] = value
                return []
            self.position = next(k for k in range(self.position, -1, -1) if self.tokens[k].text == "bool")
        while self.peek() != ";":
            result += self.expression().tokens
            while self.peek() not in (";", "") and not self._begins_expression():
                result.append(self.take())
        return [*result, self.take(";")]

    def _begins_expression(self) -> bool:
        return bool(re.match(r"[A-Za-z_0-9.(!~+-]", self.peek()))

    def _if(self) -> list[Token]:
        start, opening = self.take("if"), self.take("(")
        condition = self.expression()
        closing = self.take(")")
        body = self.statement()
        other: list[Token] | None = None
        word = Token("else")
        if self.peek() == "else":
            word = self.take()
            other = self.statement()
        if condition.value is None:
            if not _words(body) and other is None:
                return []
            body = body if _words(body) else [Token("{", " "), Token("}", " ")]
            tail = [word, *other] if other is not None and _words(other) else []
            return [start, opening, *condition.tokens, closing, *body, *tail]
        chosen = body if condition.value else other
        piece = _unwrapped(chosen, start.space) if chosen is not None else []
        if not piece and self.position < len(self.tokens):  # a comment behind it goes with it
            following = self.tokens[self.position]
            before, newline, _ = start.space.partition("\n")  # what stands behind the statement before stays
            following.space = following.space[following.space.find("\n") :] if "\n" in following.space else ""
            following.space = (before if newline else "") + following.space
        return piece

    def _for(self) -> list[Token]:
        start = [self.take("for"), self.take("(")]
        first = self._simple()
        condition = self.expression()
        end = self.take(";")
        step = self.expression()
        closing = self.take(")")
        body = self.statement()
        begins_at_0 = [token.text for token in first][-3:-1] == ["=", "0"]
        limit = condition.tokens[-1].text
        if not _words(body) or (begins_at_0 and condition.tokens[-2].text == "<" and limit == "0"):
            return []
        return [*start, *first, *condition.tokens, end, *step.tokens, closing, *body]

    # ---- expressions

    def expression(self) -> Expression:
        left = self._ternary()
        while self.peek() in ASSIGNMENTS:
            operator = self.take()
            left = Expression([*left.tokens, operator, *self.expression().tokens])
        return left

    def _ternary(self) -> Expression:
        condition = self._binary(0)
        if self.peek() != "?":
            return condition
        question = self.take()
        yes = self.expression()
        colon = self.take(":")
        no = self.expression()
        if condition.value is None:
            return Expression([*condition.tokens, question, *yes.tokens, colon, *no.tokens])
        chosen = yes if condition.value else no
        chosen.tokens[0] = Token(chosen.tokens[0].text, condition.tokens[0].space)
        return chosen

    def _binary(self, level: int) -> Expression:
        if level == len(PRECEDENCE):
            return self._unary()
        left = self._binary(level + 1)
        while self.peek() in PRECEDENCE[level]:
            operator = self.take()
            left = _combined(operator, left, self._binary(level + 1))
        return left

    def _unary(self) -> Expression:
        if self.peek() in ("!", "-", "+", "~", "++", "--"):
            operator = self.take()
            operand = self._unary()
            if operator.text == "!" and operand.value is not None:
                return _constant(not operand.value, operator.space)
            return Expression([operator, *operand.tokens])
        return self._postfix()

    def _postfix(self) -> Expression:
        result = self._primary()
        while self.peek() in ("[", "(", ".", "++", "--"):
            word = self.take()
            if word.text in ("[", "("):
                inner: list[Token] = []
                index: Expression | None = None
                while self.peek() not in ("]", ")"):
                    index = self.expression()
                    inner += index.tokens
                    if self.peek() == ",":
                        inner.append(self.take())
                closing = self.take()
                known = self._element(result, index) if word.text == "[" else None
                if known is not None:
                    result = _constant(known, result.tokens[0].space)
                else:
                    result = Expression([*result.tokens, word, *inner, closing])
            elif word.text == ".":
                result = Expression([*result.tokens, word, self.take()])
            else:
                result = Expression([*result.tokens, word])
        return result

    def _element(self, array: Expression, index: Expression | None) -> Value | None:
        """An element of a constant array, if the index is known or all elements agree."""
        values = self.constants.arrays.get(array.tokens[-1].text) if len(array.tokens) == 1 else None
        if values is None or index is None:
            return None
        if index.value is not None:
            return values[int(index.value)]
        return values[0] if len(set(values)) == 1 else None

    def _primary(self) -> Expression:
        if self.peek() == "(":
            opening = self.take()
            inner = self.expression()
            closing = self.take(")")
            if inner.value is not None:
                return _constant(inner.value, opening.space)
            return Expression([opening, *inner.tokens, closing])
        token = self.take()
        value: Value | None = self.constants.scalars.get(token.text)
        if token.text in ("true", "false"):
            value = token.text == "true"
        elif re.fullmatch(r"\d+", token.text):
            value = int(token.text)
        return _constant(value, token.space) if value is not None else Expression([token])


def value_text(value: Value) -> str:
    """A constant as GLSL writes it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def _constant(value: Value, space: str) -> Expression:
    return Expression([Token(value_text(value), space)], value)


def _combined(operator: Token, left: Expression, right: Expression) -> Expression:
    """left operator right, folded as far as it goes."""
    space = left.tokens[0].space
    if left.value is not None and right.value is not None and operator.text in FOLDS:
        return _constant(FOLDS[operator.text](left.value, right.value), space)
    if operator.text in ("&&", "||"):
        neutral = operator.text == "&&"
        for known, other in ((left, right), (right, left)):
            if known.value is not None and bool(known.value) == neutral:
                other.tokens[0] = Token(other.tokens[0].text, space)
                return other
            if known.value is not None:
                return _constant(known.value, space)
    return Expression([*left.tokens, operator, *right.tokens])


def _words(tokens: list[Token]) -> list[str]:
    return [token.text for token in tokens if token.text not in ("", "{", "}")]


def _unwrapped(body: list[Token], space: str) -> list[Token]:
    """What an if that is always taken leaves: a block's content moves out."""
    if not _words(body):
        return []
    if body[0].text != "{":
        return [Token(body[0].text, space), *body[1:]]
    return [Token(token.text, token.space.replace("\n    ", "\n")) for token in body[1:-1]]
