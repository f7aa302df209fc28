# %% [markdown]
# # 26. Realistic light sources
#
# A point light is a mathematician's lamp. The sun, a tube, a window have an area, and an area makes what a point
# cannot: shadows that begin sharp at the foot of an object and dissolve with the distance, and highlights in the
# shape of the lamp. OpenGL has no area lights. But light adds up, and so do pictures.

# %% [markdown]
# ## Predict
#
# One lamp of side 1.6 is replaced by a grid of point lights, each with its share of the power. How many points does it
# take until the shadow of a torus looks soft, without steps?
#
# - 4: one for each corner of the lamp
# - about 16
# - more than 50

# %% The shadow of a torus under 1, 4, 16 and 64 point lights that share one square of side 1.6
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidTorus


def torus():
    glPushMatrix()
    glTranslatef(0, 0.75, 0)
    glRotatef(-62, 1, 0.25, 0)
    glCallList(TORUS)
    glPopMatrix()


def floor():
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-9, 9), (9, 9), (9, -9), (-9, -9)):
        glVertex3f(x, 0, z)
    glEnd()


def flattened(lamp):
    """The matrix that projects from a point of the lamp onto the floor, y = 0."""
    x, y, z = lamp
    M = np.array([[y, -x, 0, 0], [0, 0, 0, 0], [0, -z, y, 0], [0, -1, 0, y]], float)
    glMultMatrixf(M.T)


def scene(lamp):
    """Floor, shadow and torus under one point light."""
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLightfv(GL_LIGHT0, GL_POSITION, [*lamp, 1])
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [0.75, 0.75, 0.7, 1])
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, [0, 0, 0, 1])
    floor()
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glDisable(GL_LIGHTING)
    glColor3f(0.02, 0.02, 0.025)
    glEnable(GL_POLYGON_OFFSET_FILL)
    glPolygonOffset(-1, -4)
    glPushMatrix()
    flattened(lamp)
    torus()
    glPopMatrix()
    glPopAttrib()
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [0.8, 0.3, 0.12, 1])
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
    torus()


screen = glsim.offscreen(880, 240, samples=4)
TORUS = glGenLists(1)
glNewList(TORUS, GL_COMPILE)
glutSolidTorus(0.2, 0.6, 24, 48)
glEndList()
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.06, 0.06, 0.07, 1])
glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40)
glClearColor(0.1, 0.11, 0.13, 1)


def camera():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(30, 220 / 240, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 5.2, 5.0, -0.1, 0.35, 0, 0, 1, 0)


def lamps(count, side=1.6):
    """A grid of count x count points of a square lamp above the scene."""
    steps = (np.arange(count) + 0.5) / count - 0.5
    return [(0.5 + side * u, 4.0, 0.3 + side * v) for u in steps for v in steps]


glEnable(GL_SCISSOR_TEST)
for column, count in enumerate((1, 2, 4, 8)):
    glViewport(220 * column, 0, 220, 240)
    glScissor(220 * column, 0, 220, 240)
    camera()
    points = lamps(count)
    for k, lamp in enumerate(points):
        scene(lamp)
        glAccum(GL_ACCUM if k else GL_LOAD, 1 / len(points))
    glAccum(GL_RETURN, 1)
screen

# %% [markdown]
# ## What you should see
#
# One point: a shadow cut out of paper. Four: four shadows, laid over each other. Sixteen: the steps can still be
# counted. With 64 the border is smooth, a **soft shadow**, and the shadow is darkest in the middle, where no point of the lamp is seen.
# The highlights on the torus spread in the same way: each point light makes its own.

# %% [markdown]
# ## The formula
#
# The light of a lamp with the area $A$ is the sum over its points, and an integral in the limit:
#
# $$ I = \int_A I_L(\mathbf{y})\, V(\mathbf{x}, \mathbf{y})\, f(\mathbf{N}, \mathbf{L}, \mathbf{V})\, d\mathbf{y}
# \;\approx\; \frac{1}{m} \sum_{k=1}^{m} I_L\, V(\mathbf{x}, \mathbf{y}_k)\, f(\mathbf{N}, \mathbf{L}_k, \mathbf{V}) $$
#
# $\mathbf{y}_k$ are $m$ points of the lamp, $\mathbf{L}_k$ the unit vectors towards them, $V$ is 1 where the lamp's point
# is seen and 0 in its shadow, $f$ is the illumination equation. It is **superposition** again: the sum over many lights
# is a sum over pictures, and the accumulation buffer adds pictures. OpenGL's own sum over lights is this loop:

# %%
glsim.source("shaders/light.glsl", "for (int i = 0; i < LIGHTS; i++) {")

# %% The same lamp, larger and larger: side 0.2, 1, 2 and 4, each of 64 points
for column, side in enumerate((0.2, 1, 2, 4)):
    glViewport(220 * column, 0, 220, 240)
    glScissor(220 * column, 0, 220, 240)
    camera()
    points = lamps(8, side)
    for k, lamp in enumerate(points):
        scene(lamp)
        glAccum(GL_ACCUM if k else GL_LOAD, 1 / len(points))
    glAccum(GL_RETURN, 1)
screen

# %% [markdown]
# Near the floor a shadow stays sharp, far from it it dissolves: look at the side of the torus that nearly touches the
# ground, and at the side that is up in the air.
#
# > **The slide says** only that realistic light sources are ignored. They can be had in OpenGL at the price of one
# > picture for each point of the lamp; radiosity has them for nothing, because there every patch is a lamp.
#
# ## Try this
#
# 1. Put the points at random places of the square, `np.random.default_rng(1).random((64, 2))`, instead of a grid.
#    What becomes of the steps?
# 2. Make the lamp a line: `4.0` stays, `v` is always 0. Which shadows stay sharp, and why those?
# 3. Replace `1 / len(points)` by `1`. What went wrong, and where does the picture show it first?
#
# ## Questions
#
# Why does one divide the light by the number of points, and not the picture by itself at the end?
#
# <details><summary>Answer</summary>
#
# It would be the same, if sums could grow beyond 1. A picture clamps at 1, so each summand must carry its share before
# it is added. (The accumulation buffer has a range of $[-1, 1]$.)
#
# </details>
#
# ## Exercise
#
# Exercise 22 (lesson 26): an area light by many lights.
