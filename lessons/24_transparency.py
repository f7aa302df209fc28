# %% [markdown]
# # 24. Transparency and blending
#
# Glass lets light through. A rasteriser does not follow it: it paints a pixel and forgets what was there. What it can do
# is mix: a part of the new colour, a part of the old one. That is **blending**, and it has one catch: the order.

# %% [markdown]
# ## Predict
#
# A red and a blue pane, each half transparent, overlap before a white wall. The nearer one is red. You draw the blue one
# last, over the red one. What colour has the overlap?
#
# - purple, the same in either order: a mixture is a mixture
# - too blue: as if the blue pane were in front
# - white: half of each cancels

# %% Two panes that cover each a half: red drawn last, as it should be, and blue drawn last
import numpy as np

import glsim
from glsim.gl import *

RED, BLUE = [0.9, 0.1, 0.1, 0.5], [0.1, 0.2, 0.9, 0.5]


def pane(color, left, bottom):
    glColor4fv(color)
    glRectf(left, bottom, left + 1.0, bottom + 1.0)


screen = glsim.offscreen(640, 320)
glClearColor(1, 1, 1, 1)
glClear(GL_COLOR_BUFFER_BIT)
glEnable(GL_BLEND)
glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
panes = [(BLUE, -0.7, -0.3), (RED, -0.3, -0.7)]  # far, near
for column, order in enumerate((panes, panes[::-1])):
    glViewport(320 * column, 0, 320, 320)
    for color, left, bottom in order:
        pane(color, left, bottom)
screen

# %% [markdown]
# ## What you should see
#
# Left, back to front, the overlap is a reddish purple: the near pane counts more. Right it is bluish, though the panes
# are the same: the far pane was laid over the near one. Mixing is not symmetric, the last one wins.

# %% [markdown]
# ## The formula
#
# $$ C = \alpha_s\, C_s + (1 - \alpha_s)\, C_d $$
#
# $C_s$ (source) is the colour that is drawn, $\alpha_s \in [0, 1]$ its opacity, $C_d$ (destination) what the picture holds
# already. It is what `glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)` says: the two names are the two factors. In
# other words `GL_SRC_ALPHA` covers, and the rest shines through.

# %%
glsim.source("study/fragments.py", "GL_ONE_MINUS_SRC_ALPHA", lines=1)

# %% The same by hand: the overlap in both orders, out of 255
white = np.ones(3)


def over(pane, behind):
    return pane[3] * np.array(pane[:3]) + (1 - pane[3]) * behind


for name, order in (("red last", (BLUE, RED)), ("blue last", (RED, BLUE))):
    color = white
    for layer in order:
        color = over(layer, color)
    print(f"{name:10} {(255 * color).round().astype(int)}")
print("picture   ", screen.pixels()[160, 160, :3], screen.pixels()[160, 480, :3])

# %% [markdown]
# With a depth buffer it is worse: a near transparent surface that is drawn *first* writes its depth, and what lies behind
# is rejected although it should shine through. The recipe of every fixed-function program is therefore:
#
# 1. draw everything opaque, with the depth test and depth writes on;
# 2. switch depth *writes* off (`glDepthMask(GL_FALSE)`), leave the test on;
# 3. draw the transparent surfaces **from back to front**.

# %% Three glass spheres: drawn front to back with depth writes, and back to front without
from glsim.glu import gluPerspective
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(760, 320, samples=4)
glClearColor(0.85, 0.88, 0.92, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glEnable(GL_CULL_FACE)
glShadeModel(GL_PHONG_WIN)
glEnable(GL_BLEND)
glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 2, 2, 0])
glMaterialfv(GL_FRONT, GL_SPECULAR, [1, 1, 1, 1])
glMaterialf(GL_FRONT, GL_SHININESS, 80)
glMatrixMode(GL_PROJECTION)
gluPerspective(32, 380 / 320, 1, 20)
glMatrixMode(GL_MODELVIEW)
spheres = [(-0.8, -7.0, [0.1, 0.3, 0.9, 0.5]), (0.0, -6.0, [0.1, 0.7, 0.2, 0.5]),
           (0.75, -5.0, [0.9, 0.2, 0.1, 0.5])]  # x, z, colour: far to near  # fmt: skip
for column, (order, writes) in enumerate(((spheres[::-1], True), (spheres, False))):
    glViewport(380 * column, 0, 380, 320)
    glDepthMask(writes)
    for x, z, color in order:
        glLoadIdentity()
        glTranslatef(x, 0, z)
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color)
        glutSolidSphere(0.85, 48, 32)
screen

# %% [markdown]
# On the left the spheres cut holes into each other. On the right each shines through those in front of it.
#
# What blending does not do: bend the light (lesson 5), tint the shadow, or sort two surfaces that pass through each
# other. Those need rays.
#
# ## Try this
#
# 1. `glBlendFunc(GL_ONE, GL_ONE)`: light adds up instead of covering. Why does the order no longer matter?
# 2. Make the far pane opaque, alpha 1. Which of the two orders hides the other pane altogether?
# 3. In the last figure disable `GL_CULL_FACE`. Which surfaces of a sphere are seen then, and in which order do they come?
#
# ## Questions
#
# Two panes with alpha 0.5 lie over each other. How much of the wall behind still shines through, and does the order matter
# for that?
#
# <details><summary>Answer</summary>
#
# $(1 - 0.5)(1 - 0.5) = 0.25$, in either order. Only the shares of the two panes depend on it: 0.5 for the near one and
# 0.25 for the far one.
#
# </details>
#
# ## Exercise
#
# Exercise 20 (lesson 24): the order of blending.
