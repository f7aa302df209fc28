# %% [markdown]
# # 4. Light sources
#
# The sun, a bulb, a tube, a monitor: real lamps are complicated. OpenGL knows three that fit into a few numbers: a
# point, a direction, and a point with a lampshade. And one law makes it possible to use many: light adds up.

# %% [markdown]
# ## Predict
#
# Three spotlights shine on a white wall in the dark: one red, one green, one blue. Their circles overlap. Which colour
# has the place where all three meet?
#
# - nearly black, as if three paints were mixed
# - a muddy brown
# - white

# %% A red, a green and a blue spotlight on a white wall
import numpy as np

import glsim
from glsim.gl import *

COLORS = {"red": [1, 0, 0, 1], "green": [0, 1, 0, 1], "blue": [0, 0, 1, 1]}
PLACES = {"red": (-0.45, 0.25), "green": (0.45, 0.25), "blue": (0, -0.5)}


def wall():
    glNormal3f(0, 0, 1)
    glRectf(-2, -2, 2, 2)


def shine(*names):
    glClearColor(0, 0, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(-1.6, 1.6, -1.6, 1.6, 0, 10)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glTranslatef(0, 0, -5)
    glEnable(GL_LIGHTING)
    glShadeModel(GL_PHONG_WIN)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_AMBIENT, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 1, 1, 1])
    for number, name in enumerate(names):
        light = GL_LIGHT0 + number
        glEnable(light)
        glLightfv(light, GL_DIFFUSE, COLORS[name])
        glLightfv(light, GL_POSITION, [*PLACES[name], 4, 1])
        glLightfv(light, GL_SPOT_DIRECTION, [0, 0, -1])
        glLightf(light, GL_SPOT_CUTOFF, 12)
    wall()


screen = glsim.offscreen(560, 560, samples=4)
shine("red", "green", "blue")
screen

# %% [markdown]
# ## What you should see
#
# White in the middle; yellow, cyan and magenta where two circles meet. Paint takes light away, lamps add it. Each light
# gives its share to each channel, and no light knows of the others. That is **superposition**.
#
# It is not a trick of OpenGL: rays of light do not disturb each other. So the picture under three lamps is the *sum* of
# the three pictures under one. Is it? Draw them one by one, and add:

# %% The largest difference between the picture under three lights and the sum of three pictures, printed
together = np.array(screen.image())[..., :3].astype(int)
total = np.zeros_like(together)
for name in COLORS:
    alone = glsim.offscreen(560, 560, samples=4)
    shine(name)
    total += np.array(alone.image())[..., :3]
print("largest difference:", np.abs(together - total).max(), "of 255")

# %% [markdown]
# ## The formula
#
# $$ I = \sum_i s_i \, k_d \, I_{L,i} \, (\mathbf{N} \cdot \mathbf{L}_i) $$
#
# $I_{L,i}$ is the intensity of light $i$, an RGB triple; the equation is evaluated for each channel separately.
# $\mathbf{L}_i$ is the unit vector from the surface to the light, $\mathbf{N}$ the unit normal, $k_d \in [0, 1]$ the
# diffuse reflectance, and negative $\mathbf{N} \cdot \mathbf{L}_i$ count as 0. $s_i \in [0, 1]$ is how much of the light
# gets here: 1 for a directional light. The three kinds of light differ in two things only, $\mathbf{L}$ and $s$:
#
# | light | in OpenGL | $\mathbf{L}$ at the point $\mathbf{P}$ |
# | --- | --- | --- |
# | directional | position $(x, y, z, 0)$ | $(x, y, z)$, made unit length: the same everywhere |
# | point, isotropic | position $(x, y, z, 1)$ | from $\mathbf{P}$ to the position, made unit length |
# | spot | a point with a cutoff below 90° | as for a point; $s = 0$ outside the cone |
#
# Inside the cone $s = (-\mathbf{L} \cdot \mathbf{D})^e$ with the spot's direction $\mathbf{D}$ and exponent $e$.

# %%
glsim.source("shaders/light.glsl", "L -= P;", lines=3)

# %%
glsim.source("shaders/light.glsl", "float spotlight(Light light, vec3 L)", lines=6)

# %% [markdown]
# ## Three kinds, one scene
#
# Only the light changes: from a direction, from a point above the middle, from the same point with a lampshade.

# %% Balls on a floor under a directional light, a point light and a spotlight
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidSphere


def balls(light):
    glClearColor(0.03, 0.03, 0.04, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(35, 1, 1, 30)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 5, 7, 0, 0, 0, 0, 1, 0)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glShadeModel(GL_PHONG_WIN)
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.7, 0.62, 0.48, 1])
    if light == "directional":
        glLightfv(GL_LIGHT0, GL_POSITION, [0, 1, 0, 0])
    else:
        glLightfv(GL_LIGHT0, GL_POSITION, [0, 2.2, 0, 1])
    if light == "spot":
        glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, [0, -1, 0])
        glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 50)
        glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2)
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-3, 3), (3, 3), (3, -3), (-3, -3)):
        glVertex3f(x, 0, z)
    glEnd()
    for x, z in ((-1.3, 1.3), (1.3, 1.3), (1.3, -1.3), (-1.3, -1.3)):
        glPushMatrix()
        glTranslatef(x, 0.5, z)
        glutSolidSphere(0.5, 40, 40)
        glPopMatrix()


glsim.compare(
    balls,
    sweep={"light": ["directional", "point", "spot"]},
    modes="phong",
    lobes="blinn",
    columns="light",
    size=300,
    samples=4,
    differences="off",
    title="Three kinds of light",
    live="lights.position, lights.spot",
)

# %% [markdown]
# Directional: the floor is even, and all four balls are lit alike, from above. Point: the floor is brightest under the
# lamp and each ball is bright on the side that faces it. Spot: beyond 50° from the axis there is only the glow. Nobody
# casts a shadow: that is for lesson 22.

# %% The same spotlight from outside: its cone, the floor, the eye
glsim.outside(lambda: balls("spot"))

# %% The spotlight's factor for four exponents and a cutoff of 30°
glsim.plots.spot()

# %% [markdown]
# > **The slide says** that a point light "emits light equally in all directions". From that it follows that its light
# > thins out with the square of the distance, as the same power crosses larger and larger spheres. OpenGL does that only
# > on request (`GL_QUADRATIC_ATTENUATION`); in the figures above only the angle changes. Lesson 23 adds the distance.

# %% [markdown]
# ## Try this
#
# 1. Make the red light in `COLORS` orange: `[1, 0.6, 0, 1]`. Now the sum of the pictures is no longer the picture of
#    the sum. Where not, and in which channel?
# 2. In `balls`, set `GL_SPOT_CUTOFF` to 30. Which balls are still lit?
# 3. Set the position of the point light, which the spot shares, to `[0, 200, 0, 1]`. Which of the three pictures does it look like now?

# %% [markdown]
# ## Questions
#
# When is the picture under two lights *not* the sum of the two pictures?
#
# <details><summary>Answer</summary>
#
# Where a channel of the sum is above 1: the screen clamps it. (And if the ambient glow of the scene, which belongs to no
# light, is in both pictures: then it is counted twice.)
#
# </details>
#
# Can a directional light be a spotlight?
#
# <details><summary>Answer</summary>
#
# Not in a useful way. It has no place from which a cone could begin. OpenGL takes the direction for $L$, and the factor
# is then the same everywhere.
#
# </details>
#
# ## Exercise
#
# Exercise 19 (lesson 23): attenuation and the spotlight.
