"""glsim.outside: eye, frustum, surfaces and lights are where the matrices put them."""

from __future__ import annotations

import numpy as np
import pytest

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.study.world import view_of, world_of


def frame_of(projection: str = "perspective", far: float = 9.0, lit: bool = True) -> glsim.Frame:
    """A square of 2 x 2 in the plane z = 0, seen from (0, 0, 5)."""

    def draw() -> None:
        glMatrixMode(GL_PROJECTION)
        if projection == "perspective":
            gluPerspective(60.0, 1.0, 1.0, far)
        else:
            glOrtho(-2.0, 2.0, -1.0, 3.0, 1.0, far)
        glMatrixMode(GL_MODELVIEW)
        gluLookAt(0, 0, 5, 0, 0, 0, 0, 1, 0)
        if lit:
            glEnable(GL_LIGHTING)
            glEnable(GL_LIGHT2)
            glLightfv(GL_LIGHT2, GL_POSITION, [0.0, 1.0, 2.0, 1.0])
        glColor3f(0.0, 1.0, 0.0)
        glEnable(GL_COLOR_MATERIAL)
        glNormal3f(0, 0, 1)
        glRectf(-1, -1, 1, 1)

    return glsim.frame_of(draw, size=96)


def test_corners_of_the_frustum() -> None:
    world = world_of(frame_of())
    t = np.tan(np.radians(30.0))
    expected = [(x * z * t, y * z * t, -z) for z in (1.0, 9.0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    np.testing.assert_allclose(world.corners, expected, rtol=1e-5)
    np.testing.assert_allclose(world.eye, 0.0)
    box = world_of(frame_of("parallel"))
    np.testing.assert_allclose(box.corners[0], (-2.0, -1.0, -1.0), rtol=1e-5)
    np.testing.assert_allclose(box.corners[6], (2.0, 3.0, -9.0), rtol=1e-5)
    assert not box.perspective


def test_surfaces_and_lights_are_in_eye_space() -> None:
    world = world_of(frame_of())
    np.testing.assert_allclose(world.low, (-1, -1, -5), atol=1e-5)
    np.testing.assert_allclose(world.high, (1, 1, -5), atol=1e-5)
    assert list(world.lights) == [2]
    np.testing.assert_allclose(world.lights[2].position, (0, 1, -3, 1), atol=1e-5)
    assert not world_of(frame_of(lit=False)).lights


def test_the_picture_plane_lies_on_the_rays_of_the_frustum() -> None:
    world = world_of(frame_of())
    for corner, near in zip(world.plane, world.corners, strict=False):
        np.testing.assert_allclose(np.cross(corner, near), 0.0, atol=1e-6)
    assert world.high[2] < world.plane[0, 2] < -1.0


@pytest.mark.parametrize(("azimuth", "elevation"), [(90.0, 0.0), (30.0, 40.0), (-60.0, 10.0), (180.0, 20.0)])
def test_what_gl_draws_is_where_the_view_says(azimuth: float, elevation: float) -> None:
    """The square's corners inside and outside, in the picture that the gl commands draw."""
    frame = frame_of(lit=False)
    options = dict(azimuth=azimuth, elevation=elevation, image=False, axes=False, labels=False)
    image = np.asarray(glsim.outside(frame, width=600, height=400, **options)).astype(int)
    world = world_of(frame)
    view = view_of(world, (600, 400), azimuth, elevation)
    green = (image[..., 1] - image[..., 0] > 100) & (image[..., 1] - image[..., 2] > 100)
    places = np.array([view.at((x, y, -5.0)) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
    if azimuth == 90.0:  # seen from the edge: nothing of it
        assert np.ptp(places[:, 0]) < 3.0
        return
    ys, xs = np.nonzero(green)
    for drawn, place in ((xs, places[:, 0]), (ys, places[:, 1])):
        assert abs(drawn.min() - place.min()) < 2.0
        assert abs(drawn.max() - place.max()) < 2.0
    inside = [np.array(view.at((x, y, -5.0))).round().astype(int) for x in (-0.7, 0.6) for y in (-0.8, 0.5)]
    assert all(green[y, x] for x, y in inside)


def test_all_that_is_shown_has_room() -> None:
    for frame in (frame_of(), frame_of("parallel"), frame_of(far=1000.0)):
        world = world_of(frame)
        view = view_of(world, (600, 400), None, None)
        points = [world.eye, *world.corners[:4], *(world.corners[4:] if world.far_shown else [])]
        for x, y in map(view.at, points):
            assert 0.0 <= x <= 600.0
            assert 0.0 <= y <= 400.0
    assert not world_of(frame_of(far=1000.0)).far_shown


def test_what_cannot_be_shown_is_said_in_a_sentence() -> None:
    def flat() -> None:
        glMatrixMode(GL_PROJECTION)
        glScalef(1, 1, 0)
        glRectf(-1, -1, 1, 1)

    with pytest.raises(ValueError, match="projection matrix has no inverse"):
        glsim.outside(glsim.frame_of(flat, size=32))

    def clear() -> None:
        glClear(GL_COLOR_BUFFER_BIT)

    with pytest.raises(ValueError, match="nothing"):
        glsim.outside(glsim.frame_of(clear, size=32))
