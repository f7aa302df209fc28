# %% [markdown]
# # 22. Shadows
#
# The illumination equation asks where the light is. It never asks whether anything stands in between. Three classic
# tricks put shadows into a pipeline that knows none: flatten the object onto the floor, count the walls of its
# shadow, or look at the scene from the lamp.

# %% [markdown]
# ## Predict
#
# A stone gate stands on the floor, a ball lies beside it. The lamp is high up on the left. The program calls
# `glEnable(GL_LIGHTING)` and draws everything with its normals. What is on the floor to the right of the gate?
#
# - a dark shadow with a sharp edge
# - a pale shadow: the ambient light fills it
# - light, as everywhere

# %% A gate and a ball, lit by OpenGL from the upper left: no shadow anywhere
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import *
from glsim.glut import glutSolidSphere

LAMP = [-3.0, 5.0, 2.0]


def box(x0, y0, z0, x1, y1, z1):
    """Six faces of four corners, anticlockwise seen from outside."""
    corner = [(x, y, z) for x in (x0, x1) for y in (y0, y1) for z in (z0, z1)]
    faces = "0132", "4675", "0451", "2376", "0264", "1573"
    return [[corner[int(k)] for k in face] for face in faces]


GATE = [
    box(-1.1, 0, -0.3, -0.6, 1.5, 0.3),
    box(0.5, 0, -0.3, 1.0, 1.5, 0.3),
    box(-1.4, 1.5, -0.35, 1.3, 1.9, 0.35),
]


def normal_of(face):
    a, b, c = np.array(face[:3], float)
    n = np.cross(b - a, c - a)
    return n / np.linalg.norm(n)


def material(r, g, b):
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [r, g, b, 1])


def floor():
    material(0.75, 0.72, 0.65)
    glNormal3f(0, 1, 0)
    for x in range(-8, 8):  # many small squares: Gouraud shading needs the vertices
        glBegin(GL_QUAD_STRIP)
        for z in range(-8, 9):
            glVertex3f(x / 2, 0, z / 2)
            glVertex3f((x + 1) / 2, 0, z / 2)
        glEnd()


def things():
    material(0.85, 0.55, 0.35)
    for faces in GATE:
        for face in faces:
            glNormal3f(*normal_of(face))
            glBegin(GL_QUADS)
            for corner in face:
                glVertex3f(*corner)
            glEnd()
    material(0.35, 0.6, 0.9)
    glPushMatrix()
    glTranslatef(2.0, 0.5, -0.7)
    glutSolidSphere(0.5, 40, 30)
    glPopMatrix()


def camera():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(36, 720 / 480, 1, 40)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(1.2, 3.6, 7.5, 0.4, 0.7, 0, 0, 1, 0)


def begin():
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    camera()
    glLightfv(GL_LIGHT0, GL_POSITION, [*LAMP, 1])
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [0.85, 0.85, 0.85, 1])


screen = glsim.offscreen(720, 480, samples=4)
begin()
floor()
things()
screen

# %% [markdown]
# ## What you should see
#
# Light, as everywhere. The ball and the gate have a dark side, because there $\mathbf{N} \cdot \mathbf{L} < 0$. But a
# shadow is not a matter of the normal, it is a matter of what stands between a point and the lamp, and each vertex is
# lit on its own. "Every point is illuminated by every light source", as the lecture says. And the ball seems to float:
# without a shadow the eye cannot tell where it touches the floor.

# %% [markdown]
# ## The formula
#
# What is missing is one factor, the **visibility** $v$: 1 if the point sees the lamp, else 0.
#
# $$ I = k_a I_a + v\, \big( k_d I_d\, (\mathbf{N} \cdot \mathbf{L}) + k_s I_s\, (\mathbf{N} \cdot \mathbf{H})^n \big) $$
#
# $k$ and $I$ per channel, $N$, $L$, $H$ of unit length. The ambient glow is not multiplied: it comes from everywhere,
# so a shadow is not black. All three methods compute $v$. They differ in where they look.

# %%
glsim.source("shaders/light.glsl", "color += strength * face.k_d.rgb")

# %% [markdown]
# ## 1. Planar shadows
#
# A shadow on a plane is a projection, with the lamp as its centre. Projections are 4 x 4 matrices. For the plane
# $\mathbf{p} = (a, b, c, d)$, that is $ax + by + cz + d = 0$, and the lamp $\mathbf{l} = (l_x, l_y, l_z, l_w)$:
#
# $$ M = (\mathbf{p} \cdot \mathbf{l})\, \mathbf{1} - \mathbf{l}\, \mathbf{p}^\mathsf{T} $$
#
# $\mathbf{1}$ is the unit matrix. $l_w = 1$ is a lamp at a place, $l_w = 0$ a direction. A point of the plane
# ($\mathbf{p} \cdot \mathbf{x} = 0$) becomes a multiple of itself: it stays. The lamp becomes $\mathbf{0}$: it has no
# image.

# %% The matrix for the floor y = 0, and where it puts the corner (1.3, 1.9, 0.35) of the gate
p, l = np.array([0, 1, 0, 0]), np.array([*LAMP, 1])
M = (p @ l) * np.eye(4) - np.outer(l, p)
print(M)
x = M @ [1.3, 1.9, 0.35, 1]
print("shadow of the corner:", (x[:3] / x[3]).round(3))

# %% [markdown]
# Draw the floor, draw the things again through this matrix, dark and without lighting, then the things themselves. The
# stencil buffer sees to it that each pixel of the floor is darkened once, although front and back of the box both
# fall on it.


# %% Planar shadow: the gate and the ball flattened onto the floor. The ball stands on it; but it gets no shadow itself
def planar_shadow():
    glDisable(GL_LIGHTING)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glColor4f(0, 0, 0, 0.6)
    glDisable(GL_DEPTH_TEST)  # the shadow lies in the floor
    glEnable(GL_STENCIL_TEST)
    glStencilFunc(GL_EQUAL, 0, 1)
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR)  # the second time the test fails
    glPushMatrix()
    glMultMatrixf(M.T)  # OpenGL reads columns first
    things()
    glPopMatrix()
    for capability in (GL_STENCIL_TEST, GL_BLEND):
        glDisable(capability)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)


begin()
floor()
planar_shadow()
things()
screen

# %% [markdown]
# Cheap and sharp, the method of a thousand games. But it knows only one plane: the gate's shadow runs on under the
# ball and leaves the ball's own surface bright, and the gate's beam casts no shadow onto its pillar.

# %% [markdown]
# ## 2. Shadow volumes
#
# The shadow of a body is a region of space: behind it, seen from the lamp. Its walls start at the **silhouette**, the
# edges between faces that see the lamp and faces that do not, and run away from the lamp to infinity. A vertex with
# $w = 0$ lies there: `glVertex4f(x - l_x, y - l_y, z - l_z, 0)`.


# %% The walls of the shadow volumes, drawn as yellow glass
def volumes():
    for faces in GATE:
        lit = [np.dot(normal_of(f), np.subtract(LAMP, f[0])) > 0 for f in faces]
        pairs = [
            [(f[k], f[(k + 1) % 4]) for k in range(4)] for f, l in zip(faces, lit) if l
        ]
        edges = {edge for around in pairs for edge in around}
        glBegin(GL_QUADS)
        for a, b in edges:
            if (b, a) not in edges:  # the neighbour is dark: an edge of the silhouette
                glVertex3f(*b)
                glVertex3f(*a)
                glVertex4f(*np.subtract(a, LAMP), 0)
                glVertex4f(*np.subtract(b, LAMP), 0)
        glEnd()


begin()
floor()
things()
glDisable(GL_LIGHTING)
glEnable(GL_BLEND)
glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
glDepthMask(GL_FALSE)
glColor4f(1, 0.85, 0.1, 0.25)
volumes()
glDepthMask(GL_TRUE)
glDisable(GL_BLEND)
screen

# %% [markdown]
# Follow a ray from the eye to a visible point. Each wall that it passes from outside adds 1, each one from inside takes
# 1 away. If more than 0 is left, the point lies inside of a volume: in shadow. The **stencil buffer** counts that for
# all pixels at once: walls that face the eye add, walls that face away subtract, where the depth test lets them pass.


# %% What the stencil buffer has counted (left: violet 0, green 1, yellow 2) and the picture lit where it is 0
def count():
    glEnable(GL_STENCIL_TEST)
    glEnable(GL_CULL_FACE)
    glStencilFunc(GL_ALWAYS, 0, 255)
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE)
    glDepthMask(GL_FALSE)
    for culled, step in ((GL_BACK, GL_INCR), (GL_FRONT, GL_DECR)):
        glCullFace(culled)
        glStencilOp(GL_KEEP, GL_KEEP, step)
        volumes()
    glDisable(GL_CULL_FACE)
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE)


def shadowed():
    begin()
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [0, 0, 0, 1])  # first the glow alone: v = 0
    floor()
    things()
    count()
    glStencilFunc(GL_EQUAL, 0, 255)  # then the lamp, where the count is 0: v = 1
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [0.85, 0.85, 0.85, 1])
    glDepthFunc(GL_LEQUAL)
    floor()
    things()
    glDepthFunc(GL_LESS)
    glDepthMask(GL_TRUE)
    glDisable(GL_STENCIL_TEST)


from glsim.pictures import heat

screen = glsim.offscreen(720, 480)
shadowed()
counted = glReadPixels(0, 0, 720, 480, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE)
counted = np.frombuffer(counted, np.uint8).reshape(480, 720)[::-1]
glsim.compare(
    {
        "stencil count": heat(counted / 2, counted >= 0),
        "lit where it is 0": screen.image(),
    },
    differences="off",
    size=420,
)

# %% [markdown]
# Exact to the pixel, and on every surface: the beam's shadow falls on the right pillar, the gate's on the ball. (The
# ball has no volume here, its silhouette would be one more list of edges.) The price: walls that cover the screen
# many times. And the count is wrong when the eye itself is in shadow: then it has to start at 1, or count the walls
# *behind* the point (Carmack's reverse).

# %% [markdown]
# ## 3. Shadow maps
#
# Whatever the lamp does not *see* is in shadow. So draw the scene from the lamp and keep its **depth buffer** as a
# texture: for each direction the distance to the nearest surface. Then draw from the eye, and ask for each fragment:
# am I farther from the lamp than what it saw? OpenGL 1.4 answers with a comparison of the coordinate $r$, the
# fragment's depth as seen from the lamp, with the texel $D$:
#
# $$ v = \begin{cases} 1 & r \le D(s, t) \\ 0 & \text{else} \end{cases} \qquad
#    (s, t, r, q)^\mathsf{T} = B\, P_L\, V_L\, \mathbf{x} $$
#
# $V_L$ and $P_L$ are the lamp's view and projection, $\mathbf{x}$ the point in the world, $B$ takes $[-1, 1]$ to
# $[0, 1]$; all is divided by $q$.

# %%
glsim.source("shaders/texture.glsl", "float passed = CLAMPS")


# %% Left: the depths that the lamp sees. Right: the eye's picture with the shadows that follow from them
def from_the_lamp(size, factor, units):
    """Draw from the lamp; its depths become the texture.  Returns B P_L V_L."""
    glViewport(0, 0, size, size)
    glClear(GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(60, 1, 2.5, 12)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(*LAMP, 0.5, 0.4, 0, 0, 1, 0)
    P, V = glGetFloatv(GL_PROJECTION_MATRIX), glGetFloatv(GL_MODELVIEW_MATRIX)
    glEnable(GL_POLYGON_OFFSET_FILL)
    glPolygonOffset(factor, units)  # a little farther away: see below
    floor()
    things()
    glDisable(GL_POLYGON_OFFSET_FILL)
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, size, size, 0)
    B = 0.5 * np.array([[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1], [0, 0, 0, 2]])
    return B @ np.reshape(P, (4, 4)).T @ np.reshape(V, (4, 4)).T


def shadow_mapped(map_size=512, factor=2.0, units=4.0):
    begin()
    matrix = from_the_lamp(map_size, factor, units)
    for filter in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL)

    glViewport(0, 0, 720, 480)
    begin()
    for coordinate, plane in zip((GL_S, GL_T, GL_R, GL_Q), matrix):
        glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR)
        glTexGenfv(coordinate, GL_EYE_PLANE, plane)  # with the camera in the modelview
    generated = (GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q)

    glLightfv(GL_LIGHT0, GL_DIFFUSE, [0, 0, 0, 1])  # first the glow alone
    floor()
    things()
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [0.85, 0.85, 0.85, 1])  # then add the lamp times v
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    for capability in (GL_TEXTURE_2D, GL_BLEND, *generated):
        glEnable(capability)
    glBlendFunc(GL_ONE, GL_ONE)
    glDepthFunc(GL_LEQUAL)
    floor()
    things()
    glDepthFunc(GL_LESS)
    for capability in (GL_TEXTURE_2D, GL_BLEND, *generated):
        glDisable(capability)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.2, 0.2, 0.2, 1])


screen = glsim.offscreen(720, 512)
shadow_mapped()
picture = screen.image().crop((0, 32, 720, 512))
seen = glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT)
seen = np.frombuffer(seen, np.float32).reshape(512, 512)[::-1]
near, far = seen.min(), seen[seen < 1].max()
depths = heat(1 - np.clip((seen - near) / (far - near), 0, 1), seen < 1)
glsim.compare(
    {"depths from the lamp": depths, "shadow map": picture},
    differences="off",
    size=420,
)

# %% [markdown]
# Yellow is near the lamp, violet far. Now every surface casts and every surface receives, the ball too. The price is a
# picture's: its pixels show at the edges of the shadow, and its depths are one number for a whole texel. A slanted
# surface then lies half behind its own depth and shadows itself: **acne**. `glPolygonOffset` moves the depths back a
# little; too much of it, and the shadow leaves the foot of what casts it.


# %% A map without offset (stripes of acne), with the offset, and with far too much of it
def with_offset(offset):
    screen = glsim.offscreen(720, 512)
    shadow_mapped(256, *offset)
    return screen.image().crop((0, 32, 720, 512)).crop((150, 130, 600, 430))


offsets = {"no offset": (0, 0), "(2, 4)": (2.0, 4.0), "(20, 400)": (20, 400)}
glsim.compare(
    {name: with_offset(offset) for name, offset in offsets.items()},
    differences="off",
    size=290,
)

# %% [markdown]
# ## Try this
#
# 1. Set the last number of `LAMP` to `-2.0`. Which parts of the program must know, and does the planar shadow follow?
# 2. In the last cell set the map's `256` to `64` and to `512`. What changes, the acne or the edges?
# 3. Leave out the `glEnable(GL_STENCIL_TEST)` of `planar_shadow`. Where is the shadow too dark, and why there?
#
# ## Questions
#
# Why is the shadow of none of the three methods black here, and would that be right on the moon?
#
# <details><summary>Answer</summary>
#
# The visibility multiplies the lamp's diffuse and specular terms only. The ambient glow remains: it stands for the
# light from walls and sky. The moon has no sky, so its shadows are nearly black.
#
# </details>
#
# Can planar shadows be used with a lamp that is lower than the gate?
#
# <details><summary>Answer</summary>
#
# The matrix then projects what is higher than the lamp *through* the lamp onto the floor, on the wrong side: an
# anti-shadow. What is higher than the lamp casts no shadow on the floor and has to be left out.
#
# </details>
#
# ## Exercise
#
# Exercise 18 (lesson 22): planar shadow matrix.
