# %% [markdown]
# # 9. Computing R
#
# The highlight needs the direction in which a mirror would send the light. No angle has to be computed for it, and no
# sine: one dot product, a multiplication and a subtraction do.

# %% [markdown]
# ## Predict
#
# $\mathbf{L}$ is a unit vector that stands at 35° to the normal $\mathbf{N}$. How long is its projection onto the normal,
# $(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N}$?
#
# - 1, because both are unit vectors
# - $\cos 35° \approx 0.82$
# - $\sin 35° \approx 0.57$

# %% L, its projection on N, the rest S, and R put together of both
import numpy as np

import glsim
from glsim import plots, shading

plots.computing_r(35)

# %% [markdown]
# ## What you should see
#
# $\mathbf{L}$ is made of two parts: its shadow on the normal, $(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N}$, of the length
# $\cos 35°$, and what is left over, lying flat on the surface. A mirror keeps the first part and turns the second round.
# With $\mathbf{S}$ as the arrow from $\mathbf{L}$ to the projection, $\mathbf{R}$ is the projection plus $\mathbf{S}$ once
# more.

# %% [markdown]
# ## The formula
#
# $$ \mathbf{S} = (\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} - \mathbf{L}, \qquad \mathbf{R} = (\mathbf{N} \cdot \mathbf{L})\,
# \mathbf{N} + \mathbf{S} = 2\,(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} - \mathbf{L} $$
#
# $\mathbf{N}$ is the unit normal, $\mathbf{L}$ the unit vector towards the light, $\mathbf{R}$ the direction of the mirrored
# light, away from the surface. $\mathbf{R}$ is a unit vector too, if the others are.

# %%
glsim.source("shaders/specular.glsl", "vec3 S = dot(N, L) * N - L;", lines=2)

# %% R in numbers: it has the length of L, and the same angle to N on the other side
N = np.array([0.0, 0.0, 1.0])
L = np.array([-0.6, 0.0, 0.8])
R = shading.reflection(N, L)
print("R =", R, "  length", np.linalg.norm(R), "  N.L =", N @ L, "  N.R =", N @ R)

# %% [markdown]
# All of this holds for **unit vectors** only. Here is what happens to the mirror direction if the normal is too long,
# as it is after `glScalef` without `GL_NORMALIZE`:

# %% The direction R for normals of the length 1, 1.1 and 1.5: only the first is a mirror
for length in (1.0, 1.1, 1.5):
    too_long = length * N
    R = 2 * (too_long @ L) * too_long - L
    angle = np.degrees(np.arccos(R[2] / np.linalg.norm(R)))
    print(f"|N| = {length}: R = {R.round(2)}, {angle:.1f} degrees from N")

# %% Four rays and their mirror directions
plots.reflection((15, 35, 55, 75))

# %% The same ball three times, its normals 10 % too short, right, and 10 % too long
from glsim.gl import *
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(810, 270, samples=4)
glClearColor(0.16, 0.17, 0.2, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM)
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 2, 0])
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.2, 0.4, 0.6, 1])
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
glMaterialf(GL_FRONT, GL_SHININESS, 20)
glMatrixMode(GL_PROJECTION)
glOrtho(-1, 1, -1, 1, -1, 1)
glMatrixMode(GL_MODELVIEW)
for column, length in enumerate((0.9, 1.0, 1.1)):
    glViewport(270 * column, 0, 270, 270)
    glLoadIdentity()
    glScalef(1 / length, 1 / length, 1 / length)
    glutSolidSphere(0.8 * length, 80, 60)
screen

# %% [markdown]
# All three are spheres of the radius 0.8: `glScalef` makes the ball larger and the *normals shorter* by the same factor, a
# smaller `glutSolidSphere` hides the first. At 0.9 the highlight is gone, for in its middle $\mathbf{R} \cdot \mathbf{V}$ is
# not 1 but 0.65, and $0.65^{20}$ is 0.0002. At 1.1 it is a white blot. The diffuse light changes by 10 % only.
# `glEnable(GL_NORMALIZE)` mends both.

# %% On a surface: N, L, R and V at a pixel of a teapot
from glsim.glut import glutSolidTeapot


def teapot():
    glClearColor(0.16, 0.17, 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for what in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE):
        glEnable(what)
    glShadeModel(GL_PHONG_WIN)
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM)
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 2, 0])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.2, 0.4, 0.6, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 20)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, -2, 2)
    glMatrixMode(GL_MODELVIEW)
    glRotatef(20, 1, 0, 0)
    glutSolidTeapot(0.55)


glsim.show(
    teapot,
    still=glsim.vectors(teapot, 200, 290),
    point=(200, 290),
    controls="lights.position",
)

# %% [markdown]
# > **The slide says** "all vectors are unit length!" and is right to shout. Which of them is it for? The mirror direction
# > needs $\mathbf{N}$ alone to be of unit length: a longer $\mathbf{L}$ gives an equally longer $\mathbf{R}$ in the right
# > direction. But $\mathbf{R} \cdot \mathbf{V}$ is a cosine only if $\mathbf{R}$ and $\mathbf{V}$ are unit vectors too.
#
# ## Try this
#
# 1. `plots.computing_r(35)` with 10 and 80 degrees: which of the two parts is large where?
# 2. Compute `shading.reflection(N, shading.reflection(N, L))`. Why is it `L` again?
# 3. Mirror a light from behind the surface, `L = [0.6, 0, -0.8]`. Where does R point, and why does OpenGL not care?
#
# ## Questions
#
# When is $\mathbf{R} = \mathbf{L}$, and when is $\mathbf{R} = -\mathbf{L}$?
#
# <details><summary>Answer</summary>
#
# $\mathbf{R} = \mathbf{L}$ if the light stands in the direction of the normal: $\mathbf{S} = 0$. $\mathbf{R} = -\mathbf{L}$ if
# it grazes the surface, $\mathbf{N} \cdot \mathbf{L} = 0$: the light goes straight on.
#
# </details>
#
# ## Exercise
#
# Exercise 4 (lesson 9): write the reflection vector.
