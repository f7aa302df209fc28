# %% [markdown]
# # 21. Where normals come from
#
# A file with a mesh often holds points and triangles, and no normals. Each triangle knows its own. But smooth shading
# wants one at each *vertex*, where five triangles meet, with five opinions. One takes the mean. The question is which.

# %% [markdown]
# ## Predict
#
# A box is drawn from six quads; its corners get the mean of the normals of the faces that meet there, and Gouraud shading
# does the rest. How does it look?
#
# - like a box
# - like a box with soft, pillow-like shading, bright and dark flowing over its edges
# - like a sphere

# %% A box with normals of its faces, and with the mean of the faces' normals at its corners
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective

CORNERS = np.array(
    [(x, y, z) for x in (-1, 1) for y in (-0.6, 0.6) for z in (-1, 1)], float
)
FACES = [
    (0, 1, 3, 2),
    (4, 6, 7, 5),
    (0, 4, 5, 1),
    (2, 3, 7, 6),
    (0, 2, 6, 4),
    (1, 5, 7, 3),
]


def face_normal(face):
    """The cross product of two edges, at a right angle to the face."""
    a, b, c = CORNERS[list(face)[:3]]
    return np.cross(b - a, c - a)


def unit(v):
    return v / np.linalg.norm(v)


def draw(normal_of):
    glBegin(GL_QUADS)
    for face in FACES:
        for corner in face:
            glNormal3fv(normal_of(face, corner))
            glVertex3fv(CORNERS[corner])
    glEnd()


def own(face, corner):
    return unit(face_normal(face))


def mean(face, corner):
    return unit(sum(unit(face_normal(f)) for f in FACES if corner in f))


screen = glsim.offscreen(760, 320, samples=4)
glClearColor(0.12, 0.13, 0.16, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.5, 0.65, 0.85, 1])
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 380 / 320, 1, 20)
glMatrixMode(GL_MODELVIEW)
gluLookAt(3, 2.4, 4.4, 0, 0, 0, 0, 1, 0)
glLightfv(GL_LIGHT0, GL_POSITION, [1, 3, 2, 0])
for column, normal_of in enumerate((own, mean)):
    glViewport(380 * column, 0, 380, 320)
    draw(normal_of)
screen

# %% [markdown]
# ## What you should see
#
# On the right the box has become a pillow. The mean makes the surface look round where it meets others, which is what one
# wants on a sphere and does not want on a box. A vertex of a real edge needs *several* normals, one for each face.

# %% [markdown]
# ## The formula
#
# The normal of a triangle with the corners $a, b, c$ is the cross product of two edges, and its length is twice the
# triangle's area. At a vertex the normals $\mathbf{n}_k$ of its faces are averaged with weights:
#
# $$ \mathbf{N} = \frac{\sum_k w_k \mathbf{n}_k}{\left| \sum_k w_k \mathbf{n}_k \right|}, \qquad w_k = 1 \;\text{ or the area}\; A_k \;\text{ or
# the angle}\; \alpha_k $$
#
# $\mathbf{n}_k$ are unit vectors, $A_k$ is the area of the face, $\alpha_k$ its angle at this vertex (radians). Weighting by
# **area** is the cheapest: one adds the cross products as they are. Weighting by **angle** does not depend on how flat
# regions are cut into triangles.

# %%
glsim.source("scenes/mesh.py", "angles = np.arccos(", lines=3)


# %% The corner of a box whose top is cut into many triangles there: the three means, and the true direction (1, 1, 1)
def corner_normal(weight, slices=8):
    """The mean at a corner of a cube whose top is a fan of thin triangles around it."""
    total = np.zeros(3)
    for n in (
        (1, 0, 0),
        (0, 0, 1),
    ):  # the two sides: one triangle each, with 90 degrees
        total += weight(0.5, np.pi / 2) * np.array(n, float)
    for _ in range(slices):
        angle = np.pi / 2 / slices
        total += weight(0.5 * np.sin(angle), angle) * np.array((0.0, 1.0, 0.0))
    return unit(total)


ways = {"all alike": lambda area, angle: 1, "by area": lambda area, angle: area,
        "by angle": lambda area, angle: angle}  # fmt: skip
for name, weight in ways.items():
    N = corner_normal(weight)
    off = np.degrees(np.arccos(np.clip(N @ unit(np.ones(3)), -1, 1)))
    print(f"{name:10} {N.round(3)}   off by {off:4.1f} degrees")

# %% [markdown]
# Only the angle does not care into how many triangles the top was cut. (Thürmer and Wüthrich, 1998.)
#
# A mesh that has both smooth and sharp places needs a **crease angle**: faces whose normals differ by less are averaged,
# across larger angles each side keeps its own normal. Here it is on a cylinder:

# %% A cylinder: crease angle 0 (all edges hard), 40 degrees, and 180 (all smooth, with a wrong rim)
SIDES = 16
RIM = [(np.cos(t), np.sin(t)) for t in np.linspace(0, 2 * np.pi, SIDES, endpoint=False)]


def cylinder(crease):
    """Faces of a cylinder with normals that are averaged up to the crease angle."""
    points = np.array([(x, h, -z) for h in (-0.7, 0.7) for x, z in RIM])
    sides = [
        (k, (k + 1) % SIDES, SIDES + (k + 1) % SIDES, SIDES + k) for k in range(SIDES)
    ]
    faces = [*sides, tuple(range(SIDES, 2 * SIDES)), tuple(range(SIDES - 1, -1, -1))]
    normals = [
        unit(np.cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[1]]))
        for f in faces
    ]
    limit = np.cos(np.radians(crease)) - 1e-9
    for face, n in zip(faces, normals):
        glBegin(GL_POLYGON)
        for corner in face:
            around = [m for f, m in zip(faces, normals) if corner in f]
            near = [m for m in around if m @ n > limit]
            glNormal3fv(unit(np.sum(near, axis=0)))
            glVertex3fv(points[corner])
        glEnd()


screen = glsim.offscreen(840, 280, samples=4)
glClearColor(0.12, 0.13, 0.16, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.85, 0.6, 0.3, 1])
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
gluLookAt(1.5, 2.6, 4.2, 0, 0, 0, 0, 1, 0)
glLightfv(GL_LIGHT0, GL_POSITION, [-2, 3, 3, 0])
for column, crease in enumerate((0, 40, 180)):
    glViewport(280 * column, 0, 280, 280)
    cylinder(crease)
screen

# %% [markdown]
# ## Try this
#
# 1. Leave `unit` out of `mean`: the faces' normals then count by their area. Which face of the box wins?
# 2. Cylinder with `SIDES = 6` and the crease 40: it is flat. From which angle on is it smooth, and why that one?
# 3. Reverse the corners of one face. What does its normal do to its neighbours?
#
# ## Questions
#
# Why do modelling programs write *several* normals for one point into a file?
#
# <details><summary>Answer</summary>
#
# A hard edge needs one for each side of it, and OpenGL takes the normal that is current when the vertex comes. In an
# indexed mesh such a point becomes several vertices, with one position and different normals.
#
# </details>
#
# ## Exercise
#
# Exercise 17: vertex normals by area, by angle, and with a crease.
