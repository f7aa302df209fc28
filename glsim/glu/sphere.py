"""Quadrics: spheres."""

from __future__ import annotations

import math

import numpy as np

from glsim import gl
from glsim.glu.quadric import FILL, FLAT, OUTSIDE, POINT, SMOOTH, Quadric, circle, float32, rings_of


class Sphere:
    """The vertices of a sphere and their normals; i: slice, j: stack from the pole at +z."""

    def __init__(self, quad: Quadric, radius: float, slices: int, stacks: int) -> None:
        self.quad, self.slices, self.stacks = quad, slices, stacks
        self.sines, self.cosines = circle(slices)
        polar = np.float32(math.pi * np.arange(stacks + 1) / stacks).astype(np.float64)
        self.ring, self.axis = float32(np.sin(polar)), float32(np.cos(polar))
        radii = (radius * np.sin(polar)).astype(np.float32)
        radii[[0, stacks]] = 0.0  # it comes to a point at both ends
        self.x, self.y = rings_of(radii, self.sines, self.cosines)
        self.z = float32(np.float32(radius * np.cos(polar)))
        self.flat_sines, self.flat_cosines = circle(slices, -0.5)
        between = np.float32(math.pi * (np.arange(stacks + 1) - 0.5) / stacks).astype(np.float64)
        self.flat_ring, self.flat_axis = float32(np.sin(between)), float32(np.cos(between))

    def smooth(self, i: int, j: int) -> None:
        """The normal of a vertex."""
        side, ring = self.quad.side, self.ring[j]
        if self.quad.normals == SMOOTH:
            gl.glNormal3f(side * self.sines[i] * ring, side * self.cosines[i] * ring, side * self.axis[j])

    def flat(self, i: int, j: int) -> None:
        """With GLU_FLAT: the normal of the face between slices i - 1 and i and stacks j - 1 and j."""
        side, ring = self.quad.side, self.flat_ring[j]
        if self.quad.normals == FLAT:
            gl.glNormal3f(
                side * self.flat_sines[i] * ring, side * self.flat_cosines[i] * ring, side * self.flat_axis[j]
            )

    def vertex(self, i: int, j: int) -> None:
        if self.quad.texture:
            gl.glTexCoord2f(1.0 - i / self.slices, 1.0 - j / self.stacks)
        gl.glVertex3f(self.x[j][i], self.y[j][i], self.z[j])

    def fan(self, pole: int, j: int) -> None:
        """The triangles between a pole and the ring beside it."""
        backwards = (self.quad.orientation == OUTSIDE) == (pole == 0)
        gl.glBegin(gl.GL_TRIANGLE_FAN)
        self.smooth(0, pole)
        gl.glVertex3f(0.0, 0.0, self.z[pole])
        for i in range(self.slices, -1, -1) if backwards else range(self.slices + 1):
            if not backwards or i < self.slices:
                self.flat(i + backwards, max(j, pole))
            self.smooth(i, j)
            self.vertex(i, j)
        gl.glEnd()

    def strip(self, j: int) -> None:
        """The faces between two rings."""
        first, second = (j + 1, j) if self.quad.orientation == OUTSIDE else (j, j + 1)
        gl.glBegin(gl.GL_QUAD_STRIP)
        for i in range(self.slices + 1):
            self.smooth(i, first)
            self.vertex(i, first)
            self.flat(i, j + 1)
            self.smooth(i, second)
            self.vertex(i, second)
        gl.glEnd()

    def points(self) -> None:
        gl.glBegin(gl.GL_POINTS)
        for j in range(self.stacks + 1):
            for i in range(self.slices):
                around, along = self.quad.side * self.ring[j], self.quad.side * self.axis[j]
                self.quad.normal(self.sines[i] * around, self.cosines[i] * around, along)
                self.vertex(i, j)
        gl.glEnd()

    def lines(self) -> None:
        """Rings, and arcs from pole to pole."""
        side = self.quad.side
        for j in range(1, self.stacks):
            gl.glBegin(gl.GL_LINE_STRIP)
            for i in range(self.slices + 1):
                if self.quad.normals == FLAT:
                    x, y = self.flat_sines[i] * self.ring[j], self.flat_cosines[i] * self.ring[j]
                    gl.glNormal3f(side * x, side * y, side * self.axis[j])
                self.smooth(i, j)
                self.vertex(i, j)
            gl.glEnd()
        for i in range(self.slices):
            gl.glBegin(gl.GL_LINE_STRIP)
            for j in range(self.stacks + 1):
                if self.quad.normals == FLAT:
                    x, y = self.sines[i] * self.flat_ring[j], self.cosines[i] * self.flat_ring[j]
                    gl.glNormal3f(side * x, side * y, side * self.flat_axis[j])
                self.smooth(i, j)
                self.vertex(i, j)
            gl.glEnd()


def gluSphere(quad: Quadric, radius: float, slices: int, stacks: int) -> None:
    """Draw a sphere around the origin whose poles lie on the z axis.

    radius: in object coordinates.  slices: pieces around the z axis (of longitude); stacks: along it (of latitude).
    """
    slices, stacks = int(slices), int(stacks)
    if slices < 2 or stacks < 1 or radius < 0:
        quad.fail("gluSphere", "needs at least 2 slices, 1 stack and a radius of at least 0")
        return
    if quad.too_many("gluSphere", slices, stacks):
        return
    sphere = Sphere(quad, radius, slices, stacks)
    if quad.style == POINT:
        sphere.points()
    elif quad.style != FILL:
        sphere.lines()
    else:
        first, last = 0, stacks
        if not quad.texture:  # fans around the poles; with texture the strips go on to them
            first, last = 1, stacks - 1
            sphere.fan(0, 1)
            sphere.fan(stacks, stacks - 1)
        for j in range(first, last):
            sphere.strip(j)
