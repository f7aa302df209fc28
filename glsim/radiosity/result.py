"""The result of ``solve``: numbers, pictures and files of a solution."""

from __future__ import annotations

import os
from base64 import b64encode
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glsim.files import write_atomically
from glsim.radiosity.cameras import Viewpoint, automatic, named, view_around
from glsim.radiosity.factors import Factors
from glsim.radiosity.gather import Light, gathered, irradiance_at, radiosity_at
from glsim.radiosity.mesh import PatchMesh, mesh_of
from glsim.radiosity.patches import Patches
from glsim.radiosity.progress import Progress, silent
from glsim.radiosity.scene import SceneError, View
from glsim.radiosity.solvers import SOLVERS, SolverStep, System, shooting
from glsim.radiosity.tone import GAMMA, automatic_white, toned
from glsim.scenes import Camera

if TYPE_CHECKING:
    from PIL import Image

Float = NDArray[np.float64]
OPEN = 5e-3  # share of the light that escapes: above it the scene is open, below it form factors are inexact
BLIND = 1e-3  # a patch whose row of form factors has a smaller sum sees nothing


@dataclass(frozen=True, repr=False)
class Radiosity:
    """The solution of a scene.

    B: (n, 3) per patch; steps: one for each iteration (only the last has its B); mesh, vertex_radiosity: triangles and
    the radiosity at their vertices (V, 3); light: the irradiance there, None if it was not gathered; seconds: by stage.
    white: the radiosity that becomes white, tone: see tone.TONES (None: as the scene has them, or by the brightness of
    its surfaces); gamma: of the screen.
    """

    patches: Patches
    factors: Factors
    steps: list[SolverStep]
    B: Float
    mesh: PatchMesh
    vertex_radiosity: Float
    light: Light | None
    solver: str
    seconds: dict[str, float] = field(default_factory=dict)
    white: float | None = None
    tone: str | None = None
    gamma: float = GAMMA

    # ------------------------------------------------------------ numbers

    def report(self) -> dict[str, Any]:
        """Return the solution's key figures as values for JSON: numbers of patches, accuracy, seconds, notes."""
        sums = self.factors.row_sums
        error = np.abs(sums - 1.0)
        last = self.steps[-1]
        leak = float(1.0 - (sums * self.patches.area).sum() / self.patches.area.sum())
        return {
            "scene": self.patches.scene.name, "n": len(self.patches), "method": self.factors.method,
            "solver": self.solver, "iterations": last.iteration, "residual": last.residual,
            "row_sum_error_mean": float(error.mean()), "row_sum_error_max": float(error.max()),
            "leak": leak,
            "reciprocity": self.factors.asymmetry, "energy_balance": last.balance, "vertices": len(self.mesh.vertices),
            "triangles": len(self.mesh.triangles),
            "notes": [*self.patches.scene.notes, *_noticed(self.patches, sums, leak)],
            "seconds": {name: round(value, 4) for name, value in self.seconds.items()},
        }  # fmt: skip

    # ------------------------------------------------------------ pictures

    def draw(self, colors: Float | None = None) -> None:
        """Draw with the gl commands under the current matrices: vertex colours, GL_SMOOTH, no lighting, fronts only.

        colors: (V, 3) of the vertices, instead of those of the radiosity and of textures.
        """
        from glsim.radiosity.view import draw_colors, draw_solution

        if colors is None:
            draw_solution(self, self.vertex_radiosity)
        else:
            draw_colors(self.mesh, colors)

    def colors(self, B: Float | None = None) -> Float:
        """Return colours for the screen, (V, 3) in [0, 1], of the vertices' radiosity or of another, B (V, 3)."""
        shown = self.vertex_radiosity if B is None else B
        return toned(shown, self.shown_white, self.shown_tone, self.gamma)

    @property
    def shown_tone(self) -> str:
        """The name of the tone mapping."""
        return self.tone or self.patches.scene.tone

    @property
    def shown_white(self) -> float:
        """The radiosity that becomes white."""
        return self.white or self.patches.scene.white or automatic_white(self.patches, self.B)

    def picture(
        self, size: int = 512, view: Viewpoint = 0, *, camera: Camera | None = None, B: Float | None = None,
        colors: Float | None = None, samples: int = 4,
    ) -> Image.Image:  # fmt: skip
        """Draw the scene, ``size`` pixels wide and high.

        view: the number or the name of one of its cameras, or a View.  camera: one around the scene instead, as
        ``Camera(azimuth, elevation, distance)`` of glsim.scenes (see cameras.view_around).  B: (V, 3), a radiosity of
        vertices instead of the solution's; colors: (V, 3), instead of those of any radiosity and of textures.

            radiosity.solve("cornell", 300).picture(camera=Camera(30, 25, 3)).save("from-the-right.png")
        """
        from glsim.radiosity.view import draw_colors, draw_solution, picture_of

        def draw() -> None:
            if colors is None:
                draw_solution(self, self.vertex_radiosity if B is None else B)
            else:
                draw_colors(self.mesh, colors)

        return picture_of(draw, self.patches.scene, self.view(camera or view), size, samples)

    def direct(self) -> Float:
        """Return the radiosity at the vertices (V, 3) after one bounce: what direct illumination shows."""
        return self.at_vertices(self.patches.E)

    @cached_property
    def patch_mesh(self) -> PatchMesh:
        """The mesh of the patches as they were solved; ``mesh`` is finer unless ``drawn`` was 0."""
        return mesh_of(self.patches)

    def at_vertices(self, B: Float) -> Float:
        """Return the radiosity at the vertices (V, 3) that patches with the radiosities B (n, 3) give: the light from
        them is gathered once more at each vertex, and with it that of the lamps."""
        p, mesh = self.patches, self.mesh
        if self.light is None:
            return radiosity_at(self.factors, mesh.at, mesh.normals, mesh.patch, B)
        H = self.light.direct + irradiance_at(self.factors, mesh.at, mesh.normals, mesh.patch, B - p.E)
        return np.asarray(p.E[mesh.patch] + p.rho[mesh.patch] * H)

    def iterations(self, solver: str = "gauss-seidel", many: int | None = None) -> Iterator[SolverStep]:
        """Solve the system again, and yield a SolverStep with its B (n, 3) after each iteration, without an end.

        solver: "jacobi", "gauss-seidel", "shooting", ...  many: shots in a step of "shooting", by default a twentieth
        of the patches.  Raises SceneError for an unknown solver."""
        if solver not in SOLVERS:
            raise SceneError(f"the solvers are {', '.join(SOLVERS)}, not {solver!r}")
        system = System.of(self.factors)
        return shooting(system, many=many) if solver == "shooting" else SOLVERS[solver](system)

    def beside_direct(self, size: int = 512, view: Viewpoint = 0) -> Image.Image:
        """Draw direct illumination and radiosity from the same camera, side by side, with the same white."""
        from glsim.pictures import tiles

        both = (("direct illumination", self.direct()), ("radiosity", self.vertex_radiosity))
        row = [(name, np.asarray(self.picture(size, view, B=B))) for name, B in both]
        return tiles(self.patches.scene.name, [row], size)

    @cached_property
    def corner_radiosity(self) -> Float:
        """The radiosity at the vertices of ``patch_mesh``: what would be drawn without smaller triangles."""
        return gathered(self.factors, self.patch_mesh, self.B)

    def final_gather(self, size: int = 256, view: Viewpoint = 0, progress: Progress | None = None) -> Image.Image:
        """Return a sheet of what meshes lose: constant patches, linear ones, the drawn mesh, a gather at every pixel.

        The last is the reference picture, below the others is how far they are from it.  ``size`` x ``size`` pixels of
        the Cornell box take as many gathers: some seconds for 128, a minute for 512.
        """
        from glsim.radiosity.pixels import losses

        return losses(self, size, self.view(view), progress or silent)

    def view(self, which: Viewpoint) -> View:
        """Return a camera of the scene by its number or name, or one around it.  Raises SceneError if there is none."""
        if isinstance(which, View):
            return which
        if isinstance(which, Camera):
            return view_around(self.patches.scene, which)
        if which == 0 and not self.patches.scene.views:
            return self._automatic_view
        return named(self.patches.scene, which)

    @cached_property
    def _automatic_view(self) -> View:
        """The camera of a scene that has none."""
        return automatic(self)

    def row_picture(self, patch: int, size: int = 512, view: Viewpoint = 0) -> Image.Image:
        """Draw row ``patch`` of the form factors on the scene: how much of its light arrives, per unit of area.

        size: pixels of the scene, beside which the scale stands.  The patch itself is orange; the brightest 5 % of the
        vertices are white.  Raises SceneError if there is no such patch.
        """
        from glsim.radiosity.plots import on_scene

        if not 0 <= patch < len(self.patches):
            raise SceneError(f"patches are numbered from 0 to {len(self.patches) - 1}; there is no {patch}")
        mesh = self.patch_mesh
        row = self.factors.row(patch) / self.patches.area
        values = np.zeros(len(mesh.vertices))
        weight = np.zeros(len(mesh.vertices))
        for corner in range(3):
            np.add.at(values, mesh.triangles[:, corner], row[mesh.triangle_patch])
            np.add.at(weight, mesh.triangles[:, corner], 1.0)
        values /= np.maximum(weight, 1.0)
        bright = max(float(np.quantile(values[values > 0.0], 0.95)), 1e-300) if values.any() else 1.0
        shown = np.repeat(np.minimum(values / bright, 1.0)[:, None] ** (1.0 / GAMMA), 3, axis=1)
        corners = np.unique(mesh.triangles[mesh.triangle_patch == patch])
        shown[corners] = (1.0, 0.5, 0.0)
        return on_scene(replace(self, mesh=mesh).picture(size, view, colors=shown), patch, bright)

    def convergence_picture(self) -> Image.Image:
        """Draw the residual over the iterations."""
        from glsim.radiosity.plots import convergence

        return convergence({self.solver: self.steps})

    def matrix_picture(self, size: int = 640) -> Image.Image:
        """Draw the matrix of form factors, logarithmically.  Raises SceneError if there is none (hierarchical)."""
        from glsim.radiosity.plots import matrix

        if self.factors.matrix is None:
            raise SceneError(f"{self.factors.method} form factors are no matrix that could be shown")
        return matrix(np.asarray(self.factors.matrix / self.patches.area[:, None], np.float64), size)

    def steps_picture(self, solver: str | None = None, size: int = 256, view: Viewpoint = 0) -> Image.Image:
        """Draw the scene after 0, 1, 2, ... iterations of a solver (by default its own), see watch.watched."""
        from glsim.radiosity.watch import strip

        return strip(self, solver, size, view)

    def __repr__(self) -> str:
        name, n, last = self.patches.scene.name, len(self.patches), self.steps[-1]
        solved = f"{self.solver}, {last.iteration} iterations, residual {last.residual:.2g}"
        return f"<Radiosity of {name}: {n} patches, {self.factors.method}, {solved}>"

    def _repr_png_(self) -> bytes | None:
        return self.picture()._repr_png_()

    def _repr_html_(self) -> str:
        """Return HTML for a notebook: the picture, and the report as a table."""
        shown = b64encode(self._repr_png_() or b"").decode()
        lines = [(escape(name), escape(text)) for name, text in summary(self.report())]
        rows = "".join(f"<tr><td>{name}</td><td>{text}</td></tr>" for name, text in lines)
        picture = f'<img src="data:image/png;base64,{shown}" alt="{escape(self.patches.scene.name)}">'
        return f"{picture}<table>{rows}</table>"

    # ------------------------------------------------------------ files

    def save(self, path: str | os.PathLike[str], *, size: int = 512, view: Viewpoint = 0) -> None:
        """Write .png (or another picture), .glb or .ply with vertex colours, or .npz with everything.

        Raises SceneError for another ending.
        """
        ending = Path(path).suffix.lower()
        if ending == ".npz":
            write_atomically(path, lambda name: np.savez_compressed(name, **self.arrays()))
        elif ending in (".glb", ".ply"):
            data = self._exported(ending[1:])
            write_atomically(path, lambda name: Path(name).write_bytes(data))
        else:
            from PIL import Image

            if ending not in Image.registered_extensions():
                raise SceneError(f"{path}: the name must end in .png, .glb, .ply or .npz")
            image = self.picture(size, view)
            write_atomically(path, lambda name: image.save(name))

    def arrays(self) -> dict[str, Any]:
        """Return what an .npz holds.

        triangles (m, 3, 3), triangle_patch (m,); B, E, rho, normal (n, 3), area (n,) of the patches; vertices and
        vertex_B (V, 3), vertex_triangles (m, 3).
        """
        p, mesh = self.patches, self.mesh
        return {
            "triangles": mesh.vertices[mesh.triangles], "triangle_patch": mesh.triangle_patch, "B": self.B, "E": p.E,
            "rho": p.rho, "area": p.area, "normal": p.normal, "vertices": mesh.vertices,
            "vertex_B": self.vertex_radiosity, "vertex_triangles": mesh.triangles,
        }  # fmt: skip

    def _exported(self, kind: str) -> bytes:
        """Return a .glb or .ply (``kind``) with vertex colours."""
        import trimesh

        colors = np.round(self.colors() * 255.0).astype(np.uint8)
        alpha = np.full((len(colors), 1), 255, np.uint8)
        shown = np.concatenate([colors, alpha], axis=1)
        mesh = trimesh.Trimesh(self.mesh.vertices, self.mesh.triangles, vertex_colors=shown, process=False)
        data: Any = mesh.export(file_type=kind)
        return bytes(data)


def _noticed(patches: Patches, sums: Float, leak: float) -> list[str]:
    """Return notes on faults of the scene; sums: (n,), of the rows; leak: the share of light that escapes."""
    lamps = patches.E.max(axis=1) > 0.0
    if sums.max() < BLIND:
        return ["no patch sees another, so nothing is lit: a room whose normals are inverted? --flip turns them"]
    notes = []
    if float(sums[lamps].max(initial=0.0)) < BLIND:
        notes.append("what emits sees nothing, so nothing is lit: do its fronts look away?")
    if leak > OPEN:
        notes.append(f"the scene is open: {100.0 * leak:.1f} % of what leaves its surfaces escapes")
    elif (poor := int((sums < 0.9).sum())) > 0:
        notes.append(f"patches of which a part is inside of bodies, so that their rows do not sum to 1: {poor}")
    return notes


def summary(report: dict[str, Any]) -> list[tuple[str, str]]:
    """Return a report as names and sentences."""
    mean, most, leak = (100.0 * report[name] for name in ("row_sum_error_mean", "row_sum_error_max", "leak"))
    sums = f"rows sum to 1 within {mean:.4f} % in the mean, {most:.2f} % at most; {max(leak, 0.0):.3f} % escapes"
    solved = f"{report['iterations']} iterations, residual {report['residual']:.2g}"
    return [
        ("patches", f"{report['n']}, drawn as {report['triangles']} triangles"),
        ("form factors", f"{report['method']}; {sums}; reciprocal within {report['reciprocity']:.1g}"),
        ("system", f"{report['solver']}, {solved}, energy balance {report['energy_balance']:.6f}"),
        ("seconds", ", ".join(f"{stage} {value:.2f}" for stage, value in report["seconds"].items())),
        *(("note", note) for note in report["notes"]),
    ]
