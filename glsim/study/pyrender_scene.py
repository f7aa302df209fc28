"""A pyrender.Scene drawn with gl commands, so that every shade model can show it.

The formulas of glsim.study.metallic are used the other way round: k_d, k_s and n from metallic, roughness and base
colour; I_d = I_s = colour times intensity / pi; a point light has k_q = 1 and no other attenuation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glsim.machine.state import MAX_LIGHTS, Face
from glsim.study.metallic import Metal, exponent, face
from glsim.study.pyrender_child import GAMMA

Float = NDArray[np.float64]


@dataclass(frozen=True)
class Drawing:
    """Draws a pyrender.Scene when it is called, as large as the viewport.  notes: what could not be converted."""

    scene: Any
    notes: tuple[str, ...]

    @property
    def __name__(self) -> str:
        return str(self.scene.name or "pyrender scene")

    def __call__(self) -> None:
        from glsim import gl

        scene = self.scene
        r, g, b = (np.clip(scene.bg_color[:3], 0.0, 1.0) ** GAMMA).tolist()  # pyrender shows it without its gamma
        gl.glClearColor(r, g, b, 1.0)
        gl.glClear(gl.GL_COLOR_BUFFER_BIT | gl.GL_DEPTH_BUFFER_BIT)
        for capability in (gl.GL_DEPTH_TEST, gl.GL_LIGHTING, gl.GL_NORMALIZE):
            gl.glEnable(capability)
        gl.glLightModeli(gl.GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
        camera = scene.main_camera_node
        width, height = np.array(gl.glGetIntegerv(gl.GL_VIEWPORT))[2:4].tolist()
        view = np.linalg.inv(scene.get_pose(camera))
        gl.glMatrixMode(gl.GL_PROJECTION)
        _load(camera.camera.get_projection_matrix(width=width, height=height))
        gl.glMatrixMode(gl.GL_MODELVIEW)
        _load(view)
        for number, node in enumerate(_brightest(scene)):
            _light(gl.GL_LIGHT0 + number, node.light, scene.get_pose(node))
        eye = scene.get_pose(camera)[:3, 3]
        for node in _farthest_first(scene, eye):
            for primitive in node.mesh.primitives if node.mesh.is_visible else ():
                for pose in (np.eye(4),) if primitive.poses is None else primitive.poses:
                    model = scene.get_pose(node) @ pose
                    _load(view @ model)
                    _draw(primitive, scene.ambient_light[:3], np.linalg.inv(model) @ np.append(eye, 1.0))


def drawing(scene: Any) -> Drawing:
    """The drawing function of a pyrender.Scene.  Raises ValueError if it has no camera."""
    if scene.main_camera_node is None:
        raise ValueError("the pyrender.Scene has no camera: scene.add(pyrender.PerspectiveCamera(yfov=1.0), pose=pose)")
    return Drawing(scene, tuple(_notes(scene)))


def _notes(scene: Any) -> Iterator[str]:
    lights, most = len(scene.light_nodes), MAX_LIGHTS
    if lights > most:
        yield f"OpenGL has {most} lights, the scene {lights}: the brightest are drawn"
    primitives = [primitive for mesh in scene.meshes for primitive in mesh.primitives]
    if any(primitive.material.textures for primitive in primitives):
        yield "textures are left out: the factors of the material stand for them"
    if any(not hasattr(primitive.material, "metallicFactor") for primitive in primitives):
        yield "materials other than MetallicRoughnessMaterial are drawn white"
    if any(p.color_0 is not None and np.ptp(p.color_0, axis=0).any() for p in primitives):
        yield "vertex colours that vary are factors of k_d and k_a, not of the highlight as in pyrender"


def _brightest(scene: Any) -> list[Any]:
    """The nodes of the lights that are drawn, the brightest first: pyrender keeps them in no order."""

    def key(node: Any) -> tuple[float, list[float]]:
        return -node.light.intensity * float(max(node.light.color)), scene.get_pose(node).ravel().tolist()

    return sorted(scene.light_nodes, key=key)[:MAX_LIGHTS]


def _farthest_first(scene: Any, eye: Float) -> list[Any]:
    """The nodes of the meshes as pyrender draws them: opaque ones first, then by the distance of their origins."""

    def key(node: Any) -> tuple[bool, float, list[float]]:
        pose = scene.get_pose(node)
        return node.mesh.is_transparent, -float(np.linalg.norm(pose[:3, 3] - eye)), pose.ravel().tolist()

    return sorted(scene.mesh_nodes, key=key)


def _load(matrix: Any) -> None:
    from glsim import gl

    gl.glLoadMatrixd(np.asarray(matrix, np.float64).T)


def _light(number: Any, light: Any, pose: Float) -> None:
    """Set one light, in world coordinates under the view as modelview."""
    from glsim import gl

    color = [*(np.array(light.color[:3]) * light.intensity / np.pi).tolist(), 1.0]
    directional = not hasattr(light, "range")
    gl.glEnable(number)
    gl.glLightfv(number, gl.GL_DIFFUSE, color)
    gl.glLightfv(number, gl.GL_SPECULAR, color)
    gl.glLightfv(number, gl.GL_POSITION, [*pose[:3, 2], 0.0] if directional else [*pose[:3, 3], 1.0])
    if not directional:
        gl.glLightf(number, gl.GL_CONSTANT_ATTENUATION, 0.0)
        gl.glLightf(number, gl.GL_QUADRATIC_ATTENUATION, 1.0)
    if hasattr(light, "outerConeAngle"):
        gl.glLightfv(number, gl.GL_SPOT_DIRECTION, -pose[:3, 2])
        gl.glLightf(number, gl.GL_SPOT_CUTOFF, min(float(np.degrees(light.outerConeAngle)), 90.0))
        gl.glLightf(number, gl.GL_SPOT_EXPONENT, exponent(light.innerConeAngle, light.outerConeAngle))


def _draw(primitive: Any, ambient: Any, eye: Float) -> None:
    """One primitive under the current matrices.  eye: position of the camera in its coordinates, (4,)."""
    from glsim import gl

    material, side = primitive.material, gl.GL_FRONT_AND_BACK
    look = face(_metal(material))
    colors = primitive.color_0
    if colors is not None and not np.ptp(colors, axis=0).any():  # one colour, a factor of everything
        r, g, b, a = colors[0].tolist()
        k_a, k_d, k_s, emission = ((x * r, y * g, z * b, w * a) for x, y, z, w in look[:4])
        look, colors = Face(k_a, k_d, k_s, emission, look.shininess), None
    gl.glMaterialfv(side, gl.GL_AMBIENT, look.ambient)
    gl.glMaterialfv(side, gl.GL_DIFFUSE, look.diffuse)
    gl.glMaterialfv(side, gl.GL_SPECULAR, look.specular)
    gl.glMaterialfv(side, gl.GL_EMISSION, look.emission)
    gl.glMaterialf(side, gl.GL_SHININESS, look.shininess)
    if colors is not None:  # glColorMaterial makes k_a = k_d, so the ambient light takes what k_a has more
        ambient = np.array(ambient) * look.ambient[:3] / np.maximum(look.diffuse[:3], 1e-6)
        gl.glColorMaterial(side, gl.GL_AMBIENT_AND_DIFFUSE)
        gl.glEnable(gl.GL_COLOR_MATERIAL)
        gl.glEnableClientState(gl.GL_COLOR_ARRAY)
        gl.glColorPointer(4, gl.GL_FLOAT, 0, np.ascontiguousarray(colors * np.array(look.diffuse), np.float32))
    gl.glLightModelfv(gl.GL_LIGHT_MODEL_AMBIENT, [*ambient, 1.0])
    for capability, on in ((gl.GL_CULL_FACE, not material.doubleSided), (gl.GL_BLEND, material.alphaMode == "BLEND")):
        (gl.glEnable if on else gl.glDisable)(capability)
    gl.glBlendFunc(gl.GL_SRC_ALPHA, gl.GL_ONE_MINUS_SRC_ALPHA)
    gl.glPolygonMode(side, gl.GL_LINE if material.wireframe else gl.GL_FILL)
    normals = primitive.normals
    if normals is None:  # then pyrender takes V for N
        normals = eye[:3] - primitive.positions
    gl.glEnableClientState(gl.GL_VERTEX_ARRAY)
    gl.glEnableClientState(gl.GL_NORMAL_ARRAY)
    gl.glVertexPointer(3, gl.GL_FLOAT, 0, np.ascontiguousarray(primitive.positions, np.float32))
    gl.glNormalPointer(gl.GL_FLOAT, 0, np.ascontiguousarray(normals, np.float32))
    if primitive.indices is None:
        gl.glDrawArrays(primitive.mode, 0, len(primitive.positions))
    else:
        indices = primitive.indices.ravel().astype(np.uint32)
        gl.glDrawElements(primitive.mode, indices.size, gl.GL_UNSIGNED_INT, indices)
    for array in (gl.GL_VERTEX_ARRAY, gl.GL_NORMAL_ARRAY, gl.GL_COLOR_ARRAY):
        gl.glDisableClientState(array)
    gl.glDisable(gl.GL_COLOR_MATERIAL)


def _metal(material: Any) -> Metal:
    if not hasattr(material, "metallicFactor"):
        return Metal()
    r, g, b, a = np.array(material.baseColorFactor, np.float64).tolist()
    er, eg, eb = (np.array(material.emissiveFactor, np.float64) ** 2).tolist()  # as pyrender's shader does
    return Metal((r, g, b, a), float(material.metallicFactor), float(material.roughnessFactor), (er, eg, eb))
