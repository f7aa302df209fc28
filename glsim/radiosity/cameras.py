"""Cameras: by name or number, written as numbers, around a scene, and where a file has none."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from glsim.names import did_you_mean
from glsim.radiosity.scene import Scene, SceneError, View
from glsim.scenes.staging import Camera, camera_of, numbers

if TYPE_CHECKING:
    from glsim.radiosity.result import Radiosity

Float = NDArray[np.float64]
Viewpoint = int | str | View | Camera  # a camera of the scene by number or name, any, or one around the scene
LIT = 0.02  # of the radiosity that becomes white: what is darker looks black


def viewpoint(text: str) -> str | View | Camera:
    """Return a camera as it is written: NAME, AZIMUTH,ELEVATION[,DISTANCE], or X,Y,Z/X,Y,Z[/DEGREES].

    The last is an eye, the point at which it looks, and the angle from bottom to top (50).  Raises ValueError.
    """
    if "/" in text:
        return _placed(text)
    return camera_of(text) if text[:1] in "-.0123456789" else text


def _placed(text: str) -> View:
    """Return the camera of X,Y,Z/X,Y,Z[/DEGREES].  Raises ValueError with a sentence."""
    parts = text.split("/")
    if len(parts) > 3:
        raise ValueError(f"an eye, a point to look at and an angle are X,Y,Z/X,Y,Z/DEGREES, not {text!r}")
    (x, y, z), (a, b, c) = (numbers(part, 3, 3) for part in parts[:2])
    (fov,) = numbers(parts[2], 1, 1) if len(parts) == 3 else (50.0,)
    if not 1.0 <= fov <= 170.0:
        raise ValueError(f"the angle from bottom to top is 1 to 170 degrees, not {fov:g}")
    if (x, y, z) == (a, b, c):
        raise ValueError(f"the eye and the point at which it looks are the same, {parts[0]}")
    upright = x != a or z != c
    return View((x, y, z), (a, b, c), (0.0, 1.0, 0.0) if upright else (0.0, 0.0, -1.0), fov)


def named(scene: Scene, which: int | str) -> View:
    """Return one of a scene's own cameras by number or name.  Raises SceneError if it is not there."""
    if isinstance(which, str):
        names = [view.name for view in scene.views if view.name]
        if which not in names:
            known = (
                f"its cameras are {', '.join(names)}{did_you_mean(which, names)}"
                if names
                else "its cameras have no names"
            )
            raise SceneError(
                f"{scene.name} has no camera named {which!r}; {known}; numbers are X,Y,Z/X,Y,Z[/DEGREES] (eye, where it"
                " looks, angle) or AZIMUTH,ELEVATION[,DISTANCE]"
            )
        return next(view for view in scene.views if view.name == which)
    if not 0 <= which < max(len(scene.views), 1):
        many = "1 view" if len(scene.views) < 2 else f"{len(scene.views)} views"
        raise SceneError(f"{scene.name} has {many}, numbered from 0; there is no {which}")
    return scene.views[which]


def automatic(result: Radiosity) -> View:
    """Return a camera for a scene that has none: from the front outside, or from a corner inside.

    A closed room is seen into from outside, because backs are not drawn, but not through walls that are solid: the
    outside is chosen unless a corner shows more than twice as many lit patches.
    """
    from glsim.radiosity.view import seen_patches

    scene = result.patches.scene
    points = np.concatenate(scene.polygons)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, half = (low + high) / 2.0, (high - low) / 2.0
    views = [view_of(points)]
    for x, z in ((1, 1), (-1, 1), (1, -1), (-1, -1)):
        for near in (0.9, 0.6):
            eye, at = middle + half * (near * x, 0.3, near * z), middle - half * (0.4 * x, 0.2, 0.4 * z)
            views.append(View(tuple(eye.tolist()), tuple(at.tolist()), fov=65.0))
    lit = result.B.max(axis=1) > LIT * result.shown_white
    many = [int(lit[seen_patches(result, view)].sum()) for view in views]
    return views[0] if 2 * many[0] >= max(many) else views[int(np.argmax(many))]


def view_of(points: Float) -> View:
    """Return a camera that sees all points (n, 3), from the front and a little above."""
    low, high = points.min(axis=0), points.max(axis=0)
    middle, size = (low + high) / 2.0, float(np.linalg.norm(high - low))
    eye = middle + size * np.array([0.35, 0.3, 1.2])
    return View(tuple(eye.tolist()), tuple(middle.tolist()), fov=40.0)


def view_around(scene: Scene, camera: Camera) -> View:
    """A camera outside of a scene, that looks at its middle.

    camera: azimuth 0 is the side on which the scene's first camera stands, 90 on its right; distance in radii of the
    sphere around the scene.  Walls are seen from their fronts alone, so a closed room is seen into.
    """
    points = np.concatenate(scene.polygons)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = (low + high) / 2.0, float(np.linalg.norm(high - low)) / 2.0
    first = scene.views[0] if scene.views else view_of(points)
    up = np.array(first.up, float) / np.linalg.norm(first.up)
    back = np.subtract(first.eye, first.target)
    front = back - (back @ up) * up
    if np.linalg.norm(front) < 1e-6 * np.linalg.norm(back):  # it looks straight down
        front = np.cross(up, (0.0, 0.0, 1.0) if abs(up[2]) < 0.9 else (1.0, 0.0, 0.0))
    front /= np.linalg.norm(front)
    right = np.cross(up, front)
    a, e = np.radians((camera.azimuth, min(max(camera.elevation, -89.9), 89.9)))
    towards = np.cos(e) * (np.sin(a) * right + np.cos(a) * front) + np.sin(e) * up
    eye = middle + camera.distance * radius * towards
    x, y, z = up.tolist()
    return View(tuple(eye.tolist()), tuple(middle.tolist()), (x, y, z), camera.angle)
