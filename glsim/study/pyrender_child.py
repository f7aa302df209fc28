"""Drawing with pyrender, in a process of its own: python -m glsim.study.pyrender_child FOLDER.

FOLDER holds ``job``, a pickled list of Jobs; each picture is written there as <number>.npy, or ``failure``, a sentence.
"""

from __future__ import annotations

import pickle
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glsim.study.metallic import Source
from glsim.study.physical import Around, Part, Physical

GAMMA = 2.2
ENCODING = "pow(color.xyz, vec3(1.0/2.2))"  # the last step of pyrender's shader
FAR = 1e7  # where the eye is for a viewer that is not local


class Job(NamedTuple):
    """One picture.  scene: a Physical, or a pickled pyrender.Scene.  encoded: with pyrender's gamma."""

    scene: Physical | bytes
    width: int
    height: int
    samples: int
    encoded: bool


def import_pyrender() -> Any:
    """pyrender, mended for the NumPy of today.  Changes NumPy: for this process alone."""
    if not hasattr(np, "infty"):
        np.infty = np.inf  # type: ignore[attr-defined]
    import pyrender

    return pyrender


def draw(jobs: list[Job], folder: Path) -> None:
    """Draw each job into ``folder``."""
    pyrender = import_pyrender()
    from OpenGL import GL

    pyrender.renderer.MAX_N_LIGHTS = 8  # as many of each kind as OpenGL has
    for number, job in enumerate(jobs):
        pyrender.offscreen.Renderer = renderer(pyrender, job, shaders(pyrender, folder, job.encoded))
        scene = prepared(job)
        screen = pyrender.OffscreenRenderer(job.width, job.height)
        most = int(GL.glGetIntegerv(GL.GL_MAX_SAMPLES))
        if job.samples > most:
            raise ValueError(f"samples must be at most {most} in pyrender's context, not {job.samples}")
        try:
            pixels, _ = screen.render(scene)
        finally:
            screen.delete()
        np.save(folder / f"{number}.npy", pixels)


def shaders(pyrender: Any, folder: Path, encoded: bool) -> str | None:
    """The folder of pyrender's shaders; unless ``encoded``, a copy in which linear values are written."""
    if encoded:
        return None
    copy = folder / "shaders"
    if not copy.exists():
        shutil.copytree(Path(pyrender.__file__).parent / "shaders", copy)
        fragment = copy / "mesh.frag"
        text = fragment.read_text()
        if ENCODING not in text:
            raise ValueError("this version of pyrender ends its shader in another way than glsim knows")
        fragment.write_text(text.replace(ENCODING, "color.xyz"))
    return str(copy)


def renderer(pyrender: Any, job: Job, shader_folder: str | None) -> Any:
    """pyrender's Renderer with the job's samples and, where a node has an Around, with its lights and its camera."""
    from OpenGL import GL
    from pyrender.shader_program import ShaderProgramCache

    class Adapted(pyrender.Renderer):  # type: ignore[misc]
        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments)
            self._program_cache = ShaderProgramCache(shader_folder)

        def _bind_lighting(self, scene: Any, program: Any, node: Any, flags: int) -> None:
            around = getattr(node, "around", None)
            super()._bind_lighting(node.lights if around else scene, program, node, flags)
            if around:
                program.set_uniform("P", np.array(around.projection).T)
                program.set_uniform("cam_pos", np.array([0.0, 0.0, 0.0 if around.local_viewer else FAR]))
                GL.glViewport(*around.viewport)

    def storage(target: int, _: int, *rest: int) -> None:
        GL.glRenderbufferStorageMultisample(target, job.samples, *rest)

    pyrender.renderer.glRenderbufferStorageMultisample = storage
    return Adapted


# ---------------------------------------------------------------- scenes


def prepared(job: Job) -> Any:
    """The pyrender.Scene of a job."""
    pyrender = import_pyrender()
    if isinstance(job.scene, Physical):
        return converted(pyrender, job.scene, job.encoded)
    scene = pickle.loads(job.scene)
    if scene.main_camera_node is None:
        raise ValueError("the pyrender.Scene has no camera: scene.add(pyrender.PerspectiveCamera(yfov=1.0), pose=pose)")
    for mesh in scene.meshes:  # what it has in the context of the process that it came from, it lacks here
        for primitive in mesh.primitives:
            primitive._vaid, primitive._buffers = None, []
            for texture in primitive.material.textures:
                texture._texid = None
    if not job.encoded:
        scene.bg_color = np.append(np.clip(scene.bg_color[:3], 0.0, 1.0) ** GAMMA, scene.bg_color[3:])
    return scene


def converted(pyrender: Any, physical: Physical, encoded: bool) -> Any:
    """A pyrender.Scene of a Physical: eye space is the world, the camera stands at its origin."""
    background = np.array(physical.background, np.float64)
    scene = pyrender.Scene(bg_color=np.append(background ** (1.0 / GAMMA) if encoded else background, 1.0))
    scene.add(pyrender.PerspectiveCamera(yfov=1.0))  # its projection is replaced by the Around's
    lights: dict[Around, Any] = {}
    for part in physical.parts:
        if part.around not in lights:
            lights[part.around] = light_scene(pyrender, part.around)
        primitive = pyrender.Primitive(
            part.positions, normals=part.normals, color_0=part.colors, material=material(pyrender, part),
            mode={1: 0, 2: 1, 3: 4}[part.corners],
        )  # fmt: skip
        node = scene.add(pyrender.Mesh([primitive]))
        node.around, node.lights = part.around, lights[part.around]
    return scene


def material(pyrender: Any, part: Part) -> Any:
    metal = part.material
    return pyrender.MetallicRoughnessMaterial(
        baseColorFactor=np.array(metal.base), metallicFactor=metal.metallic, roughnessFactor=metal.roughness,
        emissiveFactor=np.sqrt(metal.glow),  # its shader multiplies the emissive colour by itself
        alphaMode="BLEND" if part.blended else "OPAQUE", doubleSided=part.both_sides, wireframe=part.wire,
    )  # fmt: skip


def light_scene(pyrender: Any, around: Around) -> Any:
    """A scene that holds nothing but lights."""
    scene = pyrender.Scene(ambient_light=np.full(3, around.ambient))
    makers: dict[str, Callable[[Source], Any]] = {
        "directional": lambda s: pyrender.DirectionalLight(color=np.array(s.color)),
        "point": lambda s: pyrender.PointLight(color=np.array(s.color)),
        "spot": lambda s: pyrender.SpotLight(color=np.array(s.color), innerConeAngle=s.inner, outerConeAngle=s.outer),
    }
    for source in around.sources:
        scene.add(makers[source.kind](source), pose=pose(source))
    return scene


def pose(source: Source) -> NDArray[np.float64]:
    """The matrix that turns -z into the light's direction and moves the origin to its position."""
    z = -np.array(source.direction, np.float64)
    x = np.cross((0.0, 1.0, 0.0) if abs(z[1]) < 0.9 else (1.0, 0.0, 0.0), z)
    x /= np.linalg.norm(x)
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2], matrix[:3, 3] = x, np.cross(z, x), z, source.position
    return matrix


def main(folder: Path) -> None:
    try:
        draw(pickle.loads((folder / "job").read_bytes()), folder)
    except Exception as error:
        (folder / "failure").write_text(f"{type(error).__name__}: {error}", encoding="utf-8")
        raise


if __name__ == "__main__":
    main(Path(sys.argv[1]))
