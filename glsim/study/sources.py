"""What gives a comparison its Frames: a scene, a function that draws, a program or a Frame, a radiosity solution."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.machine.frame import Frame
from glsim.play.capture import capture
from glsim.play.frames import frame_of_program, scene_from
from glsim.scenes import BUILT_IN, Camera, Lamp, Scene, material, open_scene

if TYPE_CHECKING:
    from glsim.radiosity.result import Radiosity
    from glsim.render.context import Offscreen

Pixels = NDArray[np.uint8]
Arguments = tuple[tuple[str, Any], ...]


class Source:
    """Gives Frames of one size; this one gives none, for comparisons of given pictures.

    title: of the sheet.  width, height: in pixels.  parameters: names of further axes.  camera: that a turntable
    moves, None if the source sets its own.  original: a pyrender.Scene, which pyrender draws as it is.  note: what went
    wrong, though there is a Frame.  toned: whether ``finished`` changes pixels.  remarks: sentences about what is shown
    otherwise than it was given.
    """

    title: str = ""
    width: int = 512
    height: int = 512
    parameters: tuple[str, ...] = ()
    camera: Camera | None = None
    original: Any = None
    toned: bool = False
    note: str = ""
    remarks: tuple[str, ...] = ()

    def frame(self, arguments: Arguments, screen: Offscreen, calls: bool) -> Frame:
        """What is drawn with these arguments; ``screen``: to draw it on, in its initial state afterwards."""
        raise NotImplementedError

    def forget(self) -> None:
        """Let go of Frames that were kept to be drawn in several looks."""

    def solved(self, mode: str, samples: int) -> Pixels:
        """The picture of a mode of radiosity."""
        raise ValueError(f"compare: {self.title} gives no scene for radiosity")

    def finished(self, pixels: Pixels) -> Pixels:
        return pixels

    def of_size(self, size: int) -> Source:
        """The same, ``size`` pixels wide and high, if it can be drawn at any size."""
        return self


class Drawn(Source):
    """What a function draws.  The function takes the arguments that it has parameters for."""

    def __init__(self, title: str, draw: Callable[..., object], size: int) -> None:
        self.title, self.draw, self.width, self.height = title, draw, size, size
        self.parameters = parameters_of(draw)
        self.frames: dict[tuple[tuple[str, int], ...], Frame] = {}

    def frame(self, arguments: Arguments, screen: Offscreen, calls: bool) -> Frame:
        key = tuple((name, id(value)) for name, value in arguments)  # the axes hold the values
        if key not in self.frames:
            draw = self.drawing(dict(arguments))
            screen.reset()
            screen.make_current()
            with capture(calls=calls) as frame:
                draw()
            if not frame.packets:
                raise ValueError(f"compare: {self.title} draws nothing here: does it open a context of its own?")
            self.frames[key] = frame
        return self.frames[key]

    def forget(self) -> None:
        self.frames.clear()

    def of_size(self, size: int) -> Source:
        other = copy(self)
        other.width, other.height, other.frames = size, size, {}
        return other

    def drawing(self, arguments: Mapping[str, Any]) -> Callable[[], object]:
        for name in arguments:
            if name not in self.parameters:
                raise ValueError(
                    f"compare: {self.title} sets its own {name}; a drawing function is swept by {name} if it has a"
                    f" parameter of that name: def {self.title}({name})"
                )
        return lambda: self.draw(**arguments)


class Staged(Drawn):
    """A scene, of which segments, material and camera can be changed."""

    def __init__(self, scene: Scene, size: int) -> None:
        self.scene, self.camera = scene, scene.camera
        super().__init__(scene.name, scene.draw, size)
        self.parameters = ()

    def drawing(self, arguments: Mapping[str, Any]) -> Callable[[], object]:
        scene = self.changed(arguments)
        return lambda: scene.draw(self.width, self.height)

    def changed(self, arguments: Mapping[str, Any]) -> Scene:
        scene = self.scene
        if "segments" in arguments:
            scene = replace(scene, meshes=self._cut(arguments["segments"]))
        if "material" in arguments:
            scene = _of_material(scene, arguments["material"])
        return replace(scene, camera=arguments.get("camera", scene.camera))

    def _cut(self, segments: int) -> Any:
        name = self.title.partition(":")[0]
        if name not in BUILT_IN or not BUILT_IN[name].slices:
            cut = ", ".join(name for name, entry in BUILT_IN.items() if entry.slices)
            raise ValueError(f"compare: {self.title} has its own vertices; segments are for {cut}")
        meshes = open_scene(f"{name}:{segments}").meshes
        face, colored = self.scene.meshes[0].material, self.scene.meshes[0].colors
        return [replace(mesh, material=face, colors=colored) for mesh in meshes]


class Still(Source):
    """One Frame, of a program or captured."""

    def __init__(self, title: str, frame: Frame) -> None:
        self.title, self.whole, self.width, self.height = title, frame, frame.width, frame.height
        self.note = f"{title} ended early: {frame.error}" if frame.error else ""

    def frame(self, arguments: Arguments, screen: Offscreen, calls: bool) -> Frame:
        if arguments:
            raise ValueError(f"compare: {self.title} sets its own {arguments[0][0]}; only scenes are swept by it")
        return self.whole


class Solved(Source):
    """A radiosity solution, and its scene lit by OpenGL's lights."""

    toned = True

    def __init__(self, result: Radiosity, size: int, view: int) -> None:
        from glsim.radiosity.tone import toned

        self.result, self.view, self.width, self.height = result, view, size, size
        self.title = result.patches.scene.name
        self.values = np.round(255.0 * toned(np.arange(256) / 255.0, 1.0)).astype(np.uint8)
        self.whole: Frame | None = None
        result.view(view)  # raises before anything is drawn

    def frame(self, arguments: Arguments, screen: Offscreen, calls: bool) -> Frame:
        from glsim.radiosity.view import draw_point_lights

        if arguments:
            raise ValueError(f"compare: with radiosity the scene has its own {arguments[0][0]}")
        if self.whole is None:
            screen.reset()
            screen.make_current()
            with capture(calls=calls) as self.whole:
                draw_point_lights(self.result, self.result.view(self.view), self.result.shown_white)
        return self.whole

    def solved(self, mode: str, samples: int) -> Pixels:
        result = self.result
        B = result.direct() if mode == "direct" else None
        return np.asarray(result.picture(self.width, self.view, B=B, samples=samples))

    def finished(self, pixels: Pixels) -> Pixels:
        return self.values[pixels]


# ---------------------------------------------------------------- which source


class Wanted(NamedTuple):
    """Options of ``compare`` that decide what is drawn.  calls: whether calls must be recorded."""

    size: int | None = None
    lights: Sequence[Lamp] | None = None
    material: str | None = None
    camera: Camera | None = None
    patches: int = 1000
    view: int = 0
    timeout: float | None = 60.0
    calls: bool = False

    @property
    def own(self) -> bool:
        """Whether the scene's lights, material or camera are to be replaced."""
        return self.lights is not None or self.material is not None or self.camera is not None


def source_of(what: Any, wanted: Wanted, radiosity: bool, tell: Callable[[str], object]) -> Source:
    """The source for what ``compare`` takes.  radiosity: whether its modes are asked for.  tell: of the progress."""
    size = 512 if wanted.size is None else wanted.size
    if radiosity or is_radiosity(what):
        if wanted.own:
            raise ValueError("compare: with radiosity the scene has its own lamps, materials and cameras: use --view")
        from glsim.radiosity import solve

        result = solve(
            what, wanted.patches, progress=lambda stage, done, of: tell(f"{stage}: {100 * done // max(of, 1)} %")
        )
        return Solved(result, size, wanted.view)
    from glsim.study.pyrender import is_scene, scene_of

    if isinstance(what, Frame):
        return Still("frame", what)
    if isinstance(what, (str, Path)) and str(what).endswith(".py"):
        if wanted.own:
            raise ValueError("compare: a program sets its own lights, material and camera; --sweep light=... moves one")
        tell(f"running {Path(what).name}")
        frame = frame_of_program(what, calls=wanted.calls, timeout=wanted.timeout, size=wanted.size)
        if frame.error and not frame.packets:
            raise ValueError(f"compare: {what} gives no picture: {frame.error}")
        return Still(Path(what).name, frame)
    if is_scene(what):
        if wanted.own:
            raise ValueError("compare: a pyrender.Scene has its own lights, materials and camera")
        drawing = scene_of(what)
        source = Drawn(drawing.__name__, drawing, size)
        source.original, source.remarks = what, drawing.notes
        return source
    if callable(what) and not isinstance(what, Scene):
        if wanted.own:
            raise ValueError("compare: a drawing function sets its own lights, material and camera")
        return Drawn(getattr(what, "__name__", "drawing"), what, size)
    tell("reading the scene")
    scene = scene_from(what)
    scene = replace(scene, lights=scene.lights if wanted.lights is None else wanted.lights)
    scene = scene if wanted.material is None else _of_material(scene, wanted.material)
    return Staged(replace(scene, camera=wanted.camera or scene.camera), size)


def _of_material(scene: Scene, name: str) -> Scene:
    face = material(name)
    return replace(scene, material=face, meshes=[replace(m, material=face, colors=None) for m in scene.meshes])


def parameters_of(draw: Any) -> tuple[str, ...]:
    """Names of a drawing function's parameters; none of something else."""
    if not callable(draw) or isinstance(draw, Scene):
        return ()
    try:
        return tuple(inspect.signature(draw).parameters)
    except (TypeError, ValueError):
        return ()


def is_radiosity(what: Any) -> bool:
    """Whether ``what`` is a radiosity.Scene, or a name that only a built-in radiosity scene has."""
    from glsim.radiosity import scene
    from glsim.radiosity.scenes import BUILT_IN as ROOMS

    if isinstance(what, scene.Scene):
        return True
    return isinstance(what, str) and what in ROOMS and what not in BUILT_IN and not Path(what).exists()
