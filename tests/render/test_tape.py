"""A tape holds a picture: it draws the same again, and what is none, or a damaged one, gets a sentence."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import glsim
from glsim.files import data_folder
from glsim.gl import *
from glsim.machine.frame import Frame
from glsim.play.capture import capture
from glsim.render.programs import ES_FRONT
from glsim.render.recorder import record, tape
from glsim.render.replay import replayed
from glsim.render.tape import HEADER, MAGIC, VERSION, Picture, Tape, TapeError
from tests.oracle import PROGRAMS
from tests.oracle.line_programs import LINES
from tests.oracle.pixel_programs import ACCUMULATED

ALL = {**PROGRAMS, **LINES, **ACCUMULATED}
# what is rare on a tape, and of everything else a tenth
SPREAD = dict.fromkeys((
    "copy_pixels", "copy_pixels_zoomed", "copy_depths", "copy_stencils", "copied_from_the_framebuffer", *ACCUMULATED,
    "logic_op_xor", "logic_op_equiv", "blend_constant", "many_calls_of_one_list", "lists_nested_and_resolved_late",
    "many_objects", "cube_map_reflection_map", "volume_repeat", "one_dimensional_texture", "shadow_map", "four_units",
    "depth_texture_compared_lequal", "draw_depths", "draw_stencils", "bitmaps_in_lists", "generated_mipmap",
    "a_texture_that_changes_between_draws", "line_stipple_wide", "clipped_wide_lines", "polygon_stipple", "color_mask",
    *list(ALL)[::10],
))  # fmt: skip


def frame_of(name: str) -> Frame:
    with capture() as frame:
        ALL[name]()
    return frame


def again(of: Tape) -> Tape:
    return Tape.from_bytes(of.to_bytes())


@pytest.mark.parametrize("name", SPREAD)
def test_a_tape_draws_the_same_picture(screen: glsim.Offscreen, name: str) -> None:
    frame = frame_of(name)
    assert np.array_equal(replayed(Tape.from_bytes(tape(frame))), screen.pixels())


def test_with_samples(screen: glsim.Offscreen) -> None:
    frame = frame_of("term_specular_n10")
    with glsim.render.context.own_screen(128, 128, samples=4) as smooth:
        smooth.execute(frame.packets)
        wanted = smooth.pixels()
    assert not np.array_equal(wanted, screen.pixels())
    assert np.array_equal(replayed(Tape.from_bytes(tape(frame, samples=4))), wanted)


def test_pictures_of_a_tape_share_their_data(screen: glsim.Offscreen) -> None:
    frames, pictures = {}, []
    for name in ("cull_back_ccw", "cull_front_ccw", "term_ambient"):
        screen.reset()
        frames[name] = frame_of(name)
        pictures.append(screen.pixels())
    whole = again(record(frames))
    assert [picture.name for picture in whole.pictures] == list(frames)
    for number, picture in enumerate(pictures):
        assert np.array_equal(replayed(whole, number), picture)
    assert len(whole.blobs) == len(set(whole.blobs)) < sum(len(record({"": one}).blobs) for one in frames.values())
    other = Frame(64, 128)
    with pytest.raises(ValueError, match="pictures of one size"):
        record({**frames, "other": other})


@pytest.mark.parametrize("name", ["many_calls_of_one_list", "copy_pixels", "accumulated", "shadow_map"])
def test_the_same_frame_gives_the_same_bytes(screen: glsim.Offscreen, name: str) -> None:
    frame = frame_of(name)
    data = tape(frame)
    assert tape(frame) == data
    assert Tape.from_bytes(data).to_bytes() == data


def test_the_caller_s_context_stays(screen: glsim.Offscreen) -> None:
    frame = frame_of("copy_pixels")
    before = screen.pixels()
    replayed(Tape.from_bytes(tape(frame)))
    assert glIsEnabled(GL_DEPTH_TEST) in (True, False)
    assert np.array_equal(screen.pixels(), before)


# ---------------------------------------------------------------- GLSL of browsers


def test_program_source_for_browsers(screen: glsim.Offscreen) -> None:
    glEnable(GL_CLIP_PLANE0)
    desktop, browser = (glsim.program_source("vertex", es=es) for es in (False, True))
    assert desktop.startswith("#version 330 core\n")
    assert browser.startswith("#version 300 es\nprecision highp float;\n")
    front = "#version 330 core\n"
    assert browser.removeprefix(ES_FRONT) == desktop.removeprefix(front), "one source, with branches for GL_ES"


def test_tapes_hold_programs_for_both(screen: glsim.Offscreen) -> None:
    of = record({"": frame_of("clip_planes")})
    programs = [operation for operation in of.pictures[0].operations if operation[0] == "program"]
    texts = [[of.blobs[blob].decode() for blob in operation[2:]] for operation in programs]
    assert any("gl_ClipDistance" in vertex for vertex, *_ in texts)
    for *_, vertex, fragment in texts:
        assert "gl_ClipDistance" not in vertex + fragment
        assert "#" not in vertex + fragment, "constants are folded: nothing is left for the preprocessor"


def test_the_branches_for_browsers_are_documented() -> None:
    folder = data_folder("shaders")
    told = (folder / "README.md").read_text(encoding="utf-8")
    rows = told.split("## In a browser")[1].split("\n## ")[0]
    for path in folder.iterdir():
        if path.suffix != ".md":
            assert ("GL_ES" in path.read_text(encoding="utf-8")) == (f"`{path.name}`" in rows), path.name


# ---------------------------------------------------------------- what is no tape


@pytest.fixture(scope="module")
def good() -> Tape:
    """With everything a tape can hold: uniform blocks, textures, arrays, draws."""
    with glsim.render.context.own_screen(128, 128):
        return record({"": frame_of("two_units_modulate_decal")})


def forged(of: Tape, **changes: Any) -> bytes:
    data = of.to_bytes()
    length = HEADER.unpack_from(data)[2]
    head = {**json.loads(data[HEADER.size : HEADER.size + length]), **changes}
    text = json.dumps(head).encode()
    return HEADER.pack(MAGIC, VERSION, len(text)) + text + data[HEADER.size + length :]


def test_a_foreign_version(good: Tape) -> None:
    data = good.to_bytes()
    with pytest.raises(TapeError, match="has version 2 of the format, and this glsim reads version 1"):
        Tape.from_bytes(data[:8] + (2).to_bytes(4, "little") + data[12:])
    with pytest.raises(TapeError, match=r"for other shaders: play it with the glsim that made it, glsim \d"):
        Tape.from_bytes(forged(good, bindings={"Transforms": 9}))


@pytest.mark.parametrize("data", [b"", b"glsim", b"\x89PNG\r\n\x1a\n" + bytes(99), b"glsimtap", MAGIC + bytes(99)])
def test_other_files(data: bytes) -> None:
    with pytest.raises(TapeError):
        Tape.from_bytes(data)


@pytest.mark.parametrize(
    "changes",
    [
        {"width": 0}, {"height": 1 << 20}, {"width": "128"}, {"width": 1e3}, {"width": float("inf")}, {"samples": 3},
        {"samples": -4}, {"samples": True}, {"blobs": [["00", 4]]}, {"blobs": []}, {"blobs": [[1, -4]]}, {"blobs": 7},
        {"pictures": {}}, {"pictures": [{}]}, {"pictures": [{"name": "", "operations": "draw"}]},
        {"pictures": [{"name": "", "operations": [[]]}]}, {"pictures": [{"name": "", "operations": [[1]]}]},
        {"pictures": [{"name": "", "operations": {"draw": 1}}]},
    ],
    ids=str,
)  # fmt: skip
def test_forged_heads(good: Tape, changes: dict[str, Any]) -> None:
    data = forged(good, **changes)
    if changes == {"pictures": {}}:
        with pytest.raises(TapeError, match="no picture 0: it holds 0, numbered from 0"):
            replayed(Tape.from_bytes(data))
        return
    with pytest.raises(TapeError, match=r"^this tape is damaged: "):
        Tape.from_bytes(data)


def works_or_says_why(work: Callable[[], object]) -> None:
    said = ""
    try:
        work()
    except TapeError as error:
        said = str(error)
    assert "\n" not in said
    assert len(said) < 400


@given(st.data())
@settings(max_examples=40)
def test_damaged_bytes(good: Tape, data: st.DataObject) -> None:
    """Cut off anywhere, or with another byte anywhere."""
    whole = good.to_bytes()
    with pytest.raises(TapeError):
        Tape.from_bytes(whole[: data.draw(st.integers(0, len(whole) - 1))])
    changed = bytearray(whole)
    for _ in range(data.draw(st.integers(1, 3))):
        changed[data.draw(st.integers(0, len(whole) - 1))] = data.draw(st.integers(0, 255))
    works_or_says_why(lambda: Tape.from_bytes(bytes(changed)))


# ---------------------------------------------------------------- operations that a driver must not see

HUGE = 1 << 40


def change(good: Tape, name: str, argument: int, value: Any) -> Tape:
    """The tape with another argument of the last operation of this name."""
    changed = Tape(good.width, good.height, 0, copy.deepcopy(good.pictures), good.blobs)
    operation = [one for one in changed.pictures[0].operations if one[0] == name][-1]
    operation[argument] = value
    return changed


@pytest.mark.parametrize(
    ("name", "argument", "value"),
    [
        ("buffer", 2, HUGE), ("buffer", 2, -1), ("buffer", 2, 1.5), ("buffer", 2, 4), ("buffer", 2, None),
        ("write", 1, 999), ("write", 2, 999), ("write", 2, -1), ("uniform", 1, 999), ("uniform", 3, HUGE),
        ("uniform", 4, HUGE), ("uniform", 4, 16), ("uniform", 3, 8), ("program", 2, 10**9), ("program", 2, 0),
        ("array", 2, 999), ("array", 4, 999), ("array", 3, []), ("array", 3, [[1, 4]]), ("draw", 1, 999),
        ("draw", 2, 7), ("draw", 2, 14), ("draw", 3, 6000), ("draw", 3, -1), ("draw", 4, HUGE), ("draw", 4, -6),
        ("draw", 5, HUGE), ("draw", 5, 0), ("texture", 1, 99), ("texture", 2, 3), ("image", 1, 3), ("image", 2, -1),
        ("image", 2, 99), ("image", 3, 3), ("image", 4, [4096, 4096]), ("image", 4, [-4, -4]), ("image", 4, [HUGE, 1]),
        ("image", 4, []), ("image", 5, 3), ("image", 6, 5122), ("image", 7, 999), ("glDepthFunc", 1, 3),
        ("glEnable", 1, 3), ("glEnable", 1, "x"), ("glViewport", 3, -5), ("glTexParameterfv", 3, [0.0] * 5),
        ("glTexParameteri", 3, 3), ("glClear", 1, 1), ("glCullFace", 0, "glReadPixels"), ("glCullFace", 0, "glFinish"),
        ("glCullFace", 0, "glGenTextures"), ("glCullFace", 0, "__init__"), ("glCullFace", 0, "glDeleteTextures"),
        ("glScissor", 0, "glTexImage2D"), ("glScissor", 0, "glReadPixels"), ("glCullFace", 0, "glDepthRange"),
    ],
)  # fmt: skip
def test_nonsense_is_refused(good: Tape, name: str, argument: int, value: Any) -> None:
    with pytest.raises(TapeError, match=r"^operation \d+ of the tape cannot be played: \[") as caught:
        replayed(change(good, name, argument, value))
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 400


def test_indices_beyond_the_vertices(good: Tape) -> None:
    array = next(one for one in good.pictures[0].operations if one[0] == "array")
    write = next(one for one in good.pictures[0].operations if one[0] == "write" and one[1] == array[4])
    changed = Tape(128, 128, 0, good.pictures, list(good.blobs))
    changed.blobs[write[2]] = np.full(len(good.blobs[write[2]]) // 4, 1 << 31, np.uint32).tobytes()
    with pytest.raises(TapeError, match="has less vertices"):
        replayed(changed)


def test_a_shader_that_does_not_compile(good: Tape) -> None:
    program = next(one for one in good.pictures[0].operations if one[0] == "program")
    for text in (b"no GLSL", b"void main() { gl_Position = ; }", b"\xff\xfe", b"#extension all : enable"):
        changed = Tape(128, 128, 0, good.pictures, list(good.blobs))
        changed.blobs[program[2]] = text
        with pytest.raises(TapeError, match="cannot be played"):
            replayed(changed)


NUMBERS = st.one_of(
    st.integers(-2, 40), st.integers(0x0100, 0x9300), st.integers(-(1 << 66), 1 << 66), st.floats(), st.none(),
    st.text(max_size=3), st.lists(st.integers(-1, 300), max_size=4),
)  # fmt: skip


@pytest.mark.slow
@given(st.data())
@settings(max_examples=80)
def test_any_operations(good: Tape, data: st.DataObject) -> None:
    """Some arguments, names or places of operations are others: a picture or a TapeError comes, and Python lives on."""
    operations = copy.deepcopy(good.pictures[0].operations)
    for _ in range(data.draw(st.integers(1, 4))):
        at = data.draw(st.integers(0, len(operations) - 1))
        match data.draw(st.sampled_from(["argument", "deep", "name", "drop", "swap"])):
            case "argument":
                operations[at][data.draw(st.integers(0, len(operations[at]) - 1))] = data.draw(NUMBERS)
            case "deep":
                lists = [one for one in operations[at] if isinstance(one, list) and one]
                if lists:
                    inner = lists[0][0] if isinstance(lists[0][0], list) else lists[0]
                    inner[data.draw(st.integers(0, len(inner) - 1))] = data.draw(NUMBERS)
            case "name":
                operations[at][0] = operations[data.draw(st.integers(0, len(operations) - 1))][0]
            case "drop":
                del operations[at]
            case "swap":
                other = data.draw(st.integers(0, len(operations) - 1))
                operations[at], operations[other] = operations[other], operations[at]
    changed = Tape(good.width, good.height, 0, [Picture("", operations)], good.blobs)
    works_or_says_why(lambda: replayed(changed))
