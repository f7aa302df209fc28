"""The final gather at every pixel, and what meshes lose against it."""

from __future__ import annotations

import numpy as np
import pytest

from glsim import radiosity
from glsim.radiosity.pixels import gathered_pixels, pixels_of
from glsim.radiosity.scene import View


@pytest.fixture(scope="module")
def box() -> radiosity.Radiosity:
    return radiosity.solve("cornell", 250)


def test_rays_see_what_opengl_draws(box: radiosity.Radiosity) -> None:
    """Also through the backs of walls, from a camera outside of the box."""
    for view in (box.view(0), View((900.0, 700.0, -500.0), (278.0, 273.0, 280.0), fov=60.0)):
        seen = pixels_of(box.mesh, view, 96, box.patches.scene.size)
        image = np.zeros((96 * 96, 3))
        image[seen.seen] = seen.between(box.mesh, box.colors())
        drawn = np.asarray(box.picture(96, view, samples=0))[..., :3] / 255.0
        assert (np.abs(image.reshape(drawn.shape) - drawn).max(axis=2) < 0.02).mean() > 0.995


def test_finer_meshes_lose_less(box: radiosity.Radiosity) -> None:
    pixels = pixels_of(box.mesh, box.view(0), 48, box.patches.scene.size)
    true = gathered_pixels(box, pixels)
    patch = box.mesh.triangle_patch[pixels.triangle[pixels.seen]]
    dark = box.patches.E[patch].max(axis=1) == 0.0

    def rms(B: np.ndarray) -> float:
        return float(np.sqrt(((B - true)[dark] ** 2).sum() / (true[dark] ** 2).sum()))

    coarse = pixels_of(box.patch_mesh, box.view(0), 48, box.patches.scene.size)
    assert (coarse.seen == pixels.seen).all()
    constant, corners = rms(box.B[patch]), rms(coarse.between(box.patch_mesh, box.corner_radiosity))
    drawn = rms(pixels.between(box.mesh, box.vertex_radiosity))
    assert drawn < 0.03 < corners < constant
    assert 3.0 * drawn < corners


def test_the_sheet(box: radiosity.Radiosity) -> None:
    sheet = box.final_gather(24)
    assert sheet.size[0] > 4 * 200
    assert len(np.unique(np.asarray(sheet).reshape(-1, 3), axis=0)) > 300
