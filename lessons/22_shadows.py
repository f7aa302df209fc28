# %% [markdown]
# # 22. Shadows
#
# In the local model every light shines on every point, through walls and tables. Without shadows things float: the eye
# takes the shadow to tell where they stand. OpenGL has none. It has three ways to make them.

# %% [markdown]
# ## Predict
#
# A ball floats above a floor. In the second picture only its shadow is drawn further to the right and lower; the ball
# itself is the same, pixel by pixel. What do you see?
#
# - the same ball, and a wrong shadow
# - a ball that hangs higher above the floor
# - a larger ball

# %% The same ball with a shadow near by and further away
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidSphere, glutSolidTorus

LAMP = np.array([-1.5, 4.0, 1.5])


def begin(width, height, aspect):
    screen = glsim.offscreen(width, height, samples=4)
    glClearColor(0.13, 0.14, 0.17, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_CULL_FACE):
        glEnable(capability)
    glShadeModel(GL_PHONG_WIN)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(34, aspect, 1, 30)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(0, 3, 6.5, 0, 0.6, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [*LAMP, 1])
    return screen


def color(r, g, b):
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [r, g, b, 1])


def floor():
    color(0.8, 0.78, 0.72)
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-9, 9), (9, 9), (9, -9), (-9, -9)):
        glVertex3f(x, 0, z)
    glEnd()


def ball(height=1.1):
    glPushMatrix()
    glTranslatef(0, height, 0)
    glutSolidSphere(0.5, 48, 32)
    glPopMatrix()


def flat_shadow(draw, lamp):
    """Draw something flattened onto the floor, y = 0, as seen from the lamp."""
    x, y, z = lamp
    M = np.array([[y, -x, 0, 0], [0, 0, 0, 0], [0, -z, y, 0], [0, -1, 0, y]])
    glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT)
    glDisable(GL_LIGHTING)
    glDisable(GL_CULL_FACE)
    glEnable(GL_POLYGON_OFFSET_FILL)
    glPolygonOffset(-1, -4)
    glColor3f(0.18, 0.17, 0.17)
    glPushMatrix()
    glMultMatrixd(M.T)
    draw()
    glPopMatrix()
    glPopAttrib()


screen = begin(760, 320, 380 / 320)
for column, height in enumerate((0.55, 1.8)):
    glViewport(380 * column, 0, 380, 320)
    floor()
    flat_shadow(lambda height=height: ball(height), LAMP)
    color(0.85, 0.3, 0.15)
    ball(1.1)  # the same in both pictures
screen

# %% [markdown]
# ## What you should see
#
# The right ball hangs higher, although not one of its pixels has changed. The distance between a thing and its shadow
# is how we see the distance to the floor.

# %% [markdown]
# ## The formula
#
# **Planar shadows** flatten the object: from the lamp $(l_x, l_y, l_z)$ every point is projected onto the floor $y = 0$, by a
# matrix that is multiplied onto the modelview matrix:
#
# $$ \begin{pmatrix} l_y & -l_x & 0 & 0 \\ 0 & 0 & 0 & 0 \\ 0 & -l_z & l_y & 0 \\ 0 & -1 & 0 & l_y \end{pmatrix} $$
#
# A point at the height $y$ gets $w = l_y - y$, and the division by $w$ does the projection. The object is drawn once more,
# flat and dark, a little in front of the floor (`glPolygonOffset`). It is exact, cheap, and works for planes only.

# %%
glsim.source("shaders/main.vert", "vec4 C = transform.modelview_projection * P;")

# %% [markdown]
# **Shadow volumes** work for all surfaces. The space behind an object, seen from the lamp, is a truncated cone without a
# far end. Draw its sides into the *stencil buffer* only: +1 for each side that faces the eye and lies in front of what is
# seen, −1 for each that faces away. Where the count is not 0, the point lies inside: in the shadow.

# %% A shadow volume: its sides made visible, the stencil count as picture, and the shadow on floor, block and step
RING = [
    (0.75 * np.cos(t), 1.5, 0.75 * np.sin(t)) for t in np.linspace(0, 2 * np.pi, 5)[:-1]
]


def plate():
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for corner in RING[::-1]:
        glVertex3fv(corner)
    glEnd()
    glNormal3f(0, -1, 0)
    glBegin(GL_QUADS)
    for corner in RING:
        glVertex3fv(corner)
    glEnd()


def block():
    color(0.35, 0.5, 0.75)
    glPushMatrix()
    glTranslatef(0.9, 0.35, -0.3)
    glScalef(1, 0.7, 1)
    glEnable(GL_NORMALIZE)
    from glsim.glut import glutSolidCube

    glutSolidCube(1)
    glPopMatrix()


def volume():
    """The sides of the shadow volume of the plate, with fronts outwards."""
    far = [np.array(c) + 6 * (np.array(c) - LAMP) for c in RING]
    glBegin(GL_QUADS)
    for k in range(4):
        a, b = k, (k + 1) % 4
        for corner in (RING[a], far[a], far[b], RING[b])[::-1]:
            glVertex3fv(corner)
    glEnd()


def lit_scene():
    floor()
    block()
    color(0.85, 0.3, 0.15)
    plate()


screen = begin(900, 260, 300 / 260)
for column in range(3):
    glViewport(300 * column, 0, 300, 260)
    lit_scene()
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glDisable(GL_LIGHTING)
    glDepthMask(GL_FALSE)
    if column == 0:  # the sides, half transparent
        glEnable(GL_BLEND)
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        glColor4f(1, 0.9, 0.3, 0.25)
        glDisable(GL_CULL_FACE)
        volume()
        glPopAttrib()
        continue
    glColorMask(0, 0, 0, 0)
    glEnable(GL_STENCIL_TEST)
    for face, change in ((GL_BACK, GL_INCR), (GL_FRONT, GL_DECR)):
        glCullFace(face)  # first the fronts are left: +1, then the backs: -1
        glStencilOp(GL_KEEP, GL_KEEP, change)
        volume()
    glColorMask(1, 1, 1, 1)
    glStencilFunc(GL_NOTEQUAL, 0, 255)
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)
    glDepthFunc(GL_LEQUAL)
    glCullFace(GL_BACK)
    if column == 1:  # what was counted
        glColor3f(1, 0.9, 0.3)
        glDepthFunc(GL_ALWAYS)
        glMatrixMode(GL_PROJECTION)
        glPushMatrix()
        glLoadIdentity()
        glMatrixMode(GL_MODELVIEW)
        glPushMatrix()
        glLoadIdentity()
        glRectf(-1, -1, 1, 1)
        glPopMatrix()
        glMatrixMode(GL_PROJECTION)
        glPopMatrix()
        glMatrixMode(GL_MODELVIEW)
    else:  # the scene once more where the count is not 0, with the ambient light alone
        glEnable(GL_LIGHTING)
        glDisable(GL_LIGHT0)
        lit_scene()
    glPopAttrib()
screen

# %% [markdown]
# **Shadow maps** turn the question round: what does the *lamp* see? Render the scene from the lamp and keep the depth
# buffer as a texture. A point is lit if it is as near to the lamp as what the lamp sees in that direction. Since OpenGL
# 1.4 the texture unit makes that comparison: `GL_COMPARE_R_TO_TEXTURE`, with coordinates generated by `glTexGen`.

# %% What the lamp sees, as depth: near is dark
SIZE = 1024


def lamp_view():
    gluPerspective(110, 1, 1.5, 12)
    gluLookAt(*LAMP, 0.3, 0, -0.2, 0, 0, -1)


def things():
    lit_scene()
    color(0.3, 0.65, 0.35)
    glPushMatrix()
    glTranslatef(-1.2, 0.45, 0.6)
    glRotatef(60, 1, 0.4, 0)
    glutSolidTorus(0.15, 0.35, 20, 40)
    glPopMatrix()


lamp_eye = glsim.offscreen(SIZE, SIZE)
glEnable(GL_DEPTH_TEST)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glMatrixMode(GL_PROJECTION)
lamp_view()
glMatrixMode(GL_MODELVIEW)
glEnable(GL_POLYGON_OFFSET_FILL)
glPolygonOffset(2, 4)  # against a surface's shadow on itself
things()
depth = glReadPixels(0, 0, SIZE, SIZE, GL_DEPTH_COMPONENT, GL_FLOAT)

from PIL import Image

nearest, middle = lamp_eye.depth().min(), lamp_eye.depth()[250:-250, 250:-250]
shown = np.clip((middle - nearest) / (np.quantile(middle, 0.99) - nearest), 0, 1)
Image.fromarray((255 * shown).astype(np.uint8)).resize((420, 420))

# %% The picture with the comparison: first the ambient light alone, then the lamp's light where the map says "lit"
screen = begin(700, 420, 700 / 420)
glTexImage2D(
    GL_TEXTURE_2D,
    0,
    GL_DEPTH_COMPONENT,
    SIZE,
    SIZE,
    0,
    GL_DEPTH_COMPONENT,
    GL_FLOAT,
    depth,
)
settings = {
    GL_TEXTURE_MIN_FILTER: GL_LINEAR,
    GL_TEXTURE_MAG_FILTER: GL_LINEAR,
    GL_TEXTURE_WRAP_S: GL_CLAMP_TO_EDGE,
    GL_TEXTURE_WRAP_T: GL_CLAMP_TO_EDGE,
    GL_TEXTURE_COMPARE_MODE: GL_COMPARE_R_TO_TEXTURE,
    GL_TEXTURE_COMPARE_FUNC: GL_LEQUAL,
}
for name, value in settings.items():
    glTexParameteri(GL_TEXTURE_2D, name, value)
for k, plane in enumerate(np.eye(4)):  # texture coordinates are places in the world
    glTexGeni(GL_S + k, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR)
    glTexGenfv(GL_S + k, GL_EYE_PLANE, plane)
    glEnable(GL_TEXTURE_GEN_S + k)
glMatrixMode(GL_TEXTURE)  # and from the world to the lamp's picture
glTranslatef(0.5, 0.5, 0.5)  # from [-1, 1] to [0, 1]
glScalef(0.5, 0.5, 0.5)
lamp_view()
glMatrixMode(GL_MODELVIEW)

glDisable(GL_LIGHT0)
things()
glEnable(GL_LIGHT0)
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
glEnable(GL_TEXTURE_2D)
glEnable(GL_BLEND)
glBlendFunc(GL_ONE, GL_ONE)  # light is added
glDepthFunc(GL_LEQUAL)
things()
screen

# %% [markdown]
# | | planar | shadow volume | shadow map |
# |---|---|---|---|
# | falls on | one plane | everything | everything |
# | edges | exact | exact | pixels of the map |
# | needs | one matrix | silhouettes, stencil | a depth texture |
# | soft | no | no | a little, by filtering |
#
# (The dark corner in the last picture lies outside of what the lamp sees: there the map has nothing to compare with.)
#
# None of the three is soft: a point light has hard shadows. For soft ones see lessons 26 and 34.
#
# ## Try this
#
# 1. `SIZE = 128`: what becomes of the shadow map's edges?
# 2. `glPolygonOffset(0, 0)`: stripes appear on everything that is lit. Why?
# 3. Draw the flat shadow with `glColor4f(0, 0, 0, 0.5)` and blending. Why are there darker patches in it, and how does the
#    stencil buffer help?
#
# ## Questions
#
# The eye itself is inside of the shadow volume. What goes wrong with the count, and what can one do?
#
# <details><summary>Answer</summary>
#
# The side through which the eye's ray would have entered is missing, so the count is too small by one. Counting *behind*
# what is seen instead of in front of it (`GL_DECR` where the depth test of a front fails, `GL_INCR` for a back) does not
# depend on where the eye is: Carmack's reverse.
#
# </details>
#
# ## Exercise
#
# Exercise 18: the matrix of planar shadows.
