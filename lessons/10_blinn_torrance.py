# %% [markdown]
# # 10. Blinn and Torrance: the halfway vector
#
# Take a rough surface as thousands of tiny mirrors that point in all directions, most of them roughly along the normal.
# Which of them send the lamp's light to your eye? Those that face halfway between the two. Their direction has a name:
# $\mathbf{H}$.

# %% [markdown]
# ## Predict
#
# A wet street at night; far away, low above it, hangs a lamp. In the picture Phong's highlight $(\mathbf{R} \cdot
# \mathbf{V})^n$ is a round blot around the lamp's mirror image. What shape has Blinn's $(\mathbf{N} \cdot \mathbf{H})^n$?
#
# - round as well: the formulas are nearly the same
# - long and narrow, stretched towards the eye
# - wide and flat, along the horizon

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


glsim.compare(
    street,
    modes=["phong:phong", "phong:blinn"],
    size=420,
    samples=4,
    differences="off",
    live="lights.position, materials.shininess",
)

# %% [markdown]
# ## What you should see
#
# Both have their brightest point where a mirror would show the lamp. Phong's falls off by the angle between the line of
# sight and that mirror image, nearly alike in all directions: a round blot, wider than it is high only because the horizon cuts it.
# Blinn's is drawn out towards the eye, as lights on wet asphalt and the sun on the sea are. That is what "agrees better
# with experiments" means: a photograph shows the second.

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
# > $\mathbf{H} \cdot \mathbf{V}$ does not contain the surface at all. And the sum must be divided by its length,
# > which can be as much as 2.

# %%
glsim.source("shaders/specular.glsl", "vec3 H = normalize(L + V);", lines=2)

# %% Only the highlight of a ball: the correct (N.H)^20; the slide's (H.V)^20; with N.(L + V), not normalised
import numpy as np
from PIL import Image

from glsim import shading

y, x = np.mgrid[1.15:-1.15:480j, -1.15:1.15:480j]
inside = (x**2 + y**2 < 1)[..., None]
N = np.stack([x, y, np.sqrt(np.clip(1 - x**2 - y**2, 0, None))], axis=-1)
L = shading.normalize([-1, 1, 2])
V = np.array([0, 0, 1])
H = shading.halfway(L, V)
three = [
    shading.power(shading.dot(N, H), 20),
    shading.power(shading.dot(H, V), 20) * np.ones_like(inside),
    shading.power(shading.dot(N, L + V), 20),
]
row = [np.where(inside, np.clip(0.1 + term, 0, 1), 0.25) for term in three]
Image.fromarray((255 * np.concatenate(row, axis=1)[..., 0]).astype(np.uint8)).reduce(2)

# %% [markdown]
# In the middle the ball is a flat disc, everywhere $(\mathbf{H} \cdot \mathbf{V})^{20} = 0.38$: with one lamp and one eye it is
# a constant. On the right $|\mathbf{L} + \mathbf{V}| = 1.91$, and $1.91^{20}$ is 400 000: a white blot.

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

# %% 2000 pairs of directions above the surface: the smallest N.H and the smallest R.V
rng = np.random.default_rng(1)
L, V = shading.normalize(rng.normal(size=(2, 2000, 3)) * [1, 1, 0.4])
L[:, 2], V[:, 2] = abs(L[:, 2]), abs(V[:, 2])
N = np.array([0, 0, 1])
print("smallest N.H:", shading.dot(N, shading.halfway(L, V)).min().round(3))
print("smallest R.V:", shading.dot(shading.reflection(N, L), V).min().round(3))

# %% [markdown]
# ## When is it constant?
#
# If the light is a direction, $\mathbf{L}$ is the same everywhere. If the view is orthographic, $\mathbf{V}$ is the same
# everywhere. With both, $\mathbf{H}$ is *one vector for the whole scene*: it is computed once for each light, square root
# included. $\mathbf{N} \cdot \mathbf{H}$ is then a function of the normal alone. On a **flat** surface it is one number, and
# the surface gleams evenly or not at all; on a curved one it varies with $\mathbf{N}$.

# %% [markdown]
# OpenGL need not draw an orthographic picture for that. `GL_LIGHT_MODEL_LOCAL_VIEWER` is 0 unless you set it, and then
# the equation takes $\mathbf{V} = (0, 0, 1)$, an eye infinitely far away, whatever the projection is.
#
# > **The slide says** that with a directional light and an orthographic projection $N \cdot H$ is constant. It is
# > $\mathbf{H}$ that is constant. $\mathbf{N} \cdot \mathbf{H}$ is constant on each flat surface.

# %% A direction and an infinite viewer on a wall, and on a ball; the wall with a local viewer; with a lamp at a place
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(960, 240, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.1, 0.2, 0.4, 1])
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
glMaterialf(GL_FRONT, GL_SHININESS, 100)
glMatrixMode(GL_PROJECTION)
gluPerspective(53, 1, 1, 10)
glMatrixMode(GL_MODELVIEW)
glTranslatef(0, 0, -2.4)
direction, place = [0.2, 0.2, 1, 0], [0.5, 0.5, 1, 1]
pictures = ((direction, 0), (direction, 0), (direction, 1), (place, 0))
for column, (light, local_viewer) in enumerate(pictures):
    glViewport(240 * column, 0, 240, 240)
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local_viewer)
    glPushMatrix()
    glLoadIdentity()  # the light is placed in eye space
    glLightfv(GL_LIGHT0, GL_POSITION, light)
    glPopMatrix()
    glNormal3f(0, 0, 1)
    if column == 1:
        glutSolidSphere(0.95, 64, 48)
    else:
        glRectf(-1, -1, 1, 1)
screen

# %% [markdown]
# The first wall is even. The ball has the same $\mathbf{H}$ and many normals, so it has a highlight. The third picture has a
# local viewer, so $\mathbf{V}$ varies; the fourth has a lamp at a place, so $\mathbf{L}$ does: either is enough to give the
# wall a highlight.

# %% [markdown]
# ## Try this
#
# 1. Set the shininess of the street to 15, then to 128: which lobe keeps its shape?
# 2. Lift the eye a little, `gluLookAt(0, 2, ...)`: how does Blinn's highlight change its shape?
# 3. Turn the first wall of the last figure by `glRotatef(8, -1, 1, 0)`, so that it faces $\mathbf{H}$. Is it still even?
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
# Exercise 7 (lesson 10): write Blinn's (N·H)ⁿ. Exercise 33 (lesson 10): write it in GLSL, compiled into the real shader.
