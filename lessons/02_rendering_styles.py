# %% [markdown]
# # 2. Rendering styles
#
# The same teapot can be drawn as a cage of wires, as an engineer's drawing, as a cut-out shape, or as porcelain. The
# vertices are the same every time. What changes is what the rasteriser does with the polygons between them.

# %% [markdown]
# ## Predict
#
# In a wireframe one sees front and back at once. An engineer's drawing shows only the edges that are really visible.
# How does one get the second from the first?
#
# - sort the edges by their distance and leave the far half out
# - draw the polygons too, but invisibly, so that they hide what is behind them
# - leave out the polygons that face away

# %% The teapot as wireframe, with hidden lines removed, as a flat shape, and shaded
import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidCube, glutSolidSphere, glutSolidTorus

styles = ["wireframe", "hidden-line", "unlit", "phong"]
glsim.compare(
    "teapot:6", modes=styles, lobes="blinn", size=300, samples=4, differences="off"
)

# %% [markdown]
# ## What you should see
#
# The wireframe is honest and confusing. With hidden lines removed the pot has a front. "Unlit" is a silhouette: without
# shading there is no shape. Only light makes it solid.
#
# The trick of the second picture is the second answer: polygons are drawn into the *depth buffer* only. Leaving out what
# faces away works for a convex body, but not for a teapot, whose spout can hide its own body.

# %% [markdown]
# ## The formula
#
# Hidden lines and surfaces are decided for each pixel by the depth buffer: a fragment with the depth $z$ is kept if
#
# $$ z < z_\mathrm{buffer}(x, y) $$
#
# and then $z$ replaces the number in the buffer. $z \in [0, 1]$ is 0 at the near plane and 1 at the far plane;
# `glClear(GL_DEPTH_BUFFER_BIT)` sets the buffer to 1, and `glEnable(GL_DEPTH_TEST)` switches the test on. The style of a
# polygon is `glPolygonMode`: `GL_FILL`, `GL_LINE` or `GL_POINT`.

# %%
glsim.source("study/fragments.py", "gl.GL_LESS: lambda a, b: a < b")


# %% Blocked, wireframe and shaded: glPolygonMode with GL_POINT, GL_LINE and GL_FILL
def things():
    cube = -1.3, lambda: glutSolidCube(1)
    ball = 0.1, lambda: glutSolidSphere(0.6, 16, 12)
    ring = 1.6, lambda: glutSolidTorus(0.22, 0.5, 12, 20)
    for x, draw in (cube, ball, ring):
        glPushMatrix()
        glTranslatef(x, 0, 0)
        glRotatef(-35, 1, 0.6, 0)
        draw()
        glPopMatrix()


screen = glsim.offscreen(900, 220, samples=4)
glClearColor(0.97, 0.97, 0.95, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 300 / 220, 1, 20)
glMatrixMode(GL_MODELVIEW)
gluLookAt(0.15, 1.2, 6.6, 0.15, 0, 0, 0, 1, 0)
glColor3f(0.1, 0.12, 0.2)
glPointSize(3)
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 2, 3, 0])
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.85, 0.45, 0.15, 1])
glEnable(GL_LIGHT0)
for column, mode in enumerate((GL_POINT, GL_LINE, GL_FILL)):
    glViewport(300 * column, 0, 300, 220)
    glPolygonMode(GL_FRONT_AND_BACK, mode)
    (glEnable if mode == GL_FILL else glDisable)(GL_LIGHTING)
    things()
screen

# %% [markdown]
# Now the hidden-line style by hand. First the polygons are filled with the colour of the paper, pushed a little away from
# the eye with `glPolygonOffset`; then their edges are drawn. Edges behind a polygon fail the depth test.

# %% Hidden lines: fill with the paper's colour, then draw the edges. Without the offset (right) lines and faces fight
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glDisable(GL_LIGHTING)
for column, offset in enumerate((True, False)):
    glViewport(75 + 450 * column, 0, 300, 220)
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
    (glEnable if offset else glDisable)(GL_POLYGON_OFFSET_FILL)
    glPolygonOffset(1, 1)
    glColor3f(0.97, 0.97, 0.95)
    things()
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glColor3f(0.1, 0.12, 0.2)
    things()
screen

# %% [markdown]
# ## Try this
#
# 1. Use `glEnable(GL_CULL_FACE)` with `GL_LINE` and no filling: which of the three bodies is drawn right, and why?
# 2. Leave out `glEnable(GL_DEPTH_TEST)` with `GL_FILL`. What decides what is seen then?
# 3. Set `glLineWidth(3)` and `glEnable(GL_LINE_STIPPLE)` for the edges.
#
# ## Questions
#
# Why does the offset push the *faces* back instead of pulling the *lines* forward?
#
# <details><summary>Answer</summary>
#
# The offset grows with the slope of the polygon, which a line does not have. (`GL_POLYGON_OFFSET_LINE` exists, too: it
# is for polygons that are drawn as outlines.)
#
# </details>
#
# ## Exercise
#
# Exercise 2: reproduce a picture, in three styles.
