"""Scenes for radiosity by name, from mesh files (see files.py), and from what any program draws (see program.py)."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from glsim.names import did_you_mean
from glsim.radiosity.files import from_file
from glsim.radiosity.scene import Channels, Material, Scene, SceneError
from glsim.radiosity.scenes import BUILT_IN


def scene_from(
    what: Any, materials: Mapping[str, Material] | None = None, *, emit: Mapping[str, Channels] | None = None,
    two_sided: bool = False,
) -> Scene:  # fmt: skip
    """Return the scene of a built-in one's name, a mesh file (GLB, OBJ, PLY, ...), a program (.py), a Frame or a Scene.

    materials: instead of those of the same name; emit: exitances for materials, by their names; two_sided: sheets,
    which are no body's surface, reflect on both sides.  Raises SceneError for what cannot be used.

        radiosity.solve(radiosity.scene_from("room.obj", emit={"bulb": (20, 18, 12)}, two_sided=True))
    """
    from glsim.machine.frame import Frame
    from glsim.radiosity.program import from_frame

    if isinstance(what, Scene):
        scene = what
    elif not isinstance(what, (str, os.PathLike, Frame)):
        raise SceneError(
            f"a scene is a radiosity.Scene (of a Builder: builder.scene()), a name, a file, a program or a Frame, not"
            f" {what!r}"
        )
    elif isinstance(what, Frame):
        scene = from_frame(what)
    elif str(what) in BUILT_IN and not Path(what).exists():
        scene = BUILT_IN[str(what)].make()
    elif str(what).endswith(".py"):
        from glsim.play.frames import frame_of

        scene = from_frame(frame_of(what), str(what))
    elif Path(what).is_dir():
        raise SceneError(f"{what} is a folder; name a mesh file, a program or a built-in scene")
    elif Path(what).exists():
        scene = from_file(Path(what))
    else:
        known = f"the built-in scenes are {', '.join(BUILT_IN)}{did_you_mean(str(what), BUILT_IN)}"
        raise SceneError(f"{what}: there is no such file, and {known}")
    if unknown := (set(materials or {}) | set(emit or {})) - {material.name for material in scene.materials}:
        known = ", ".join(sorted({material.name for material in scene.materials}))
        raise SceneError(f"{scene.name} has no material named {', '.join(sorted(unknown))}; it has {known}")
    changed = [(materials or {}).get(material.name, material) for material in scene.materials]
    lit = tuple(material._replace(E=(emit or {}).get(material.name, material.E)) for material in changed)
    scene = replace(scene, materials=lit)
    return scene.two_sided() if two_sided else scene
