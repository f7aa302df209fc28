# %% [markdown]
# # 2. Rendering styles
#
# An engineer of 1963 had a pen that drew lines, and no more. The same teapot, drawn as wires, as edges, as a flat
# shape and finally shaded: each step adds one thing that the eye knows how to read. Which step adds the most?

# %% [markdown]
# ## Predict
#
# A cube is drawn as a wireframe, without perspective, as seen from above. Then it is drawn as seen from below. How do
# the two line drawings differ?
#
# - the second is the first upside down
# - the lines of one are longer
# - not at all: every line is at the same place

# %% A cube from above and from below: wireframe, hidden lines removed, filled and shaded flat
import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidTeapot, glutSolidTorus


def faces():
    """The cube's six faces: the face x = 0.55, turned five times."""
    for turn in (
        (0, 0, 1, 0),
        (90, 0, 1, 0),
        (180, 0, 1, 0),
        (270, 0, 1, 0),
        (90, 0, 0, 1),
        (270, 0, 0, 1),
    ):
        glPushMatrix()
        glRotatef(*turn)
        glNormal3f(1, 0, 0)
        glBegin(GL_QUADS)
        for y, z in ((-1, 1), (-1, -1), (1, -1), (1, 1)):
            glVertex3f(0.55, 0.55 * y, 0.55 * z)
        glEnd()
        glPopMatrix()


def cube(seen):
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(-1.1, 1.1, -1.1, 1.1, -2, 2)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, [-0.3, 0.5, 1, 0])
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.35, 0.7, 0.95, 1])
    glLineWidth(2)
    if seen == "from below":
        glRotatef(180, 0, 0, 1)
    glRotatef(28, 1, 0, 0)
    glRotatef(34, 0, 1, 0)
    faces()


glsim.compare(
    cube,
    sweep={"seen": ["from above", "from below"]},
    modes="wireframe,hidden-line,flat",
    size=280,
    samples=4,
    differences="off",
    title="Where is up?",
    live="camera",
)

# %% [markdown]
# ## What you should see
#
# The two wireframes are the same picture. Stare at one for a while: it turns over by itself, the front face becomes the
# back. The drawing holds no answer, so the brain tries both. (Louis Necker described this cube in 1832.)
#
# Remove the lines that a face hides, and each cube has made up its mind: above three faces meet at a corner in
# front and we see the lid, below we see the floor. Fill the faces and let light fall on them, and even the direction of
# the lamp can be read.
#
# The wires lie at the same places because a cube looks the same when it is mirrored at its centre, and an
# orthographic projection forgets the depth. Hidden lines bring exactly the depth back.

# %% [markdown]
# ## The formula
#
# A pixel remembers the depth $z$ of what it shows, in $[0, 1]$, 1 at the far plane. A new fragment is drawn if
#
# $$ z_{new} < z_{stored} $$
#
# To hide lines: fill the polygons in the colour of the background, then draw their edges. But an edge lies *in* its
# polygon: both have the same depth, and where rounding decides, the line is frayed. So the polygons are pushed away
# a little, with `glPolygonOffset(factor, units)`:
#
# $$ z \leftarrow z + m \cdot \text{factor} + r \cdot \text{units} $$
#
# $m$ is the slope of the polygon, the largest change of $z$ from one pixel to the next; $r$ the smallest step that the
# depth buffer can tell apart, here $2^{-24}$. This line does the same for polygons that are drawn as lines:

# %%
glsim.source(
    "render/outline.py", "polygon.offset_factor * slope + polygon.offset_units"
)

# %% [markdown]
# Where a vertex is goes the same way in all styles. What differs is what is drawn between the vertices, and in which
# colour; without lighting it is the colour of `glColor`, and this line of the vertex shader is the end:

# %%
glsim.source("shaders/main.vert", "if (!LIGHTING) return;")

# %% [markdown]
# ## With two calls
#
# From wires to hidden lines in OpenGL: `glPolygonMode` says that polygons are drawn as their edges, `glPolygonOffset`
# makes room for them.

# %% A torus as wires, with hidden lines removed but no offset, and with an offset
screen = glsim.offscreen(900, 300)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 1, 1, 10)
glMatrixMode(GL_MODELVIEW)
gluLookAt(0, 3, 4, 0, 0, 0, 0, 1, 0)
glRotatef(90, 1, 0, 0)


def fill():
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
    glColor3f(0.1, 0.11, 0.14)  # the background's colour
    glutSolidTorus(0.35, 0.85, 16, 32)


def wires():
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glColor3f(0.95, 0.75, 0.3)
    glutSolidTorus(0.35, 0.85, 16, 32)


glViewport(0, 0, 300, 300)
wires()

glViewport(300, 0, 300, 300)
fill()
wires()

glViewport(600, 0, 300, 300)
glEnable(GL_POLYGON_OFFSET_FILL)
glPolygonOffset(1, 1)
fill()
wires()
screen

# %% [markdown]
# Left: all edges, front and back on top of each other. In the middle the back is hidden, but so are pieces of lines that
# should be seen: the edge and its own polygon fight for the pixel. Right: pushed back by one slope and one step, the
# polygons leave their edges alone.

# %% [markdown]
# ## All styles, one teapot
#
# Only how it is drawn changes from picture to picture.


# %% A teapot as wireframe, hidden-line, unlit, flat, Gouraud and Phong shaded
def teapot():
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
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.9, 0.5, 0.2, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, 40)
    glutSolidTeapot(0.85)


glsim.compare(
    teapot,
    modes="wireframe,hidden-line,unlit,flat,gouraud,phong",
    lobes="blinn",
    size=280,
    samples=4,
    differences="off",
    title="One teapot, six styles",
    layout="projector",
    live="camera",
)

# %% [markdown]
# - **Wireframe**: shape without solidity. Quick, and you see how the model is made of polygons.
# - **Hidden-line**: solid, but of no material.
# - **Unlit**, or blocked out in one colour: only the silhouette is left. Handle and body are one.
# - **Flat, Gouraud, Phong shaded**: light falls on it. Only now the eye sees how the surface bends. Their differences
#   are lessons 14 to 16.
#
# > **The slide says** "blocked, wireframe, & shaded". Blocked is no word of OpenGL. In between stands a style that the
# > slide leaves out: hidden-line, the one that needs the depth test.

# %% [markdown]
# ## Try this
#
# 1. Replace `glOrtho` in `cube` by `gluPerspective(30, 1, 1, 10)` and a `glTranslatef(0, 0, -4)` after
#    `glLoadIdentity()`. Are the two wireframes still the same? Can you now tell which face is in front?
# 2. Set the offset to `glPolygonOffset(-1, -1)`. What becomes of the lines?
# 3. In `wires`, set `glEnable(GL_CULL_FACE)` first and draw only the left torus. Is culling the same as removing hidden
#    lines? Look at the far inner side of the ring.

# %% [markdown]
# ## Questions
#
# For which bodies does culling of back faces alone give the hidden-line picture?
#
# <details><summary>Answer</summary>
#
# For a single convex body, such as the cube: there a face is hidden exactly if it looks away from the eye. A torus hides
# parts of itself that face us.
#
# </details>
#
# Why not draw the lines with an offset towards the eye instead of pushing the polygons away?
#
# <details><summary>Answer</summary>
#
# That works too: `GL_POLYGON_OFFSET_LINE` with negative numbers, for polygons whose mode is `GL_LINE`. Lines of
# `GL_LINES` have no slope, and OpenGL offsets polygons only; pushing the filled polygons works for both.
#
# </details>
#
# ## Exercise
#
# Exercise 2 (lesson 2): reproduce this picture: wireframe, hidden-line, filled.
