# %% [markdown]
# # 3. Object appearance
#
# You have never seen an object. You have seen light that left it. Between the lamp and your eye it has met surfaces, lost
# a part at each, and changed its colour on the way. What arrives is the sum of all these journeys.

# %% [markdown]
# ## Predict
#
# A white box with a warm lamp in the ceiling has a red wall on the left and a green one on the right. Look at the white
# floor close to the red wall. Which colour does it have?
#
# - that of the lamp, as everywhere: its material is white
# - that of the lamp, and a little redder
# - that of the lamp, and a little greener, because red is absorbed

# %% A box with a red and a green wall: light straight from the lamp only, and light by all paths
import numpy as np

import glsim
from glsim.gl import *

box = glsim.compare(
    "cornell",
    modes="direct,radiosity",
    patches=300,
    size=400,
    differences="off",
    title="Straight from the lamp, and by all paths",
)
box

# %% [markdown]
# ## What you should see
#
# Left, only the light that comes straight from the lamp: what it does not reach is black, the ceiling too. Right,
# light that has met other surfaces is added: the ceiling appears, shadows are no longer black, and the white floor and
# the white blocks turn reddish on the side of the red wall, greenish on the other. The wall has become a lamp: a red
# one, because it absorbs green and blue.
#
# This is **light transport**: light is emitted by sources; it meets a surface, where a part is reflected and the rest
# is absorbed; and the reflected part goes on to the next surface, or into the camera. OpenGL computes one
# meeting for each light. The other journeys are lessons 28 to 35.

# %% [markdown]
# ## The formula
#
# $$ \text{reflected} = k \cdot \text{arriving}, \qquad \text{absorbed} = (1 - k) \cdot \text{arriving} $$
#
# $k \in [0, 1]$ is the reflectance, a number of its own for red, green and blue. What comes to the camera is a sum over the
# paths. After $m$ surfaces with the reflectances $k_1, k_2, \ldots, k_m$ a share of
#
# $$ k_1 k_2 \cdots k_m $$
#
# is left. On a red wall with $k = (0.6, 0.1, 0.1)$, then on a white floor with $(0.8, 0.8, 0.8)$, the white light
# $(1, 1, 1)$ becomes $(0.48, 0.08, 0.08)$. For one surface, each channel is one product:

# %%
glsim.source("shading/terms.py", "def diffuse(k_d", lines=3)

# %% What is left of the light after each surface, for four reflectances
surfaces = np.arange(0, 11)
glsim.plots.curves(
    {f"$k = {k}$": (surfaces, k**surfaces) for k in (0.9, 0.7, 0.5, 0.1)},
    "number of surfaces met",
    "share of the light that is left",
    markers=True,
    title="Something is absorbed at each surface",
)

# %% [markdown]
# White walls ($k = 0.9$) keep half of the light for six meetings: white rooms are bright. With $k = 0.1$ one meeting is
# almost the end.
#
# ## Where it goes: the finish
#
# How *much* is reflected is one thing. In which *directions* it leaves is another, and it decides whether a surface
# looks matte or glossy. In the next figure the colour is the same everywhere; only the distribution changes.

# %% Three teapots of one colour: matte, satin and glossy
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidTeapot

FINISH = {"matte": (0.0, 1), "satin": (0.35, 10), "glossy": (0.8, 80)}  # k_s, n


def teapot(finish):
    k_s, n = FINISH[finish]
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(30, 1, 1, 10)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 2, 5, 0, 0, 0, 0, 1, 0)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 2, 2, 0])
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.15, 0.45, 0.6, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [k_s, k_s, k_s, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, n)
    glutSolidTeapot(0.85)


glsim.compare(
    teapot,
    sweep={"finish": list(FINISH)},
    modes="phong",
    lobes="blinn",
    columns="finish",
    size=300,
    samples=4,
    differences="off",
    title="One colour, three finishes",
)

# %% The same three finishes as lobes: how much leaves in which direction
glsim.plots.lobes(
    {name: glsim.plots.blinn_term(0.45, *finish) for name, finish in FINISH.items()}
)

# %% [markdown]
# The narrower the lobe, the smaller and sharper the highlight. Lesson 6 follows it from chalk to mirror.
#
# > **The slide says** that the composition of the light that arrives at the camera determines the appearance of the scene.
# > It is only half of appearance: the eye judges colours by their neighbours. Our pictures stop at the camera.

# %% [markdown]
# ## Try this
#
# 1. Let the box be drawn by `modes="gouraud,radiosity"`. What does OpenGL put in the place of the journeys?
# 2. Set the reflectances of the curves to `(1.0, 0.99, 0.9)`. What would a room with $k = 1$ be like?
# 3. Light the teapots with `glLightfv(GL_LIGHT0, GL_DIFFUSE, [1, 0, 0, 1])`. Why do they become so dark?

# %% [markdown]
# ## Questions
#
# White light falls on a surface that absorbs 70 % of red, 20 % of green and 90 % of blue. Which colour leaves?
#
# <details><summary>Answer</summary>
#
# What is not absorbed is reflected: $(0.3, 0.8, 0.1)$, a green.
#
# </details>
#
# Why does a black car get hotter in the sun than a white one?
#
# <details><summary>Answer</summary>
#
# Absorbed light is not lost: its energy becomes heat, and the black car absorbs more of it.
#
# </details>
#
# ## Exercise
#
# Exercise 2 (lesson 2): reproduce this picture, with all its styles.
