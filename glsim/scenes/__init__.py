"""Scenes: a mesh or several, a material, lights and a camera, drawn through the gl commands."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from glsim.machine.state import MAX_LIGHTS, Face
from glsim.names import did_you_mean
from glsim.scenes.load import fit, load
from glsim.scenes.materials import MATERIALS, material
from glsim.scenes.mesh import Mesh, MeshError
from glsim.scenes.shapes import cube, sphere, teapot, terrain, torus
from glsim.scenes.staging import Camera, Lamp

__all__ = ["BUILT_IN", "MATERIALS", "Camera", "Lamp", "Mesh", "MeshError", "Scene", "load", "material", "open_scene"]


# A key light from the upper left, and a weak one from the right so that no side is black.
DEFAULT_CAMERA = Camera()
DEFAULT_LIGHTS = (Lamp((-3.0, 4.0, 5.0, 0.0), 0.95), Lamp((5.0, 1.0, 3.0, 0.0), 0.25))


@dataclass(frozen=True)
class Scene:
    """What ``draw`` draws.  material: for meshes that have none of their own."""

    name: str
    meshes: Sequence[Mesh]
    material: Face = MATERIALS["brass"]
    camera: Camera = DEFAULT_CAMERA
    lights: Sequence[Lamp] = DEFAULT_LIGHTS
    two_sided: bool = False
    background: tuple[float, float, float] = field(default=(0.13, 0.14, 0.17))

    def draw(self, width: int, height: int) -> None:
        """Draw with the gl commands into a picture of this size; the shade model is left as it is."""
        from glsim import gl

        if len(self.lights) > MAX_LIGHTS:
            raise ValueError(f"a scene has at most {MAX_LIGHTS} lights, not {len(self.lights)}")
        gl.glClearColor(*self.background, 1.0)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        gl.glEnable(gl.GL_DEPTH_TEST)
        gl.glEnable(gl.GL_LIGHTING)
        gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, [0.3, 0.3, 0.3, 1.0])
        gl.glLightModeli(gl.GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
        gl.glLightModeli(gl.GL_LIGHT_MODEL_TWO_SIDE, int(self.two_sided))
        gl.glMatrixMode(gl.GL_PROJECTION)
        gl.glLoadIdentity()
        near, far = max(self.camera.distance - 2.0, 0.05), self.camera.distance + 2.0
        top = near * float(np.tan(np.radians(self.camera.angle / 2)))
        gl.glFrustum(-top * width / height, top * width / height, -top, top, near, far)
        gl.glMatrixMode(gl.GL_MODELVIEW)
        gl.glLoadIdentity()
        for number, light in enumerate(self.lights):
            _switch_on(gl.GL_LIGHT0 + number, light, self.camera.distance)
        gl.glTranslatef(0.0, 0.0, -self.camera.distance)
        gl.glRotatef(self.camera.elevation, 1.0, 0.0, 0.0)
        gl.glRotatef(-self.camera.azimuth, 0.0, 1.0, 0.0)
        for mesh in self.meshes:
            draw_mesh(mesh, mesh.material or self.material)


def _switch_on(light: int, lamp: Lamp, distance: float) -> None:
    """Set and enable GL_LIGHTi while the modelview matrix is the identity; distance: of the eye from the middle."""
    from glsim import gl

    color = [lamp.brightness] * 3 + [1.0]
    gl.glEnable(light)
    gl.glLightfv(light, gl.GL_POSITION, lamp.position)
    gl.glLightfv(light, gl.GL_DIFFUSE, color)
    gl.glLightfv(light, gl.GL_SPECULAR, color)
    if lamp.position[3] != 0.0:
        gl.glLightfv(light, gl.GL_SPOT_DIRECTION, lamp.aim((0.0, 0.0, -distance)))
        gl.glLightf(light, gl.GL_SPOT_CUTOFF, lamp.cutoff)
        gl.glLightf(light, gl.GL_SPOT_EXPONENT, lamp.exponent)
        for name, k in zip(("CONSTANT", "LINEAR", "QUADRATIC"), lamp.attenuation, strict=True):
            gl.glLightf(light, getattr(gl, f"GL_{name}_ATTENUATION"), k)


def draw_mesh(mesh: Mesh, face: Face) -> None:
    """One mesh as vertex arrays, under the current matrices and lights."""
    from glsim import gl

    side = gl.GL_FRONT_AND_BACK
    gl.glMaterialfv(side, gl.GL_AMBIENT, face.ambient)
    gl.glMaterialfv(side, gl.GL_DIFFUSE, face.diffuse)
    gl.glMaterialfv(side, gl.GL_SPECULAR, face.specular)
    gl.glMaterialfv(side, gl.GL_EMISSION, face.emission)
    gl.glMaterialf(side, gl.GL_SHININESS, face.shininess)
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_NORMAL_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, mesh.positions)
    gl.glNormalPointer(gl.GL_FLOAT, 0, mesh.normals)
    if mesh.colors is not None:
        gl.glColorMaterial(side, gl.GL_AMBIENT_AND_DIFFUSE)
        gl.glEnable(gl.GL_COLOR_MATERIAL)
        gl.glEnableClientState(gl.GL_COLOR_ARRAY)
        gl.glColorPointer(4, gl.GL_FLOAT, 0, mesh.colors)
    for mode, faces in ((gl.GL_TRIANGLES, mesh.triangles), (gl.GL_QUADS, mesh.quads)):
        if faces.size:
            gl.glDrawElements(mode, faces.size, gl.GL_UNSIGNED_INT, faces)
    for array in (gl.GL_VERTEX_ARRAY, gl.GL_NORMAL_ARRAY, gl.GL_COLOR_ARRAY):
        gl.glDisableClientState(array)
    gl.glDisable(gl.GL_COLOR_MATERIAL)


def _moved(mesh: Mesh, x: float, y: float, scale: float) -> Mesh:
    return replace(mesh, positions=(mesh.positions * scale + (x, y, 0)).astype(np.float32))


def _spheres(_: int) -> list[Mesh]:
    return [
        _moved(sphere(n), x, y, 0.48) for n, x, y in ((6, -0.5, 0.5), (12, 0.5, 0.5), (24, -0.5, -0.5), (96, 0.5, -0.5))
    ]


def _one(shape: Callable[[int], Mesh]) -> Callable[[int], list[Mesh]]:
    return lambda slices: fit([shape(slices)])


@dataclass(frozen=True)
class _BuiltIn:
    about: str
    meshes: Callable[[int], list[Mesh]]
    slices: int
    material: str
    camera: Camera = DEFAULT_CAMERA
    lights: Sequence[Lamp] = DEFAULT_LIGHTS


# A point light close to a face, whose brightest spot lies away from the vertices; and a weak light for the other sides.
NEAR_LAMP = (Lamp((-0.65, -0.3, -3.2, 1.0), 0.9), Lamp((1.0, 3.0, 3.0, 0.0), 0.4))

BUILT_IN: dict[str, _BuiltIn] = {
    "teapot": _BuiltIn("the Utah teapot from its Bezier patches", _one(teapot), 6, "brass", Camera(30, 22, 3.85)),
    "sphere": _BuiltIn("one sphere", _one(sphere), 16, "ruby", Camera(0, 10, 4.3)),
    "spheres": _BuiltIn("a sphere with 6, 12, 24 and 96 slices", _spheres, 0, "jade", Camera(0, 0, 4.0)),
    "torus": _BuiltIn("a torus", _one(torus), 24, "polished-gold", Camera(0, 35, 4.0)),
    "cube": _BuiltIn("a lamp near a cube of six quads", _one(cube), 1, "turquoise", Camera(30, 25, 4.3), NEAR_LAMP),
    "terrain": _BuiltIn(
        "smooth hills, so fine that Gouraud is almost Phong", _one(terrain), 96, "copper", Camera(30, 35, 4.0)
    ),
    "low-terrain": _BuiltIn("the same hills with few vertices", _one(terrain), 14, "copper", Camera(30, 35, 4.0)),
}


def open_scene(what: str | Path) -> Scene:
    """A built-in scene by name, "sphere" or with its number of slices "sphere:64", or a mesh file by path.

    Raises MeshError for a file that cannot be drawn, ValueError for a number of slices that cannot be.
    """
    name, _, number = str(what).partition(":")
    if name in BUILT_IN and not Path(what).exists():
        entry = BUILT_IN[name]
        if number and not (number.isdigit() and 1 <= int(number) <= 2000):
            raise ValueError(f"{what}: the number of slices must be from 1 to 2000, not {number!r}")
        slices = int(number) if number else entry.slices
        if name in ("sphere", "torus") and slices < 3:
            raise ValueError(f"{what}: a {name} needs at least 3 slices")
        return Scene(str(what), entry.meshes(slices), material(entry.material), entry.camera, entry.lights)
    if not Path(what).exists():
        known = f"the built-in scenes are {', '.join(BUILT_IN)}{did_you_mean(name, BUILT_IN)}"
        raise MeshError(f"{what}: there is no such file, and {known}")
    return Scene(Path(what).name, load(what), material("white-plastic"), two_sided=True)
