# %% [markdown]
# # 19. Perspective: hyperbolic and affine interpolation
#
# Colours, normals and texture coordinates are known at the vertices and interpolated between them. But where? A
# rasteriser walks over the *screen* in equal steps, and equal steps on the screen are no equal steps on the surface:
# perspective makes what is far away small.

# %% [markdown]
# ## Predict
#
# A fence runs away from you: it begins at a distance of 1 m and ends at 5 m. In your photograph, mark the point midway
# between its two ends. Which part of the fence is there?
#
# - its middle
# - a point near its beginning: a sixth of its length
# - a point near its end: five sixths of its length

# %% Where on the fence one is, over the place in the photograph: a hyperbola far below the straight line
import glsim

glsim.plots.interpolation((1, 5))

# %% [markdown]
# ## What you should see
#
# Midway in the picture ($s = 0.5$) only a sixth of the fence has gone by: $t = \frac16$. The near metre takes most of
# the picture; the four far ones share the rest. Whoever interpolates along the straight line, in equal steps on the
# screen, says "the middle of the fence" there, and is wrong by a third of its length.

# %% [markdown]
# ## The formula
#
# Let $w_1$ and $w_2$ be the distances of the two ends from the eye (the $w$ of clip space), $f_1$ and $f_2$ the values
# there, $s \in [0, 1]$ the place between them on the screen.
#
# $$ f_\text{affine} = (1 - s)\, f_1 + s\, f_2 \qquad
#    f_\text{hyperbolic} = \frac{(1 - s)\, f_1 / w_1 + s\, f_2 / w_2}{(1 - s) / w_1 + s / w_2} $$
#
# The second one is exact: $f / w$ and $1 / w$ *are* linear on the screen, so interpolate these, and divide at each
# pixel. With $f_1 = 0$, $f_2 = 1$, $w_1 = 1$, $w_2 = 5$, $s = \frac12$: $0.1 / (0.5 + 0.1) = \frac16$. In NumPy:

# %%
glsim.source("study/plots/curves.py", "t = s / w_2 / ((1.0 - s) / w_1 + s / w_2)")

# %% [markdown]
# Every card of today does that, and needs $w$ for it. An affine rasteriser does not know $w$. The vertex shader of
# glsim imitates it: divided by $w$ beforehand, all vertices are equally far from the eye.

# %%
glsim.source("shaders/main.vert", "float w = AFFINE ? C.w : 1.0;", lines=2)


# %% A floor of tiles as one quad, hyperbolic and affine: affine tiles bend along the diagonal of the quad
import numpy as np

from glsim.gl import *
from glsim.glu import *

HINTS = {"hyperbolic": GL_NICEST, "affine": GL_AFFINE_GLSIM}


def camera():
    glClearColor(0.12, 0.13, 0.17, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(50, 1, 0.5, 50)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 1.5, 0, 0, 0.9, -2, 0, 1, 0)


def tiles_texture():
    tile = np.zeros((64, 64, 3), np.uint8)
    tile[:] = (225, 200, 150)
    tile[:32, :32] = tile[32:, 32:] = (60, 90, 130)
    glTexImage2D(
        GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE, tile.tobytes()
    )
    for filter in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glEnable(GL_TEXTURE_2D)


def floor(strips=1):
    """A floor from z = -2 to z = -10 in so many strips."""
    for k in range(strips):
        glBegin(GL_QUADS)
        for x, row in ((-1.5, k), (1.5, k), (1.5, k + 1), (-1.5, k + 1)):
            depth = 8 * row / strips
            glTexCoord2f(x, depth / 2)
            glVertex3f(x, 0, -2 - depth)
        glEnd()


def tiled(interpolation):
    camera()
    tiles_texture()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, HINTS[interpolation])
    floor()


glsim.compare(
    tiled,
    title="one quad",
    sweep={"interpolation": ["hyperbolic", "affine"]},
    columns="interpolation",
    modes="gouraud",
    size=420,
    samples=4,
    differences="off",
    live="camera",
)

# %% [markdown]
# In the affine picture the far rows are too long and the near ones too short, and the lines break at the diagonal:
# each triangle has an affine map of its own, and the two agree along their common edge only. Games of the 1990s looked
# like this, and swam when the camera moved. `glHint` chooses between the two in glsim; the name `GL_AFFINE_GLSIM` is an
# extension for teaching, no OpenGL of today draws so.


# %% The affine floor in 1, 4 and 16 strips: the smaller the polygons, the smaller the error
def in_strips(strips):
    camera()
    tiles_texture()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, GL_AFFINE_GLSIM)
    floor(strips)


glsim.compare(
    in_strips,
    title="affine, in strips",
    sweep={"strips": [1, 4, 16]},
    columns="strips",
    modes="gouraud",
    size=290,
    samples=4,
    differences="off",
    live="camera, edges",
)

# %% [markdown]
# Cutting helps, because within a small polygon $w$ hardly changes, and with $w_1 = w_2$ the two formulas are the same.
#
# > **The slide says** "it happens in screen space, so need to use hyperbolic interpolation". That holds for *all* that
# > is interpolated: with textures everybody sees the error, but the colours of Gouraud shading and the normals of Phong
# > shading suffer just the same.


# %% Colours, too: a floor that goes from dark to bright, hyperbolic and affine, and the difference
def shaded(interpolation):
    camera()
    glHint(GL_PERSPECTIVE_CORRECTION_HINT, HINTS[interpolation])
    glBegin(GL_QUADS)
    for x, z, grey in ((-1.5, -2, 0.1), (1.5, -2, 0.1), (1.5, -10, 1), (-1.5, -10, 1)):
        glColor3f(grey, grey, grey)
        glVertex3f(x, 0, z)
    glEnd()


glsim.compare(
    shaded,
    title="colours from 0.1 to 1",
    sweep={"interpolation": ["hyperbolic", "affine"]},
    columns="interpolation",
    modes="gouraud",
    size=290,
    differences="x1",
)

# %% [markdown]
# ## Try this
#
# 1. Draw `glsim.plots.interpolation((4, 5))`. How far are the two curves apart now?
# 2. In `floor` set both `1.5` to `0.2`. Can you still see the diagonal? And the error along the depth?
# 3. Turn the floor into a wall that faces you: `glVertex3f(x, depth / 4, -4)`. Why are both pictures the same?
#
# ## Questions
#
# For which polygons does affine interpolation make no error?
#
# <details><summary>Answer</summary>
#
# For those whose vertices all have the same $w$: parallel to the image plane. And for all under an orthographic
# projection, where $w = 1$ everywhere.
#
# </details>
#
# Why is the depth in the depth buffer interpolated linearly on the screen, without the division?
#
# <details><summary>Answer</summary>
#
# The depth of window coordinates has been divided by $w$ already: it is $a + b / w$ with constants $a$ and $b$, and
# $1 / w$ is linear on the screen.
#
# </details>
#
# ## Exercise
#
# Exercise 15 (lesson 19): hyperbolic interpolation.
