# %% [markdown]
# # 4. Light sources
#
# Suns, bulbs, screens, fireflies: real lamps have sizes, shapes and moods. A renderer of the nineties knew three kinds,
# and all three are infinitely small. That is less of a loss than it sounds, for one reason: light adds up.

# %% [markdown]
# ## Predict
#
# A floor of tiles is lit by a lamp far away, and then by a lamp close above its middle, both equally strong. How do the
# two pictures differ?
#
# - not at all, if the strength is the same
# - the near lamp makes a bright spot that fades outwards, the far one lights all tiles alike
# - the near lamp is brighter everywhere

# %% A floor under a directional light, a point light and a spotlight
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidSphere


def scene():
    for x in range(-4, 4):
        for z in range(-4, 4):
            shade = 0.9 if (x + z) % 2 else 0.7
            glMaterialfv(
                GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [shade, shade, 0.95 * shade, 1]
            )
            glNormal3f(0, 1, 0)
            glBegin(GL_QUADS)
            for dx, dz in ((0, 1), (1, 1), (1, 0), (0, 0)):
                glVertex3f(x + dx, 0, z + dz)
            glEnd()
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.8, 0.3, 0.15, 1])
    for x, z in ((-1.5, -1), (1.5, -1), (0, 1.2)):
        glPushMatrix()
        glTranslatef(x, 0.6, z)
        glutSolidSphere(0.6, 48, 32)
        glPopMatrix()


def begin(width, height, aspect):
    screen = glsim.offscreen(width, height, samples=4)
    glClearColor(0.07, 0.08, 0.1, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glShadeModel(GL_PHONG_WIN)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.05, 0.05, 0.06, 1])
    glMatrixMode(GL_PROJECTION)
    gluPerspective(40, aspect, 1, 30)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(0, 5.5, 7.5, 0, 0, 0, 0, 1, 0)
    return screen


screen = begin(900, 300, 1)
for column, kind in enumerate(("directional", "point", "spot")):
    glViewport(300 * column, 0, 300, 300)
    w = 0 if kind == "directional" else 1
    glLightfv(GL_LIGHT0, GL_POSITION, [0.3, 2.2, 0.5, w])
    if kind == "spot":
        glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, [-0.1, -1, -0.2])
        glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 45)
        glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 6)
    scene()
screen

# %% [markdown]
# ## What you should see
#
# Left the light comes from far away: parallel rays, every tile has the same angle to them and the same brightness. In
# the middle the lamp hangs 2.2 above the floor: straight below it the rays fall steeply, further out they graze. (The
# distance itself has no effect yet: lesson 23.) On the right a cone lets only a part out, brightest along its axis.

# %% [markdown]
# ## The formula
#
# All that the equation needs of a light is a unit vector $\mathbf{L}$ towards it and its intensity $I_L$ at the point $P$:
#
# $$ \text{point: } \mathbf{L} = \frac{Q - P}{|Q - P|} \qquad \text{directional: } \mathbf{L} = \text{constant} \qquad \text{spot:
# } I_L \leftarrow I_L\, (-\mathbf{L} \cdot \mathbf{D})^e $$
#
# $Q$ is the position of the lamp, $\mathbf{D}$ the unit vector of the spot's axis, $e \ge 0$ its exponent; outside of the
# cone, where the angle to the axis exceeds the cutoff, $I_L = 0$. A point light is **isotropic**: the same in all
# directions. OpenGL tells the kinds apart by the fourth number of `GL_POSITION`: $w = 1$ is a point, $w = 0$ a direction.

# %%
glsim.source("shaders/light.glsl", "if (LIGHT_IS_POSITIONAL[i]) {", lines=6)


# %% The same three lights, seen from outside: arrows for a direction, a star for a point, a cone for a spot
def three_lights():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(40, 1, 3, 14)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(0, 5.5, 7.5, 0, 0, 0, 0, 1, 0)
    positions = ([-3, 2, 0, 0], [-1.5, 2.4, 1.5, 1], [1.8, 3, 0, 1])
    for k, position in enumerate(positions):
        glEnable(GL_LIGHT0 + k)
        glLightfv(GL_LIGHT0 + k, GL_DIFFUSE, [0.4, 0.4, 0.4, 1])
        glLightfv(GL_LIGHT0 + k, GL_POSITION, position)
    glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, [0, -1, 0])
    glLightf(GL_LIGHT2, GL_SPOT_CUTOFF, 25)
    scene()


glsim.outside(three_lights)

# %% [markdown]
# **Superposition.** Two lamps light a scene as each alone would, added up, pixel by pixel and channel by channel. It is
# the reason why the illumination equation is a sum over lights.

# %% Light 0 alone, light 1 alone, and both: the third picture is the sum of the first two
screen = begin(900, 300, 1)
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
lamps = {
    GL_LIGHT0: ([-3, 2, 1, 1], [0.6, 0.45, 0.1, 1]),
    GL_LIGHT1: ([3, 2, 1, 1], [0.1, 0.2, 0.6, 1]),
}
for light, (position, color) in lamps.items():
    glLightfv(light, GL_POSITION, position)
    glLightfv(light, GL_DIFFUSE, color)
    glLightfv(light, GL_SPECULAR, [0, 0, 0, 1])
glClearColor(0, 0, 0, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
for column, on in enumerate(((GL_LIGHT0,), (GL_LIGHT1,), (GL_LIGHT0, GL_LIGHT1))):
    glViewport(300 * column, 0, 300, 300)
    for light in lamps:
        (glEnable if light in on else glDisable)(light)
    scene()
pixels = screen.pixels()[..., :3].astype(int)
first, second, both = np.split(pixels, 3, axis=1)
print("largest difference of the sum:", np.abs(first + second - both).max(), "of 255")
screen

# %% [markdown]
# ## Try this
#
# 1. Lift the point light to 22: `[3, 22, 5, 1]`. Which of the other two does it approach?
# 2. `GL_SPOT_CUTOFF` 10, then 90. And 120: what does the call say?
# 3. Make both lamps of the last figure twice as bright. Is the third picture still the sum, and if not, where?
#
# ## Questions
#
# Why is it enough to know how a surface looks in red, in green and in blue light to know it in any light of the screen?
#
# <details><summary>Answer</summary>
#
# Superposition once more: every such light is a sum of red, green and blue light, and the picture is the sum of the three
# pictures, each scaled.
#
# </details>
#
# ## Exercise
#
# Exercise 19: attenuation and spots.
