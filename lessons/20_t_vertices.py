# %% [markdown]
# # 20. T-vertices
#
# A floor is made of tiles. Beside one large tile lie two small ones, and where the two meet, a vertex touches the middle
# of the large tile's edge. It looks harmless in the wireframe. In the picture there is a crease, and sometimes a row of
# sparkling dots.

# %% [markdown]
# ## Predict
#
# A wavy sheet is lit at its vertices. Along one line its left half has twice as many vertices as its right half. Both
# halves have correct normals everywhere. What is seen along the line?
#
# - nothing, if the normals are right
# - the shading breaks: left and right of the line the colours differ
# - a gap in the colour of the background, everywhere

# %% Left: a sheet whose halves have different vertices along the middle. Right: the extra vertices given to both halves
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective


def height(x, z):
    return 0.25 * np.sin(2.4 * x + 0.9) * np.cos(2.1 * z)


def vertex(x, z):
    """A vertex of the sheet with its exact normal."""
    slope_x = 0.6 * np.cos(2.4 * x + 0.9) * np.cos(2.1 * z)
    slope_z = -0.525 * np.sin(2.4 * x + 0.9) * np.sin(2.1 * z)
    glNormal3f(-slope_x, 1, -slope_z)
    glVertex3f(x, height(x, z), z)


def half(x_0, x_1, rows):
    """A strip of quads from x_0 to x_1 with this number of rows along z."""
    for k in range(rows):
        z, following = -2 + 4 * k / rows, -2 + 4 * (k + 1) / rows
        glBegin(GL_TRIANGLES)
        for x, depth in ((x_0, z), (x_0, following), (x_1, following),
                         (x_0, z), (x_1, following), (x_1, z)):  # fmt: skip
            vertex(x, depth)
        glEnd()


def sheet(rows_right):
    for k in range(3):
        half(-1.5 + k / 2, -1 + k / 2, 12)
        half(0 + k / 2, 0.5 + k / 2, rows_right)


def scene(width, height_):
    screen = glsim.offscreen(width, height_, samples=4)
    glClearColor(0.75, 0.1, 0.5, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glEnable(GL_NORMALIZE)
    glLightfv(GL_LIGHT0, GL_POSITION, [0.6, 1, 0.3, 0])
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [0.85, 0.85, 0.8, 1])
    glMatrixMode(GL_PROJECTION)
    gluPerspective(30, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(1.2, 5.2, 5.2, 0, 0, 0, 0, 1, 0)
    return screen


screen = scene(840, 420)
for column, rows in enumerate((3, 12)):
    glViewport(420 * column, 0, 420, 420)
    sheet(rows)
screen

# %% [markdown]
# ## What you should see
#
# On the left there is a seam down the middle: the left half follows the wave at 13 vertices, the right half only at 4 and
# straight in between. Where the left half has a vertex in the middle of a right edge, a **T-vertex**, the colours differ,
# and so do the *places*: through the gaps shines the background, pink here. On the right both halves have all vertices,
# and the seam is gone.

# %% [markdown]
# ## The formula
#
# Along the long edge from $P_1$ to $P_2$ the large polygon has the colour
#
# $$ C(t) = (1 - t)\, C_1 + t\, C_2, \qquad t \in [0, 1] $$
#
# The T-vertex $T$ at $t = \frac12$ has its own colour $C_T$, computed by the lighting equation there. The seam is
# invisible only if $C_T = C(\frac12)$, which is true for a plane in uniform light and for hardly anything else. For the
# position it is the same: $T$ must lie on the line from $P_1$ to $P_2$, and rounding to pixels may move it off even then.

# %%
glsim.source("shaders/main.vert", "vec4 C = transform.modelview_projection * P;")

# %% The same seam as edges: each T is a vertex of the left half on an edge of the right one
screen = scene(420, 420)
glDisable(GL_LIGHTING)
glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
glColor3f(1, 1, 1)
sheet(3)
screen

# %% [markdown]
# The cure: **no vertex may lie inside of another polygon's edge**. Give the long edge that vertex as well, which makes the
# large quad a polygon with five corners, and cut it into triangles. Programs that refine meshes, for terrain or for
# radiosity, spend much care on it.
#
# > **The slide says** that colours change "if polygon order changes" without smooth normals. The T-vertex is the worst
# > case, and it stays with smooth normals: only a shared vertex has one colour for all its polygons.
#
# ## Try this
#
# 1. Use `glShadeModel(GL_PHONG_WIN)`. The seam of the colours is weaker, but not gone; why?
# 2. Make the sheet flat, `return 0`. Is there still a seam with a light far away, and with one close by?
# 3. 12 against 6 rows instead of 3: how does the seam change?
#
# ## Questions
#
# A terrain has fine tiles near the eye and coarse ones far away. How do you avoid T-vertices at the border?
#
# <details><summary>Answer</summary>
#
# Let the fine tile's edge use only the vertices of the coarse one (move or leave out every second vertex there), or add a
# strip of triangles that joins both. A vertical skirt hides the gaps, but not the different colours.
#
# </details>
#
# ## Exercise
#
# Exercise 16: mend the T-vertex.
