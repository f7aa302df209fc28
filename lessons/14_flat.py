# %% [markdown]
# # 14. Flat shading
#
# The equation says how bright one *point* is. A polygon has infinitely many. The cheapest answer of all: pick one point,
# evaluate once, and paint the whole polygon with the result. Which point, though?

# %% [markdown]
# ## Predict
#
# A triangle gets three vertex colours, in this order: red, green, blue. Under `GL_SMOOTH` they run into each other. Which
# colour has the triangle under `GL_FLAT`?
#
# - red, the first
# - blue, the last
# - grey, the mean of the three

# %% The same triangle under GL_SMOOTH and under GL_FLAT
import glsim
from glsim.gl import *
from glsim.glu import gluPerspective

screen = glsim.offscreen(720, 300, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT)
for column, mode in enumerate((GL_SMOOTH, GL_FLAT)):
    glViewport(30 + 360 * column, 0, 300, 300)
    glShadeModel(mode)
    glBegin(GL_TRIANGLES)
    glColor3f(0.9, 0.2, 0.15)
    glVertex2f(-0.85, -0.75)
    glColor3f(0.2, 0.75, 0.3)
    glVertex2f(0.85, -0.75)
    glColor3f(0.2, 0.4, 0.95)
    glVertex2f(0, 0.85)
    glEnd()
screen

# %% [markdown]
# ## What you should see
#
# Blue. OpenGL mixes nothing: it takes the colour of *one* vertex, the **provoking vertex**, and that is the last one of a
# triangle. When its vertex arrives, the triangle is complete and can be drawn; its colour is at hand.

# %% [markdown]
# ## The formula
#
# $$ C = I(\mathbf{N}_k, \mathbf{P}_k) $$
#
# $C$ is the colour of every pixel of the polygon, $I$ the illumination equation, $k$ the number of the provoking vertex
# with its unit normal $\mathbf{N}_k$ and its position $\mathbf{P}_k$. The equation still runs at every vertex, and all
# results but one are thrown away. In GLSL this is one word: where these lines say `SHADED`, `GL_FLAT` puts `flat`, and the
# rasteriser stops interpolating.

# %%
glsim.source("shaders/main.vert", "SHADED out vec4 front_color;", lines=2)

# %% Flat shading with 8, 16, 32 and 64 segments: keys 1 to 4 swap the pictures in place
glsim.compare(
    "sphere",
    modes="flat",
    sweep={"segments": [8, 16, 32, 64]},
    columns="segments",
    size=340,
    samples=4,
    differences="off",
    live="edges, lights.position",
)

# %% [markdown]
# More polygons help less than you would think. At 64 segments neighbouring facets are turned by 6° only, and the edges
# are visible still: the eye exaggerates a step of brightness, darker on the dark side and brighter on the bright one. These
# are **Mach bands**, and they made people look for something better than more polygons.

# %% [markdown]
# ## Which vertex provokes?
#
# Six vertices, sent in the order from dark (1) to light (6), make triangles, a strip, a fan, and a polygon. Each
# primitive has its own rule: the last vertex of a triangle, of a quad too, but the *first* of a `GL_POLYGON`.

# %% Six vertices from dark to light as GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN and GL_POLYGON, flat
from math import cos, sin, tau

ring = [(0.85 * cos(k * tau / 6), 0.85 * sin(k * tau / 6)) for k in range(6)]
zigzag = [(-0.8 + 0.32 * k, -0.5 if k % 2 == 0 else 0.5) for k in range(6)]
pairs = [(-0.9, -0.5), (-0.1, -0.5), (-0.5, 0.5), (0.1, -0.5), (0.9, -0.5), (0.5, 0.5)]
figures = (
    (GL_TRIANGLES, pairs),
    (GL_TRIANGLE_STRIP, zigzag),
    (GL_TRIANGLE_FAN, ring),
    (GL_POLYGON, ring),
)
screen = glsim.offscreen(880, 220, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT)
glShadeModel(GL_FLAT)
for column, (primitive, points) in enumerate(figures):
    glViewport(220 * column, 0, 220, 220)
    glBegin(primitive)
    for number, (x, y) in enumerate(points, 1):
        glColor3f(0.12 + 0.14 * number, 0.12 + 0.11 * number, 0.16)
        glVertex2f(x, y)
    glEnd()
screen

# %% [markdown]
# ## One vertex, but whose normal?
#
# OpenGL uses the normal that was current at the provoking vertex. If that is the normal of the *round* sphere, the facet
# is lit as if it were turned towards its corner. Give it the normal of the facet itself, and it is lit as the flat piece
# that it is.

# %% Eight-sided columns, flat: with the round column's normals, and with the normals of the sides
screen = glsim.offscreen(720, 320, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_FLAT)
glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, 1, 0])  # from the eye
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.85, 0.7, 0.4, 1])
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 360 / 320, 1, 10)
glMatrixMode(GL_MODELVIEW)
glTranslatef(0, 0, -6)
glRotatef(22.5, 0, 1, 0)  # one side faces the eye
for column, turn in enumerate((0.0, 0.5)):
    glViewport(360 * column, 0, 360, 320)
    glBegin(GL_QUADS)
    for side in range(8):
        for k, y in ((side, 1), (side, -1), (side + 1, -1), (side + 1, 1)):
            a = k * tau / 8
            n = (
                a if turn == 0 else (side + turn) * tau / 8
            )  # of the vertex, or the side
            glNormal3f(sin(n), 0, cos(n))
            glVertex3f(sin(a), y, cos(a))
    glEnd()
screen

# %% [markdown]
# The light comes from the eye and the column is symmetric; the right picture is too. The left is not. Each side takes the
# normal of its right edge: the one on the left that of its inner edge, which is as bright as the front; the one on the
# right that of its outer edge, which is nearly turned away.
#
# > **The slide says** "we could just do it once per polygon". It leaves open where. The answer decides the picture: with
# > OpenGL the provoking vertex, so the *order* in which you send the vertices changes the colour.
#
# ## Try this
#
# 1. In the first program send the blue vertex first. Which colour has the triangle now?
# 2. Swap the four corners of a side, `((side + 1, -1), (side + 1, 1), (side, 1), (side, -1))`: what happens to the left
#    column, and why not to the right one?
# 3. Set the light's position in the last program to `[1, 0, 0.3, 0]`: how many different colours do you count?
#
# ## Questions
#
# A sphere of 24 × 12 quads is lit by one light and drawn flat. How often is the equation evaluated, and how many of the
# results are seen?
#
# <details><summary>Answer</summary>
#
# With `glBegin(GL_QUADS)` at all $4 \cdot 288 = 1152$ vertices. At most 288 results are used, one for each quad, and about half
# of them are on the side that faces away.
#
# </details>
#
# ## Exercise
#
# Exercise 11 (lesson 14): flat shading by hand.
