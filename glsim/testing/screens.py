"""Clean contexts for tests, and the probe that tells how a renderer computes."""

from __future__ import annotations

from functools import cache
from hashlib import sha256
from pathlib import Path

from glsim.images import Pixels, rgba
from glsim.render.context import Offscreen, offscreen, own_screen
from glsim.testing.rule import counts

PROBE = Path(__file__).with_name("probe.png")  # drawn by llvmpipe, Mesa 22.3.6


class Screens:
    """Contexts that are opened once and cleaned for each test, because opening one takes longer than most tests."""

    def __init__(self) -> None:
        self.opened: dict[tuple[str, int], Offscreen] = {}

    def clean(self, purpose: str, width: int, height: int, samples: int = 0) -> Offscreen:
        """A context with all state as in a new one.  Raises NoDeviceError, ValueError as ``glsim.offscreen`` does.

        purpose: a word; contexts for two purposes can be in use at the same time."""
        screen = self.opened.get((purpose, samples))
        try:
            if screen is not None:
                screen.check()
        except RuntimeError:  # the test released it
            screen = None
        if screen is None:
            screen = self.opened[purpose, samples] = offscreen(width, height, samples=samples)
        elif (screen.width, screen.height) != (width, height):
            screen.resize(width, height)
        screen.double_buffered, screen.depth_bits, screen.stencil_bits = False, 24, 8
        screen.reset()
        return screen

    def release(self) -> None:
        for screen in self.opened.values():
            screen.release()
        self.opened.clear()


def opaque(screen: Offscreen) -> Pixels:
    """The picture as a window shows it: (height, width, 4) uint8 with alpha 255, top row first."""
    pixels = screen.pixels().copy()
    pixels[..., 3] = 255
    return pixels


def leaks(screen: Offscreen) -> str:
    """What a test began and did not end, or made and did not delete, as a sentence; "" if there is nothing."""
    objects, machine = screen.machine.objects, screen.machine
    if machine.inside is not None:
        return (
            f"The test leaves glBegin({machine.inside!r}) open: what it drew is never seen, because glEnd is missing."
        )
    if machine.compiling is not None:
        return f"The test leaves glNewList({machine.compiling.number}, ...) open: glEndList is missing."
    held = {
        "textures": (objects.texture_names | {name for name, _ in objects.textures if name}, "glDeleteTextures"),
        "buffer objects": (set(objects.buffers), "glDeleteBuffers"),
        "queries": (set(objects.queries), "glDeleteQueries"),
        "display lists": (set(objects.lists), "glDeleteLists"),
    }
    parts = [f"{_counted(kind, names)}, see {call}" for kind, (names, call) in held.items() if names]
    return f"The test leaves GL objects behind: {'; '.join(parts)}." if parts else ""


def _counted(kind: str, names: set[int]) -> str:
    shown = ", ".join(map(str, sorted(names)[:8])) + (", ..." if len(names) > 8 else "")
    return f"{len(names)} {kind if len(names) > 1 else kind.removesuffix('s').replace('querie', 'query')} ({shown})"


def facts(screen: Offscreen) -> dict[str, str]:
    """The renderer and the version of the driver, as they are written into a baseline."""
    described = screen.describe()
    return {"renderer": str(described["renderer"]), "version": str(described["version"])}


@cache
def probe() -> tuple[dict[str, str], Pixels]:
    """The scene "sphere" in 64 x 64 pixels: the renderer's facts, and what it drew."""
    from glsim.play.frames import drawer

    with own_screen(64, 64) as screen:
        drawer("sphere", 64)[1]()
        return facts(screen), opaque(screen)


def digest() -> str:
    """What identifies a renderer's arithmetic: a hash of the probe."""
    return sha256(probe()[1].tobytes()).hexdigest()[:16]


def comparable() -> str:
    """How this renderer's arithmetic compares with that of glsim's own probe picture, as a sentence."""
    _, drawn = probe()
    more, blocks = counts(rgba(PROBE), drawn)
    if more == blocks == 0:
        return "glsim's probe picture is within 2/255: baselines of other renderers can be compared"
    return (
        f"glsim's probe picture differs at {more} pixels by more than 2/255, with {blocks} blocks that are brighter or"
        " darker as a whole: expect baselines of other renderers to fail, and approve some of this renderer"
    )
