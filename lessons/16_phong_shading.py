# %% [markdown]
# # 16. Phong shading
#
# Gouraud interpolates colours and loses the highlight. Bui Tuong Phong, in the same paper that has his highlight formula,
# interpolates the *normal* instead, and evaluates the equation at every pixel. Two ideas of one man, both named after
# him: this lesson tells them apart.

# %% [markdown]
# ## Predict
#
# A ball of only 12 × 8 quads is drawn flat, then with Gouraud's and with Phong's shading. Phong shading makes the highlight
# round. What does it make of the ball's *outline*?
#
# - round as well
# - nothing: it stays a polygon
# - rounder than Gouraud's, but not quite round

# %% A ball of 12 x 8 quads under GL_FLAT, GL_SMOOTH and GL_PHONG_WIN
from math import cos, pi, sin

import glsim
from glsim.gl import *
from glsim.glu import gluPerspective


def point(i, j):
    """A point of the unit sphere; it is its own normal."""
    theta, phi = pi * i / 8, 2 * pi * j / 12
    return sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi)


def ball():
    glBegin(GL_QUADS)
    for i in range(8):
        for j in range(12):
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                glNormal3f(*point(i + a, j + b))
                glVertex3f(*point(i + a, j + b))
    glEnd()


def scene():
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, [-2, 3, 4, 1])
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.7, 0.2, 0.15, 1])  # k_a, k_d
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.7, 0.7, 0.7, 1])  # k_s
    glMaterialf(GL_FRONT, GL_SHININESS, 40)  # n
    glMatrixMode(GL_PROJECTION)
    gluPerspective(36, 1, 1, 10)
    glMatrixMode(GL_MODELVIEW)
    glTranslatef(0, 0, -3.9)


screen = glsim.offscreen(870, 290, samples=4)
scene()
for column, mode in enumerate((GL_FLAT, GL_SMOOTH, GL_PHONG_WIN)):
    glViewport(290 * column, 0, 290, 290)
    glShadeModel(mode)
    ball()
screen

# %% [markdown]
# ## What you should see
#
# The outline is the same polygon three times. Shading changes colours, never geometry. Inside it, the picture on the right
# is that of a round ball: the highlight is round, and as bright as it should be. In the middle it is dull and has
# corners, because no vertex lies where it is brightest.

# %% [markdown]
# ## The formula
#
# $$ \mathbf{N} = \frac{w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3 \mathbf{N}_3}{|w_1 \mathbf{N}_1 + w_2 \mathbf{N}_2 + w_3
# \mathbf{N}_3|}, \qquad C = I(\mathbf{N}) $$
#
# $\mathbf{N}_1, \mathbf{N}_2, \mathbf{N}_3$ are the unit normals at the vertices, $w_k \in [0, 1]$ the pixel's weights with the
# sum 1, $C$ its colour. $I$ is the illumination equation, *any* illumination equation. It has moved from the vertex
# shader to the fragment shader:

# %%
glsim.source("shaders/main.frag", "vec3 N = normalize(normal);", lines=2)

# %% [markdown]
# The division matters. A mean of two unit vectors is shorter than 1, for the tip cuts the corner of the circle. Half-way
# between normals that are 45° apart the length is $\cos 22.5° = 0.92$, and $0.92^{40}$ is 0.04: without `normalize` the
# highlight would be gone once more.

# %% Length of the interpolated normal from one vertex to the next, for normals 15, 30 and 45 degrees apart
import numpy as np

from glsim import plots

t = np.linspace(0, 1, 101)
lengths = {}
for degrees in (15, 30, 45):
    a = np.radians(degrees)
    N_1, N_2 = np.array([0, 1]), np.array([np.sin(a), np.cos(a)])
    between = np.outer(1 - t, N_1) + np.outer(t, N_2)
    lengths[f"{degrees}° apart"] = (t, np.linalg.norm(between, axis=1))
plots.curves(
    lengths, "way from vertex 1 to vertex 2", "length of the mean", ylim=(0.9, 1.005)
)

# %% [markdown]
# ## Phong shading is not the Phong model
#
# | | decides | choices |
# |---|---|---|
# | the Phong **model** | what the equation says | $(\mathbf{R} \cdot \mathbf{V})^n$, or Blinn's $(\mathbf{N} \cdot \mathbf{H})^n$ |
# | Phong **shading** | where it is evaluated | per polygon, per vertex, per pixel |
#
# Choose one of each. OpenGL's fixed function has Blinn's formula, with Gouraud shading; a program of today usually has
# Blinn's formula with Phong shading.


# %% Rows: the model. Columns: the shading. All six pictures make sense
def lit_ball():
    scene()
    glShadeModel(GL_PHONG_WIN)
    ball()


glsim.compare(
    lit_ball,
    modes="flat,gouraud,phong",
    lobes="phong,blinn",
    size=280,
    samples=4,
    differences="off",
    live="edges, lights.position, materials.shininess",
)

# %% The interpolated normal at a pixel inside a quad: at no vertex is there such an N
glsim.show(
    lit_ball,
    still=glsim.vectors(lit_ball, 330, 190),
    point=(330, 190),
    controls="edges, lights.position",
)

# %% [markdown]
# ## Normals may lie
#
# A flat octagon, nine vertices, all in one plane. Only its *normals* are those of a dome. Flat shading sees eight
# triangles; Phong shading sees a button.


# %% A flat octagon with the normals of a dome, flat, Gouraud and Phong shaded
def button():
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 2, 0])
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.8, 0.5, 0.1, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.7, 0.7, 0.7, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 30)
    glBegin(GL_TRIANGLE_FAN)
    glNormal3f(0, 0, 1)
    glVertex3f(0, 0, 0)
    for k in range(9):
        x, y = cos(k * pi / 4), sin(k * pi / 4)
        glNormal3f(0.8 * x, 0.8 * y, 0.6)
        glVertex3f(0.9 * x, 0.9 * y, 0)
    glEnd()


glsim.compare(
    button,
    modes="flat,gouraud,phong",
    lobes="blinn",
    size=280,
    samples=4,
    differences="off",
    live="edges, lights.position",
)

# %% [markdown]
# > **The slide says** "interpolate surface normal over polygon". It leaves out the step that follows: make it a unit vector
# > again. And it says nothing of the price: the ball has 384 vertices (4 for each quad), and covers tens of thousands
# > of pixels. The equation runs that much more often.
#
# OpenGL 1.x had no Phong shading. `GL_PHONG_WIN` is from an extension for Windows, `GL_WIN_phong_shading`, and glsim
# gives it to every program.
#
# ## Try this
#
# 1. Give the ball 6 × 4 quads (four numbers). What betrays Phong shading now, although the highlight is still round?
# 2. Set the normals at the rim of the button to `(x, y, 0)`, then to `(-0.8 * x, -0.8 * y, 0.6)`. Dome or bowl?
# 3. Set the shininess to 5. How large is the difference between Gouraud and Phong now?
#
# ## Questions
#
# A cube has its corners' normals averaged, $(1, 1, 1) / \sqrt 3$ and so on. What does Phong shading make of it?
#
# <details><summary>Answer</summary>
#
# A cube with the outline of a cube that is lit like a ball: the normals vary over each face as if it were round. Where an
# edge is meant, each face needs vertices and normals of its own (lesson 21: the crease angle).
#
# </details>
#
# ## Exercise
#
# Exercise 13 (lesson 16): Phong shading by hand. Exercise 34 (lesson 16): write it in GLSL, compiled into the real shader.
