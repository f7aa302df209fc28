"""Small changes to the reference solutions, one at a time: which of them does the check not notice?

    python -m tests.course.mutants [NAME ...]

Prints the number of mutants for each exercise in Python, and each survivor: the line as it is and as it was changed.  A
survivor either does the same as the solution or shows what the check does not ask.  Programs that draw take minutes and
are left out unless they are named.
"""

from __future__ import annotations

import ast
import copy
import signal
import sys
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path

from glsim.course.exercise import Exercise, exercise, exercises
from tests.course.grading import marks_of, solution_of

SECONDS = 5  # for a mutant; one that takes longer is noticed
COMPARISONS: dict[type, tuple[type, ...]] = {
    ast.Lt: (ast.LtE, ast.Gt), ast.LtE: (ast.Lt, ast.GtE), ast.Gt: (ast.GtE, ast.Lt), ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,), ast.NotEq: (ast.Eq,),
}  # fmt: skip
OPERATORS: dict[type, tuple[type, ...]] = {
    ast.Add: (ast.Sub,), ast.Sub: (ast.Add,), ast.Mult: (ast.Div, ast.Add), ast.Div: (ast.Mult, ast.FloorDiv),
    ast.Pow: (ast.Mult,), ast.FloorDiv: (ast.Div,), ast.Mod: (ast.Mult,), ast.MatMult: (ast.Mult,),
    ast.And: (ast.Or,), ast.Or: (ast.And,),
}  # fmt: skip
SYMMETRIC = ("max", "min", "maximum", "minimum", "dot")  # nothing changes if their arguments are swapped
DROPPED = (*SYMMETRIC, "clip", "abs", "sqrt", "floor", "int", "radians", "norm", "sum", "arccos")


def replacements(node: ast.AST) -> Iterator[ast.AST]:
    """What a node may be changed to."""
    if isinstance(node, ast.Compare):
        for k, operator in enumerate(node.ops):
            for other in COMPARISONS.get(type(operator), ()):
                yield ast.Compare(node.left, [*node.ops[:k], other(), *node.ops[k + 1 :]], node.comparators)
    elif isinstance(node, ast.BinOp):
        for other in OPERATORS.get(type(node.op), ()):
            yield ast.BinOp(node.left, other(), node.right)
        yield node.left
        yield node.right
        if isinstance(node.op, (ast.Sub, ast.Div, ast.Pow, ast.MatMult)):
            yield ast.BinOp(node.right, node.op, node.left)
    elif isinstance(node, ast.AugAssign):
        for other in OPERATORS.get(type(node.op), ()):
            yield ast.AugAssign(node.target, other(), node.value)
        yield ast.Assign([node.target], node.value, lineno=node.lineno)
    elif isinstance(node, ast.BoolOp):
        yield ast.BoolOp(OPERATORS[type(node.op)][0](), node.values)
        yield from node.values
    elif isinstance(node, ast.UnaryOp):
        yield node.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
        yield ast.Constant(node.value + 1)
        yield ast.Constant(node.value - 1)
        if node.value not in (0, 1):
            yield ast.Constant(-node.value)
    elif isinstance(node, (ast.If, ast.IfExp)):
        for always in (True, False):
            changed = copy.copy(node)
            changed.test = ast.Constant(always)
            yield changed
    elif isinstance(node, ast.Call) and node.args:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        if name in DROPPED:
            yield node.args[0]
        if len(node.args) > 1 and name not in SYMMETRIC:
            yield ast.Call(node.func, [node.args[1], node.args[0], *node.args[2:]], node.keywords)
        if name == "clip" and len(node.args) == 3:
            yield ast.Call(ast.parse("np.maximum", mode="eval").body, node.args[:2], [])
            yield ast.Call(ast.parse("np.minimum", mode="eval").body, [node.args[0], node.args[2]], [])
    elif isinstance(node, ast.Attribute) and node.attr == "T":
        yield node.value


def mutants(text: str) -> Iterator[tuple[int, str]]:
    """(line, text) for each mutant."""
    tree = ast.parse(text)
    for node in list(ast.walk(tree)):
        for other in replacements(node):
            copied = _Replace(node, other).visit(copy.deepcopy(tree, {id(node): node}))
            yield getattr(node, "lineno", 0), ast.unparse(ast.fix_missing_locations(copied))


class _Replace(ast.NodeTransformer):
    """Puts one node in the place of another."""

    def __init__(self, old: ast.AST, new: ast.AST) -> None:
        self.old, self.new = old, new

    def visit(self, node: ast.AST) -> ast.AST:
        return self.new if node is self.old else self.generic_visit(node)


def _too_slow(*_: object) -> None:
    raise TimeoutError


def survivors(one: Exercise) -> tuple[int, list[tuple[int, str]]]:
    """The number of an exercise's mutants, and those that get all points: (line, text)."""
    alive, count = [], 0
    plain = ast.unparse(ast.parse(solution_of(one)))
    signal.signal(signal.SIGALRM, _too_slow)
    with tempfile.TemporaryDirectory() as folder:
        for line, text in mutants(solution_of(one)):
            if text == plain:
                continue
            count += 1
            signal.alarm(0 if one.definition.program else SECONDS)  # programs are stopped by the check
            try:
                if marks_of(one, text, Path(folder)).first_failure is None:
                    alive.append((line, text))
            finally:
                signal.alarm(0)
    return count, alive


def main(names: list[str]) -> None:
    warnings.simplefilter("ignore")
    total = left = 0
    for one in map(exercise, names) if names else exercises():
        if one.definition.ending != ".py" or (one.definition.program and not names):
            continue
        count, alive = survivors(one)
        total, left = total + count, left + len(alive)
        print(f"{one.name}: {count} mutants, {len(alive)} survive", flush=True)
        plain = ast.unparse(ast.parse(solution_of(one))).splitlines()
        for line, text in alive:
            changed = [pair for pair in zip(plain, text.splitlines(), strict=False) if pair[0] != pair[1]]
            before, after = changed[0] if changed else ("", "")
            print(f"    line {line}: {before.strip()}  ->  {after.strip()}")
    print(f"{total} mutants, {left} survive")


if __name__ == "__main__":
    main(sys.argv[1:])
