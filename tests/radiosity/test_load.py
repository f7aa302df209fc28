"""Scenes from mesh files and programs."""

from __future__ import annotations

from pathlib import Path

import pytest

from glsim import radiosity
from glsim.radiosity.load import scene_from
from glsim.radiosity.scene import Material, SceneError


def test_a_mesh_file(tmp_path: Path) -> None:
    import trimesh

    room_ = trimesh.creation.box((4, 3, 5))
    room_.invert()
    room_.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(name="wall", baseColorFactor=[0.5, 0.5, 0.5, 1.0])
    )
    lamp = trimesh.creation.icosphere(subdivisions=1, radius=0.4)
    lamp.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(name="lamp", emissiveFactor=[1.0, 1.0, 1.0])
    )
    trimesh.Scene([room_, lamp]).export(tmp_path / "room.glb")
    scene = scene_from(tmp_path / "room.glb")
    assert {material.name for material in scene.materials} == {"wall", "lamp"}
    found = radiosity.solve(tmp_path / "room.glb", 300)
    assert found.report()["row_sum_error_mean"] < 0.01
    brighter = scene_from(tmp_path / "room.glb", {"lamp": Material("lamp", (0.0,) * 3, (5.0, 5.0, 5.0))})
    assert max(material.E[0] for material in brighter.materials) == 5.0
    with pytest.raises(SceneError, match="no material named sky"):
        scene_from(tmp_path / "room.glb", {"sky": Material("sky", (0.0,) * 3)})


def test_a_program(tmp_path: Path) -> None:
    (tmp_path / "program.py").write_text("""
from OpenGL.GL import *
from OpenGL.GLUT import *
def wall(emission, *corners):
    glMaterialfv(GL_FRONT, GL_EMISSION, [emission] * 3 + [1])
    glBegin(GL_QUADS)
    for corner in corners:
        glVertex3f(*corner)
    glEnd()
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glTranslatef(0, 0, -3)
    wall(1.0, (-1, 1, -1), (1, 1, -1), (1, 1, 1), (-1, 1, 1))
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.8, 0.2, 0.2, 1])
    wall(0.0, (-1, -1, 1), (1, -1, 1), (1, -1, -1), (-1, -1, -1))
    glutSwapBuffers()
glutInit()
glutInitDisplayMode(GLUT_DOUBLE)
glutCreateWindow("t")
glEnable(GL_LIGHTING)
glutDisplayFunc(display)
glutMainLoop()
""")
    found = radiosity.solve(tmp_path / "program.py", 60)
    floor = found.patches.E.max(axis=1) == 0.0
    red = found.B[floor].mean(axis=0)
    assert red[0] == pytest.approx(4 * red[1], rel=0.05)
    assert 0.1 < red[0] < 0.2  # about 0.2 of the light arrives, 0.8 of its red leaves
