"""Who may import whom: no circle of files, no arrow up, and rooms that never draw with a GPU's library.

Imports under TYPE_CHECKING are for annotations only and do not count.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest

import glsim

GLSIM = Path(glsim.__file__).parent

# A room is a folder of glsim, or a file beside the folders.  An arrow goes from who imports to who is imported.
GROUND = {"glsim", "files", "images", "metrics", "names", "pictures", "version"}  # who may be imported by all
ARROWS = {
    "__main__": {"cli"},
    "cli": {"course", "machine", "play", "radiosity", "render", "scenes", "study", "testing", "web"},
    "lab": {"course", "study", "play", "web"},
    "course": {"testing", "study", "web", "radiosity", "play", "scenes", "render", "gl", "machine", "shading"},
    "testing": {"web", "play", "render", "machine"},
    "study": {"web", "radiosity", "play", "scenes", "glu", "render", "gl", "machine", "shading"},
    "radiosity": {"play", "scenes", "render", "glu", "gl", "machine"},
    "web": {"render", "machine"},
    "play": {"scenes", "glut", "glu", "render", "gl", "machine"},
    "scenes": {"gl", "render", "machine"},
    "glut": {"gl", "render", "machine"},
    "glu": {"gl", "render", "machine"},
    "gl": {"machine"},
    "render": {"machine"},
    "machine": {"shading"},
    "shading": set(),
    **{name: set() for name in GROUND},
}
WITHOUT_GPU = ("gl", "machine", "shading", "web")


def module_of(path: Path) -> str:
    parts = ("glsim", *path.relative_to(GLSIM).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


FILES = {module_of(path): path for path in sorted(GLSIM.rglob("*.py"))}


def room_of(module: str) -> str:
    """The folder or file right below glsim; ``glsim`` for glsim/__init__.py itself."""
    return module.split(".")[1] if "." in module else "glsim"


def statements(nodes: Iterable[ast.AST]) -> Iterator[ast.Import | ast.ImportFrom]:
    """Import statements anywhere in a file, within functions too; not those under TYPE_CHECKING."""
    for node in nodes:
        if isinstance(node, ast.Import | ast.ImportFrom):
            yield node
        elif isinstance(node, ast.If) and getattr(node.test, "id", getattr(node.test, "attr", "")) == "TYPE_CHECKING":
            yield from statements(node.orelse)
        elif not isinstance(node, ast.expr):
            yield from statements(ast.iter_child_nodes(node))


@cache
def imported(module: str) -> frozenset[str]:
    """Names of all modules that a file of glsim imports: ``from a import b`` is a.b where that is a file."""
    package = module if FILES[module].name == "__init__.py" else module.rpartition(".")[0]
    found = set()
    for node in statements([ast.parse(FILES[module].read_text(encoding="utf-8"))]):
        if isinstance(node, ast.Import):
            found |= {name.name for name in node.names}
            continue
        base = node.module or ""
        if node.level:
            above = package.split(".")[: len(package.split(".")) - node.level + 1]
            base = ".".join([*above, *filter(None, [base])])
        for name in node.names:
            found.add(f"{base}.{name.name}" if f"{base}.{name.name}" in FILES else base)
    return frozenset(found - {module})


def circles(edges: dict[str, set[str]]) -> set[frozenset[str]]:
    """Groups of more than one file in which each can be reached from each other (by Tarjan's algorithm)."""
    number: dict[str, int] = {}
    lowest: dict[str, int] = {}
    stack: list[str] = []
    found: set[frozenset[str]] = set()

    def visit(file: str) -> None:
        number[file] = lowest[file] = len(number)
        stack.append(file)
        for other in edges[file]:
            if other not in number:
                visit(other)
            if other in stack:
                lowest[file] = min(lowest[file], lowest[other])
        if lowest[file] == number[file]:
            at = stack.index(file)
            if len(stack) - at > 1:
                found.add(frozenset(stack[at:]))
            del stack[at:]

    for file in edges:
        if file not in number:
            visit(file)
    return found


def test_no_circle_of_files() -> None:
    found = circles({file: set(imported(file) & FILES.keys()) for file in FILES})
    assert not found, "files that import each other: " + "; ".join(" <-> ".join(sorted(circle)) for circle in found)


@pytest.mark.parametrize("room", sorted({room_of(file) for file in FILES}))
def test_a_room_imports_only_what_lies_below_it(room: str) -> None:
    assert room in ARROWS, f"{room} is a new room: say in ARROWS whom it may import"
    wrong = [
        f"{file} -> {other}"
        for file in FILES
        for other in sorted(imported(file) & FILES.keys())
        if room_of(file) == room and room_of(other) not in {room, *GROUND, *ARROWS[room]}
    ]
    assert not wrong, "arrows up: " + "; ".join(wrong)


def test_the_table_has_no_circle_of_rooms() -> None:
    rooms = {room: below & ARROWS.keys() for room, below in ARROWS.items()}
    assert circles(rooms) == set()
    assert not {"study", "course"} & ARROWS["testing"]


@pytest.mark.parametrize("room", WITHOUT_GPU)
def test_no_moderngl_where_no_gpu_is_needed(room: str) -> None:
    """Neither in a file of the room nor in any file that it imports."""
    reached = waiting = {file for file in FILES if room_of(file) == room}
    while waiting:
        waiting = {other for file in waiting for other in imported(file) if other in FILES} - reached
        reached = reached | waiting
    assert not [file for file in reached if any(name.split(".")[0] == "moderngl" for name in imported(file))]


def test_circles_and_imports_are_found() -> None:
    """The checks can fail."""
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": set()}) == {frozenset("abc")}
    assert circles({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == set()
    assert "glsim.machine.matrix" in imported("glsim.machine.archive")
    assert any("moderngl" in imported(file) for file in FILES if room_of(file) == "render")
    text = "if TYPE_CHECKING:\n    import a\nelse:\n    import b\ndef f():\n    from c import d\n"
    assert [ast.unparse(node) for node in statements([ast.parse(text)])] == ["import b", "from c import d"]
