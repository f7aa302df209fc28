# %% [markdown]
# # 19. Perspective: hyperbolic against affine interpolation
#
# A road runs to the horizon. Halfway between its near and its far end *on the screen* one is not halfway down the road,
# but much further. Whoever interpolates as if one were gets the wobbling floors of the first game consoles.

# %% [markdown]
# ## Predict
#
# A checkerboard of 8 x 8 fields lies on the floor, as one square of two triangles. The texture coordinates are
# interpolated linearly over the *screen*. How does the board look?
#
# - right, only less sharp
# - bent along the diagonal where the triangles meet, and the far fields as long as the near ones
# - mirrored

# %% Hyperbolic interpolation (right), and affine interpolation: linear on the screen
import numpy as np

import glsim
from glsim import plots
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective


def begin(width, height):
    screen = glsim.offscreen(width, height, samples=4)
    glClearColor(0.55, 0.68, 0.85, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    y, x = np.mgrid[0:64, 0:64]
    board = np.where(((x // 8 + y // 8) % 2)[..., None], [245, 240, 225], [60, 50, 55])
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 board.astype(np.uint8))  # fmt: skip
    glMatrixMode(GL_PROJECTION)
    gluPerspective(50, 400 / 300, 0.1, 50)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(0, 1, 1.6, 0, 0, -2, 0, 1, 0)
    return screen


def floor(cuts=1):
    """The board from z = 0 to -6, cut into cuts x cuts squares."""
    glEnable(GL_TEXTURE_2D)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glBegin(GL_QUADS)
    for i in range(cuts):
        for j in range(cuts):
            for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                s, t = (i + a) / cuts, (j + b) / cuts
                glTexCoord2f(s, t)
                glVertex3f(-1.5 + 3 * s, 0, -6 * t)
    glEnd()


screen = begin(800, 300)
for column, hint in enumerate((GL_AFFINE_GLSIM, GL_NICEST)):
    glViewport(400 * column, 0, 400, 300)
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, hint)
    floor()
screen

# %% [markdown]
# ## What you should see
#
# On the left the lines break at the diagonal, and the far fields are as long as the near ones, although they should
# shrink. On the right they do. Both pictures have the same vertices and the same texture coordinates there.
#
# (No driver does the left one today. `GL_AFFINE_GLSIM` is glsim's own value for a hint that had this very meaning in 1992:
# whether to correct for perspective, because the correction cost a division for each pixel.)

# %% [markdown]
# ## The formula
#
# Let $s$ be the place between two vertices *on the screen*, in $[0, 1]$, and $w_1$, $w_2$ their distances from the eye.
# Affine interpolation takes $(1 - s)\, a_1 + s\, a_2$. But the projection divides by $w$, and what is linear on the screen
# is $a / w$ and $1 / w$. So interpolate these, and divide:
#
# $$ a(s) = \frac{(1 - s)\, \dfrac{a_1}{w_1} + s\, \dfrac{a_2}{w_2}}{(1 - s)\, \dfrac{1}{w_1} + s\, \dfrac{1}{w_2}} $$
#
# $a$ is anything that belongs to the vertices: a colour, a normal, a texture coordinate. The graph is a hyperbola, hence
# the name. If $w_1 = w_2$, both formulas are the same.

# %%
glsim.source("shaders/main.vert", "float w = AFFINE ? C.w : 1.0;", lines=2)

# %% Place along an edge from distance 1 to distance 5: in the middle of the screen only a sixth of the way is done
plots.interpolation((1, 5))

# %% The same numbers by hand
w_1, w_2, s = 1.0, 5.0, 0.5
hyperbolic = (s * 1 / w_2) / ((1 - s) / w_1 + s / w_2)
print(f"middle of the screen: affine {s:.3f}, hyperbolic {hyperbolic:.3f}")

# %% The cheat of the consoles: cut the floor into 1, 2, 4 and 16 pieces, each interpolated affinely
screen = begin(800, 600)
glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
for k, cuts in enumerate((1, 2, 4, 16)):
    glViewport(400 * (k % 2), 300 - 300 * (k // 2), 400, 300)
    floor(cuts)
screen

# %% [markdown]
# The smaller the piece, the nearer $w_1$ and $w_2$, and the smaller the error. Games cut walls into small pieces for this
# reason alone.
#
# The same holds for Gouraud's *colours* and Phong's *normals*; there the error is seldom noticed, because colours change
# slowly. The depth $z$ is the exception: the projection has made it linear on the screen already.
#
# > **The slide says** "it happens in screen space, so need to use hyperbolic interpolation". To be exact: the
# > *rasteriser* works in screen space, and that is why it must interpolate $a/w$ and $1/w$ instead of $a$.
#
# ## Try this
#
# 1. Look straight down at the board, `gluLookAt(0, 4, -3, 0, 0, -3.01, 0, 1, 0)`: is there a difference left?
# 2. Draw the board with corner colours instead of a texture. Can you tell the two apart?
# 3. `plots.interpolation((1, 50))`: where on the screen is the middle of a road to the horizon?
#
# ## Questions
#
# An edge runs from the distance 2 to the distance 6. Which part of it do the first 50 % on the screen show?
#
# <details><summary>Answer</summary>
#
# $\dfrac{0.5 / 6}{0.5 / 2 + 0.5 / 6} = \dfrac{1}{4}$: a quarter of the edge, the near one.
#
# </details>
#
# ## Exercise
#
# Exercise 15: hyperbolic interpolation.
