# %% [markdown]
# # 10. Blinn and Torrance: the halfway vector
#
# Take a rough surface as thousands of tiny mirrors that point in all directions, most of them roughly along the normal.
# Which of them send the lamp's light to your eye? Those that face halfway between the two. Their direction has a name:
# $\mathbf{H}$.

# %% [markdown]
# ## Predict
#
# A flat wall, seen at a grazing angle, is lit by a lamp low on the other side. Phong's highlight $(\mathbf{R} \cdot
# \mathbf{V})^n$ on it is round, as it is on a wall seen from the front. What shape has Blinn's $(\mathbf{N} \cdot
# \mathbf{H})^n$?
#
# - round as well: the formulas are nearly the same
# - long and narrow, stretched towards the eye like the sun on the sea
# - wide and flat

# %% A wet street and a lamp near the horizon: (R.V)^n and (N.H)^n. Press 1 and 2
import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective


def street():
    glClearColor(0.02, 0.02, 0.05, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(40, 1, 0.1, 200)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(0, 1, 0, 0, 0.4, -6, 0, 1, 0)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 2, -20, 1])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.25, 0.25, 0.3, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [1, 0.8, 0.5, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 60)
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-40, 1), (40, 1), (40, -60), (-40, -60)):
        glVertex3f(x, 0, z)
    glEnd()


glsim.compare(street, modes=["phong:phong", "phong:blinn"], size=420, samples=4)

# %% [markdown]
# ## What you should see
#
# Phong's spot is a disc that lies on the street. Blinn's is drawn out towards the eye, as lights on wet asphalt and the
# sun on the sea are. That is what "agrees better with experiments" means: a photograph of a street shows the second.

# %% [markdown]
# ## The formula
#
# $$ I_s = I_L\, k_s\, (\mathbf{N} \cdot \mathbf{H})^n, \qquad \mathbf{H} = \frac{\mathbf{L} + \mathbf{V}}{|\mathbf{L} + \mathbf{V}|} $$
#
# $\mathbf{H}$ is the unit vector halfway between $\mathbf{L}$, towards the light, and $\mathbf{V}$, towards the eye. It
# equals $\mathbf{N}$ exactly where the surface mirrors the light to the eye, so both formulas have their maximum at the
# same place. $k_s$, $I_L$ and $n$ are as in Phong's model.
#
# > **The slide says** $I_s = I_L k_s (H \cdot V)^n$ and $H = L + V$. The first must be $(\mathbf{N} \cdot \mathbf{H})^n$:
# > $\mathbf{H} \cdot \mathbf{V}$ does not contain the surface at all. And the sum must be normalised.

# %%
glsim.source("shaders/specular.glsl", "vec3 H = normalize(L + V);", lines=2)

# %% L, V and H between them
from glsim import plots

plots.halfway()

# %% Both highlights against the angle of view; four times the exponent makes Blinn's about as wide as Phong's
plots.highlights(45, 20)

# %% [markdown]
# The angle between $\mathbf{N}$ and $\mathbf{H}$ is half of that between $\mathbf{R}$ and $\mathbf{V}$ (in the plane of
# incidence), so Blinn's highlight with the same $n$ is about twice as wide.
#
# **Never negative.** If the light and the eye are in front of the surface, $\mathbf{N} \cdot \mathbf{L} > 0$ and
# $\mathbf{N} \cdot \mathbf{V} > 0$, then $\mathbf{N} \cdot \mathbf{H} > 0$ as well, and the power needs no clamp.
# $\mathbf{R} \cdot \mathbf{V}$ may well be negative.

# %% The angle between N and H never exceeds 90 degrees; that between R and V does
import numpy as np

from glsim import shading

rng = np.random.default_rng(1)
N = np.array([0.0, 0.0, 1.0])
above = [
    v / np.linalg.norm(v) for v in rng.normal(size=(4000, 3)) * [1, 1, 0.4] if v[2] > 0
]
L, V = (
    np.array(above[: len(above) // 2]),
    np.array(above[len(above) // 2 :][: len(above) // 2]),
)
print("smallest N.H:", (shading.halfway(L, V) @ N).min().round(3))
print("smallest R.V:", np.sum(shading.reflection(N, L) * V, axis=1).min().round(3))

# %% [markdown]
# **When is it constant?** With a light at infinity $\mathbf{L}$ is the same everywhere. With an orthographic view, or
# OpenGL's default `GL_LIGHT_MODEL_LOCAL_VIEWER` 0, $\mathbf{V}$ is too. Then $\mathbf{H}$ is one vector for the whole
# picture, and on a *flat* surface $\mathbf{N} \cdot \mathbf{H}$ is one number: the wall gleams evenly, or not at all. That
# saved a square root for each vertex in 1992, and is why OpenGL chose this lobe.

# %% A flat square under a directional light: with an infinite viewer evenly bright, with a local one a highlight
screen = glsim.offscreen(640, 320)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightfv(GL_LIGHT0, GL_POSITION, [0.3, 0.3, 1, 0])
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.1, 0.2, 0.4, 1])
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.8, 0.8, 0.8, 1])
glMaterialf(GL_FRONT, GL_SHININESS, 100)
glMatrixMode(GL_PROJECTION)
glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10)
glMatrixMode(GL_MODELVIEW)
for column in (0, 1):
    glViewport(320 * column, 0, 320, 320)
    glLoadIdentity()
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, column)
    glTranslatef(0, 0, -2.2)
    glNormal3f(0, 0, 1)
    glRectf(-1, -1, 1, 1)
screen

# %% [markdown]
# ## Try this
#
# 1. Set the shininess of the street to 15 and 200: which lobe keeps its shape?
# 2. Lift the eye, `gluLookAt(0, 8, ...)`: how does Blinn's highlight change its shape?
# 3. In the last figure make the light positional, `[0.3, 0.3, 1, 1]`: is the left square still even?
#
# ## Questions
#
# For light and eye in the same direction, $\mathbf{L} = \mathbf{V}$: what is $\mathbf{H}$, and which angle do the two models
# take the cosine of?
#
# <details><summary>Answer</summary>
#
# $\mathbf{H} = \mathbf{L}$. Blinn takes the angle $\theta$ between $\mathbf{N}$ and $\mathbf{L}$, Phong $2\theta$, between
# $\mathbf{R}$ and $\mathbf{V}$.
#
# </details>
#
# ## Exercise
#
# Exercise 7: write Blinn's (N·H)ⁿ. Exercise 33: write it in GLSL, compiled into the real shader.
