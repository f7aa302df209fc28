"""A Frame as a file: what comes back draws the same picture, and a file that was tampered with is refused."""

from __future__ import annotations

import contextlib
import json
import os
import pickle
import random
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.machine import archive
from glsim.machine.constants import Enum
from glsim.machine.frame import Call, Frame
from tests.drawing import captured, portions
from tests.oracle import PROGRAMS

CHECKER = np.random.default_rng(0).integers(0, 256, (8, 8, 3), np.uint8)


def textured() -> None:
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, CHECKER)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
    glEnable(GL_TEXTURE_2D)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glBegin(GL_TRIANGLES)
    for x, y in ((-0.9, -0.9), (0.9, -0.9), (0, 0.9)):
        glMaterialfv(GL_FRONT, GL_DIFFUSE, [abs(x), 0.5, 0.5, 1])
        glTexCoord2f(x, y)
        glVertex2f(x, y)
    glEnd()


@pytest.mark.parametrize("portion", portions(80))
def test_every_program_comes_back_whole(portion: int, screen: glsim.Offscreen, tmp_path: Path) -> None:
    for name in list(PROGRAMS)[portion::80]:
        screen.reset()
        frame = captured(PROGRAMS[name])
        before = screen.pixels()
        archive.save(frame, tmp_path / "frame.npz")
        back = archive.load(tmp_path / "frame.npz")
        screen.reset()
        screen.execute(back.packets)
        assert (screen.pixels() == before).all(), name
        assert [call.name for call in back.calls] == [call.name for call in frame.calls]
        assert [call.where for call in back.calls] == [call.where for call in frame.calls]
        assert len(back.history) == len(frame.history)


def test_what_is_shared_stays_shared(screen: glsim.Offscreen, tmp_path: Path) -> None:
    frame = captured(lambda: [glRectf(-1, -1, 0, 0), glRectf(0, 0, 1, 1)])
    archive.save(frame, tmp_path / "frame.npz")
    first, second = archive.load(tmp_path / "frame.npz").draws
    assert first.state is second.state
    assert first.block is second.block
    assert first.matrices[0] is second.matrices[0]


def test_arguments_of_calls_come_back(tmp_path: Path) -> None:
    arguments = (
        1, 2.0, True, None, "text", b"\x00\xff", (1, (2.5, "x")), [1.0], float("inf"), Enum("GL_LIGHT0", 16384),
        np.arange(6, dtype=np.int16).reshape(2, 3), np.float32(0.5), np.int64(7),
    )  # fmt: skip
    frame = Frame(4, 4, calls=[Call("glFoo", arguments)])
    archive.save(frame, tmp_path / "frame.npz")
    (call,) = archive.load(tmp_path / "frame.npz").calls
    assert call.arguments[:9] == arguments[:9]
    assert [type(a) for a in call.arguments[:10]] == [type(a) for a in arguments[:10]]
    assert call.arguments[9].name == "GL_LIGHT0"
    assert call.arguments[10].dtype == np.int16
    assert (call.arguments[10] == arguments[10]).all()
    assert call.arguments[11:] == (0.5, 7)


# ---------------------------------------------------------------- files of somebody who wants harm


class Payload:
    def __reduce__(self) -> Any:
        return os.mkdir, ("executed",)


def test_a_pickle_is_not_executed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("plain").write_bytes(pickle.dumps(Payload()))
    np.savez("inside.npz", document=np.array([Payload()], object), bytes=np.zeros(1, np.uint8))
    for name in ("plain", "inside.npz"):
        with pytest.raises(ValueError, match="is no Frame that glsim wrote"):
            archive.load(name)
    assert not Path("executed").exists()


def test_only_regular_files_are_read(tmp_path: Path) -> None:
    archive.save(Frame(4, 4), tmp_path / "frame.npz")
    (tmp_path / "link").symlink_to(tmp_path / "frame.npz")
    os.mkfifo(tmp_path / "fifo")
    for name, kind in (("link", OSError), ("fifo", ValueError), (".", OSError), ("none", FileNotFoundError)):
        with pytest.raises(kind):
            archive.load(tmp_path / name)


def rewritten(path: Path, change: Any, **entries: Any) -> None:
    with np.load(path) as old:
        document = json.loads(old["document"].tobytes())
        memory = old["bytes"]
    change(document["nodes"])
    text = np.frombuffer(json.dumps(document).encode(), np.uint8)
    np.savez(path, **{"document": text, "bytes": memory, **entries})


def set_item(kind: str, index: int, value: Any) -> Any:
    def change(nodes: list[Any]) -> None:
        next(node for node in nodes if node[0] == kind)[index] = value

    return change


FORGED = {
    "vertices that are not there": set_item("Draw", 3, 1_000_000),
    "a negative first vertex": set_item("Draw", 2, -1),
    "no primitive": set_item("Draw", 1, 99),
    "an unknown kind": set_item("Draw", 0, "os.system"),
    "a node that comes later": set_item("Frame", 3, [10**6]),
    "a node before the first": set_item("Frame", 3, [-1]),
    "an array outside of the file": set_item("array", 3, 10**9),
    "an array of objects": set_item("array", 1, "|O"),
    "an array of another shape": set_item("array", 2, [1, 1]),
    "a picture without pixels": set_item("Frame", 1, 0),
    "a picture of gigabytes": set_item("Frame", 2, 10**9),
    "a text for a number": set_item("Light", 6, "wide"),
    "seven lights": lambda nodes: next(n for n in nodes if n[0] == "tuple" and len(n) == 9).pop(),
    "an unknown format": set_item("Image", 2, 5),
    "no nodes": lambda nodes: nodes.clear(),
    "no Frame": lambda nodes: nodes.pop(),
}


@pytest.mark.parametrize("what", FORGED)
def test_a_forged_frame_is_refused(what: str, screen: glsim.Offscreen, tmp_path: Path) -> None:
    archive.save(captured(textured), tmp_path / "frame.npz")
    archive.load(tmp_path / "frame.npz")
    rewritten(tmp_path / "frame.npz", FORGED[what])
    with pytest.raises(ValueError, match=r"frame\.npz is no Frame that glsim wrote: "):
        archive.load(tmp_path / "frame.npz")


@pytest.mark.slow
def test_random_damage_is_a_sentence_or_harmless(screen: glsim.Offscreen, tmp_path: Path) -> None:
    """Whatever single item is replaced: load raises ValueError, or drawing it is an exception at worst."""
    archive.save(captured(textured), tmp_path / "frame.npz")
    whole = (tmp_path / "frame.npz").read_bytes()
    chance = random.Random(1)
    refused = 0
    for _ in range(150):
        (tmp_path / "frame.npz").write_bytes(whole)

        def change(nodes: list[Any]) -> None:
            node = chance.choice([n for n in nodes if len(n) > 1])
            node[chance.randrange(len(node))] = chance.choice([0, -1, 2**40, 0.5, None, True, "x", [0], [5], [[]], {}])

        rewritten(tmp_path / "frame.npz", change)
        try:
            frame = archive.load(tmp_path / "frame.npz")
        except ValueError:
            refused += 1
        else:
            screen.reset()
            with contextlib.suppress(Exception):
                screen.execute(frame.packets)
    assert refused > 100


@pytest.mark.slow
def test_a_zip_bomb_is_not_unpacked(tmp_path: Path) -> None:
    np.savez_compressed(tmp_path / "frame.npz", document=np.zeros(10**8, np.uint8), bytes=np.zeros(1, np.uint8))
    with pytest.raises(ValueError, match="not compressed"):
        archive.load(tmp_path / "frame.npz")
