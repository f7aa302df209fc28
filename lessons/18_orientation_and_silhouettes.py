# %% [markdown]
# # 18. Orientation dependence and silhouettes
#
# Interpolated shading looks smooth until the object turns. Then bright bands crawl over it, and at its edge the lie comes
# out: the outline is still a polygon. Both have the same cause. Shading repairs colours, not geometry.

# %% [markdown]
# ## Predict
#
# A square has one white corner; the three others are black. Gouraud shading interpolates the corners' colours over the
# square. Now the square is turned by 90°, with its colours. Does the pattern turn with it?
#
# - yes: the picture is turned, and nothing else
# - no: the pattern changes, because the square is cut into triangles
# - only the brightness changes

# %% A quad with one white corner, turned by 0, 90, 180 and 270 degrees
import numpy as np

import glsim
from glsim.gl import *

screen = glsim.offscreen(840, 210)
glClearColor(0.15, 0.16, 0.2, 1)
glClear(GL_COLOR_BUFFER_BIT)
corners = [(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (-0.8, 0.8)]
for column in range(4):
    glViewport(210 * column, 0, 210, 210)
    glBegin(GL_QUADS)
    for k, corner in enumerate(corners):
        white = k == column  # which corner, in the order of the calls, is white
        glColor3f(white, white, white)
        glVertex2f(*corner)
    glEnd()
screen

# %% [markdown]
# ## What you should see
#
# Two different patterns alternate. A quad is drawn as two triangles, cut from its first to its third vertex. If the white
# corner is at an end of the cut, both triangles have it and the light spreads; if it is not, one triangle is black
# altogether, and there is a hard diagonal. The pattern depends on how the polygon is *oriented*, not on the light.

# %% [markdown]
# ## The formula
#
# Within a triangle with the corner colours $C_1, C_2, C_3$ the colour is a weighted mean:
#
# $$ C = w_1 C_1 + w_2 C_2 + w_3 C_3, \qquad w_1 + w_2 + w_3 = 1 $$
#
# The weights $w_k \in [0, 1]$ are the barycentric coordinates of the pixel, and they depend on the triangle alone. For a
# triangle the result does not depend on its orientation. For a quad it does, because the fourth corner has no weight in
# one of the two triangles. (Rasterisers of the seventies interpolated along scan lines, and the pattern changed while an
# object turned.)

# %%
glsim.source("machine/assembly.py", "return _pack(a, b, d, b, c, d) if last else")

# %% The same quad, its cut made visible
glClear(GL_COLOR_BUFFER_BIT)
for column in range(2):
    glViewport(210 * column, 0, 210, 210)
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
    order = (0, 1, 2, 0, 2, 3) if column == 0 else (1, 2, 3, 1, 3, 0)
    glBegin(GL_TRIANGLES)
    for k in order:
        glColor3f(k == 1, k == 1, k == 1)
        glVertex2f(*corners[k])
    glEnd()
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glColor3f(1, 0.5, 0.1)
    glBegin(GL_TRIANGLES)
    for k in order:
        glVertex2f(*corners[k])
    glEnd()
glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
screen

# %% [markdown]
# **Silhouettes.** Phong shading makes the inside of a coarse sphere look perfectly round. But nobody told the outline:

# %% A sphere of 8, 16 and 48 segments, Phong shaded: the inside is the same, the edge is not
glsim.compare(
    "sphere",
    modes="phong",
    segments=[8, 16, 48],
    columns="segments",
    size=300,
    samples=4,
    differences="off",
    live="edges, lights.position",
)

# %% Only the outline counts here: the same spheres without light
glsim.compare(
    "sphere",
    modes="unlit",
    segments=[8, 16, 48],
    columns="segments",
    size=300,
    samples=4,
    differences="off",
)

# %% How far the outline of a polygon with n corners lies inside of its circle, in percent of the radius
from glsim import plots

n = np.arange(4, 65)
gap = 100 * (1 - np.cos(np.pi / n))
plots.curves(
    {"gap": (n, gap)}, "corners of the outline", "gap (% of the radius)", log=True
)

# %% [markdown]
# The gap falls with the square of the number of corners: at 8 it is 7.6 % of the radius, at 48 it is 0.2 %, less than a
# pixel on a sphere of 400 pixels. So the cure is geometry: more polygons, at least where the surface turns away.
#
# ## Try this
#
# 1. Draw the first figure with `GL_POLYGON` instead of `GL_QUADS`. Is it cut in the same way?
# 2. Give each quad a fifth vertex in its middle and draw a fan of four triangles. Does the pattern still depend on the
#    orientation?
# 3. Turn the sphere of 8 segments in small steps (`--gif` of `glsim compare`): what do you notice first, the inside or the
#    edge?
#
# ## Questions
#
# How many corners must the outline of a sphere of 500 pixels radius have so that the gap is less than half a pixel?
#
# <details><summary>Answer</summary>
#
# $500\,(1 - \cos(\pi / n)) < 0.5$. With $1 - \cos x \approx x^2 / 2$: $n > \pi \sqrt{500} \approx 70.2$, so 71.
#
# </details>
#
# ## Exercise
#
# Exercise 16 (lesson 20): mend the T-vertex.
