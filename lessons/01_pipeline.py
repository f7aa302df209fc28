# %% [markdown]
# # 1. The pipeline, a reminder
#
# A vertex is three numbers. A picture is a million pixels. Between them stands a short row of steps that every vertex
# takes, one after the other, and that fit into three lines of code: where is the object, where is the eye, where is the
# picture?

# %% [markdown]
# ## Predict
#
# You move the camera one unit to the *right*. On the screen the teapot moves ...
#
# - to the right: it follows the camera
# - to the left: the camera's move is the world's move backwards
# - not at all: only the background moves

# %% The same teapot, from the middle and with the eye one unit further to the right
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective, gluProject
from glsim.glut import glutSolidTeapot


def begin(width, height):
    screen = glsim.offscreen(width, height, samples=4)
    glClearColor(0.12, 0.13, 0.16, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    return screen


def draw(right=0.0):
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, [0.75, 0.45, 0.15, 1])
    glMatrixMode(
        GL_PROJECTION
    )  # which part of the world: a pyramid in front of the eye
    glLoadIdentity()
    gluPerspective(40, 1, 1, 12)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(right, 1.5, 6.5, right, 0, 0, 0, 1, 0)  # where is the eye
    glLightfv(GL_LIGHT0, GL_POSITION, [-2, 3, 4, 1])  # the lamp stands in the world
    glRotatef(20, 0, 1, 0)  # where is the object
    glutSolidTeapot(1)


screen = begin(640, 320)
for column, right in enumerate((0, 1)):
    glViewport(320 * column, 0, 320, 320)
    draw(right)
screen

# %% [markdown]
# ## What you should see
#
# It moves to the left. There is no camera in OpenGL: the eye sits at the origin, for ever, and looks along $-z$.
# `gluLookAt` moves the *world*, in the opposite direction. Both is the same thing, as every passenger of a train knows.

# %% [markdown]
# ## The formula
#
# A vertex $\mathbf{v} = (x, y, z, 1)$ is multiplied by two matrices, divided by its fourth number, and stretched to pixels:
#
# $$ \mathbf{v}_\mathrm{clip} = P\, M\, \mathbf{v}, \qquad (x, y, z)_\mathrm{ndc} = \frac{(x, y, z)_\mathrm{clip}}{w_\mathrm{clip}}, \qquad
# x_\mathrm{window} = \frac{w}{2}\,(x_\mathrm{ndc} + 1) + x_0 $$
#
# $M$ is the **modelview** matrix (object and eye), $P$ the **projection** matrix; both are 4 x 4. Normalised device
# coordinates lie in $[-1, 1]$; the **viewport** $(x_0, y_0, w, h)$ in pixels stretches them over the window. $y$ and the
# depth go the same way.

# %%
glsim.source("shaders/main.vert", "vec4 E = transform.modelview", lines=2)

# %% The way of one vertex in numbers, from the object to the window
v = np.array([1.0, 0.5, 0.0, 1.0])
M = np.array(glGetFloatv(GL_MODELVIEW_MATRIX)).T
P = np.array(glGetFloatv(GL_PROJECTION_MATRIX)).T
eye = M @ v
clip = P @ eye
ndc = clip[:3] / clip[3]
x, y, width, height = glGetIntegerv(GL_VIEWPORT)
window = x + width * (ndc[0] + 1) / 2, y + height * (ndc[1] + 1) / 2
print("object    ", v)
print("eye       ", eye.round(3))
print("clip      ", clip.round(3))
print("device    ", ndc.round(3))
print(
    "window    ",
    np.round(window, 2),
    "  gluProject:",
    np.round(gluProject(*v[:3])[:2], 2),
)

# %% The same from outside: eye, pyramid of sight with near and far plane, the picture, the lamp
glsim.outside(draw)

# %% [markdown]
# Then, in this order: **primitive assembly** makes triangles of the vertices, **clipping** cuts off what lies outside of
# the pyramid, **rasterisation** finds the pixels that a triangle covers and interpolates everything between its corners,
# **fragments** get their colour, and **tests** decide which of them reach the picture.
#
# Where in that row is the light? In fixed-function OpenGL at the vertices, in eye coordinates, right after $M$. It is
# what the rest of this course is about.
#
# The order of the calls matters, because each multiplies from the right: `gluLookAt`, *then* the light's position, *then*
# `glRotatef` for the object. A position that is given before `gluLookAt` sticks to the camera like a miner's lamp.

# %% The lamp placed after gluLookAt stands in the world; placed before, it moves with the eye
screen = begin(640, 320)
for column, after in enumerate((True, False)):
    glViewport(320 * column, 0, 320, 320)
    draw()
    glClear(GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    if not after:
        glLightfv(GL_LIGHT0, GL_POSITION, [-2, 3, 4, 1])
    gluLookAt(-4, 1.5, -2, 0, 0, 0, 0, 1, 0)  # from behind
    if after:
        glLightfv(GL_LIGHT0, GL_POSITION, [-2, 3, 4, 1])
    glutSolidTeapot(1)
screen

# %% [markdown]
# ## Try this
#
# 1. Exchange `gluLookAt` and `glRotatef(20, ...)`. What turns now?
# 2. Set the far plane to 5: `gluPerspective(40, 1, 1, 5)`. What is missing?
# 3. Make the viewport twice as wide as high and leave the 1 in `gluPerspective`. What happens to the pot?
#
# ## Questions
#
# In which step does perspective happen: where do far things become small?
#
# <details><summary>Answer</summary>
#
# In the division by $w_\mathrm{clip}$. The projection matrix only prepares it: it puts the distance from the eye, $-z$,
# into $w$.
#
# </details>
#
# ## Exercise
#
# Exercise 1: place the camera, then the light.
