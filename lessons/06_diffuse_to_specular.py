# %% [markdown]
# # 6. From diffuse to specular
#
# Chalk, eggshell, varnish, chrome: what differs is not how much light they throw back but where to. Between "equally in all
# directions" and "in exactly one" lies everything that we want to model.

# %% [markdown]
# ## Predict
#
# A ball with coloured stripes lies still under a lamp that does not move. You walk round it, from the left to the right. What
# moves across the stripes?
#
# - nothing: neither the lamp nor the ball has moved
# - the highlight only
# - the highlight and the border between light and dark

# %% A striped ball, seen from 50° on the left, from the front, and from 50° on the right
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidSphere

STRIPES = ([0.75, 0.2, 0.15], [0.8, 0.75, 0.6], [0.15, 0.35, 0.6], [0.8, 0.75, 0.6])


def point(longitude, latitude):
    a, b = np.radians([longitude, latitude])
    return np.cos(b) * np.sin(a), np.sin(b), np.cos(b) * np.cos(a)


def ball():
    for longitude in range(-180, 180, 5):
        color = STRIPES[longitude // 15 % 4]
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [*color, 1])
        glBegin(GL_QUAD_STRIP)
        for latitude in range(90, -91, -5):
            for edge in (longitude, longitude + 5):
                glNormal3f(*point(edge, latitude))
                glVertex3f(*point(edge, latitude))
        glEnd()


def look(azimuth):
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(26, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    x, _, z = point(azimuth, 0)
    gluLookAt(5 * x, 0, 5 * z, 0, 0, 0, 0, 1, 0)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 0.8, 0.9, 0])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.9, 0.9, 0.9, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 60)
    glShadeModel(GL_PHONG_WIN)


def walk(azimuth):
    look(azimuth)
    ball()


glsim.compare(
    walk,
    sweep={"azimuth": [-50, 0, 50]},
    modes="phong",
    lobes="blinn",
    columns="azimuth",
    size=300,
    samples=4,
    differences="off",
    title="Walking round a ball",
    live="camera",
)

# %% [markdown]
# ## What you should see
#
# The border between light and dark stays on its stripes: it is where $\mathbf{N} \cdot \mathbf{L} = 0$, and neither has
# changed. The highlight wanders from stripe to stripe: it is where the surface would mirror the lamp into *your* eye.
#
# This is the difference. **Diffuse** reflection goes equally in all directions and looks the same from everywhere.
# **Specular** reflection has a direction, so its look depends on the viewer.

# %% The picture taken apart: what is ambient, diffuse and specular, and the cosines behind them
glsim.terms(lambda: walk(0))

# %% [markdown]
# ## The formula
#
# How the light is distributed is a function of the directions that come in and go out: the reflectance distribution function.
# The lecture's model is a sum of two shapes,
#
# $$ I = I_L \left( k_d\,(\mathbf{N} \cdot \mathbf{L}) + k_s\,(\mathbf{R} \cdot \mathbf{V})^n \right) $$
#
# with the light's intensity $I_L$, the reflectances $k_d, k_s \in [0, 1]$, the unit normal $\mathbf{N}$, the unit vectors
# $\mathbf{L}$ to the light, $\mathbf{V}$ to the eye and $\mathbf{R}$, which is $\mathbf{L}$ mirrored at $\mathbf{N}$. The
# shininess $n \ge 0$ (at most 128 in OpenGL) says how narrow the second shape is. Only the second contains
# $\mathbf{V}$:

# %%
glsim.source("shaders/light.glsl", "color += strength * face.k_d.rgb", lines=2)

# %%
glsim.source("shading/terms.py", "def phong_specular", lines=3)

# %% Lobes from diffuse to specular: a half circle, glossy mixtures, a needle
glsim.plots.lobes(
    {
        "diffuse: $k_d = 0.8$": glsim.plots.phong_term(0.8, 0.0, 1),
        "glossy: $n = 10$": glsim.plots.phong_term(0.4, 0.4, 10),
        "glossy: $n = 60$": glsim.plots.phong_term(0.2, 0.6, 60),
        "nearly a mirror: $n = 1000$": glsim.plots.phong_term(0.0, 0.8, 1000),
    }
)

# %% [markdown]
# The light comes from the left; how far a curve is from the middle says how much leaves in that direction. The half
# circle of diffuse reflection has no favourite. A **glossy** surface adds a lobe about the mirror direction. A perfect
# mirror would be a line without width: no highlight of a point light would be found on it, but an image of the world.


# %% A ball from diffuse to specular: only the distribution changes
def mixture(specular):
    look(0)
    k_d, k_s = 0.8 * (1 - specular), 0.9 * specular
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [k_d, 0.9 * k_d, 0.7 * k_d, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [k_s, k_s, k_s, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 5 + 100 * specular)
    glutSolidSphere(1, 60, 60)


glsim.compare(
    mixture,
    sweep={"specular": [0, 0.33, 0.67, 1]},
    modes="phong",
    lobes="phong",
    columns="specular",
    size=240,
    samples=4,
    differences="off",
    live="lights.position, materials.specular, materials.shininess",
    title="From diffuse to specular",
)

# %% [markdown]
# The last ball is no chrome ball: a mirror shows its surroundings, and this model knows only lamps. That needs rays
# (lesson 28).
#
# > **The slide says** "reflectance distribution function" and draws it as a shape in the plane. It is a function of *two*
# > directions: for each direction of the light it is another shape. Lesson 27 turns the light and watches the shape.

# %% [markdown]
# ## Try this
#
# 1. In `look`, put `glLightfv(GL_LIGHT0, ...)` in front of `gluLookAt`. Now the lamp walks with you. What moves?
# 2. Set `GL_SHININESS` to 5. Is it still easy to say where the highlight is?
# 3. Give `lobes` the argument `theta=75`. What happens to the diffuse half circle, and what to the needle?

# %% [markdown]
# ## Questions
#
# Two photographs of a scene are taken from two places at the same moment. How can you tell the matte things from the
# glossy ones?
#
# <details><summary>Answer</summary>
#
# Compare the same surface point in both. A matte one has the same brightness in both, a glossy one may differ. Programs
# that rebuild a scene from photographs do that too, and shiny things confuse them.
#
# </details>
#
# Is the moon diffuse? A diffuse ball, lit from behind us, is bright in the middle and dark at its rim.
#
# <details><summary>Answer</summary>
#
# The full moon is nearly as bright at its rim as in the middle: it is no Lambertian ball. Its dust throws more light back
# to where it came from.
#
# </details>
#
# ## Exercise
#
# Exercise 6 (lesson 8): Phong's $(\mathbf{R} \cdot \mathbf{V})^n$.
