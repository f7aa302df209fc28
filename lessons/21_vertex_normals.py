# %% [markdown]
# # 21. Vertex normals
#
# A modeller gives you points and triangles. Smooth shading wants a normal at each point, and a corner of a polyhedron
# has none: it has as many as triangles meet there. So we take a mean. But which one? And should the edge of a box be
# smooth at all?

# %% [markdown]
# ## Predict
#
# A box, twice as wide as it is high and deep, is made of triangles, two a face. At its near corner meet two triangles
# of the top, one of the front and one of the side. A program takes the plain mean of the four unit normals. Where does
# it point?
#
# - evenly away from the three faces, like (1, 1, 1)
# - too much upwards
# - too much to the side, since that face is the smallest

# %% A box and three normals of its near corner: the plain mean (red), weighted with areas (yellow), with angles (green)
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import *


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def vertex_normals(P, T, weight, crease=180):
    """Normals (m, 3, 3) of all corners of the triangles T (m, 3) between points P."""
    corner = P[T]
    to_next = unit(np.roll(corner, -1, axis=1) - corner)
    to_last = unit(np.roll(corner, 1, axis=1) - corner)
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    face = unit(cross)
    if weight == "equal":
        weights = np.ones(T.shape)
    elif weight == "area":
        weights = np.repeat(np.linalg.norm(cross, axis=1)[:, None] / 2, 3, axis=1)
    else:
        weights = np.arccos(np.clip((to_next * to_last).sum(axis=2), -1, 1))
    meet = T[:, :, None, None] == T  # corner c of triangle a is corner d of b
    close = face @ face.T >= np.cos(np.radians(crease)) - 1e-9  # of a and b
    return unit(np.einsum("acbd,ab,bd,bk->ack", meet, close, weights, face))


# the corners of the box, and its triangles, anticlockwise seen from outside
BOX = np.array([(x, y, z) for x in (-2, 0) for y in (-1, 0) for z in (-1, 0)], float)
FACES = "0132", "6754", "0451", "7623", "0264", "5731"
HALVES = (0, 1, 2), (0, 2, 3)
TRIANGLES = np.array(
    [[int(face[k]) for k in half] for face in FACES for half in HALVES]
)
NEAR = 7  # the corner (0, 0, 0)


def triangles(P, T, N):
    glBegin(GL_TRIANGLES)
    for triangle, normals in zip(T, N):
        for k in range(3):
            glNormal3f(*normals[k])
            glVertex3f(*P[triangle[k]])
    glEnd()


def begin(eye, at=(0, 0, 0), aspect=1.0):
    glClearColor(0.12, 0.13, 0.17, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(32, aspect, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glLightfv(GL_LIGHT0, GL_POSITION, [0.5, 0.8, 1, 0])
    gluLookAt(*eye, *at, 0, 1, 0)
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.55, 0.65, 0.8, 1])


screen = glsim.offscreen(720, 480, samples=4)
begin((1.3, 1.7, 4.2), (-0.55, -0.1, 0), 720 / 480)
glEnable(GL_POLYGON_OFFSET_FILL)
glPolygonOffset(1, 1)  # so that the edges lie before the faces
triangles(BOX, TRIANGLES, vertex_normals(BOX, TRIANGLES, "equal", crease=0))
glDisable(GL_LIGHTING)
glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
glColor3f(0.1, 0.12, 0.2)
triangles(BOX, TRIANGLES, np.zeros((12, 3, 3)))
glLineWidth(4)
corner = TRIANGLES == NEAR
for weight, color in (
    ("equal", (1, 0.35, 0.25)),
    ("area", (1, 0.85, 0.2)),
    ("angle", (0.3, 0.95, 0.4)),
):
    N = vertex_normals(BOX, TRIANGLES, weight)[corner][0]
    print(f"{weight:6} {(N / N.min()).round(2)}")  # in units of the smallest part
    glColor3f(*color)
    glBegin(GL_LINES)
    glVertex3f(*BOX[NEAR])
    glVertex3f(*(0.9 * N))
    glEnd()
screen

# %% [markdown]
# ## What you should see
#
# The plain mean (red) is $(1, 2, 1)$: too much upwards, only because the diagonal of the top happens to end in this
# corner. Cut the top along its other diagonal, and the shading of the box changes although its shape does not. Weighted
# with areas (yellow) the normal leans too: large faces win. Weighted with **angles** (green) it is $(1, 1, 1)$: each
# face has 90° at the corner, and two triangles of 26.6° and 63.4° count as much as one of 90°.

# %% [markdown]
# ## The formula
#
# $$ \mathbf{N} = \frac{\sum_k w_k\, \mathbf{n}_k}{\big| \sum_k w_k\, \mathbf{n}_k \big|}, \qquad
#    w_k = \begin{cases} 1 & \text{plain mean} \\ \text{the triangle's area} \\ \text{its angle at the vertex}
#    \end{cases} $$
#
# $\mathbf{n}_k$: unit normals of the triangles that meet at the vertex. The angle between the edges $\mathbf{e}$ and
# $\mathbf{f}$ is $\arccos(\mathbf{e} \cdot \mathbf{f})$ for unit vectors (radians). Areas are the cheapest: the cross
# product $\mathbf{e} \times \mathbf{f}$ of the unscaled edges is already as long as twice the area. Angles alone do not
# depend on how a face is cut. It is what glsim does with a mesh that comes without normals:

# %%
glsim.source("scenes/mesh.py", "angles = np.arccos")

# %% [markdown]
# ## Edges that should stay: the crease angle
#
# A tin is round on the side and has an edge at the lid. One mean normal for all triangles at the rim makes the edge
# look like a swollen cushion. So let only those triangles into the mean whose normal is within the **crease angle** of
# the triangle's own. In the code above that is the matrix `close`.


# %% A tin of 24 slices; crease angle 180°: all is smooth; 30°: a round side, a sharp rim; 0°: all is flat
def tin(slices=24):
    turn = np.arange(slices) * 2 * np.pi / slices
    x, z = np.cos(turn), np.sin(turn)
    rings = [np.stack([x, np.full(slices, y), z], axis=1) for y in (-0.8, 0.8)]
    P = np.concatenate([*rings, [(0, 0.8, 0)]])
    T = []
    for k in range(slices):
        a, b = k, (k + 1) % slices
        T += [(a, a + slices, b), (b, a + slices, b + slices)]  # the side
        T += [(2 * slices, b + slices, a + slices)]  # the lid
    return P, np.array(T)


def draw_tin(crease):
    begin((0, 3.0, 5.2))
    P, T = tin()
    triangles(P, T, vertex_normals(P, T, "angle", crease))


glsim.compare(
    draw_tin,
    sweep={"crease": [180, 30, 0]},
    columns="crease",
    modes="gouraud",
    size=290,
    samples=4,
    differences="off",
    title="crease angle (degrees)",
    live="edges, lights.position",
)

# %% [markdown]
# At 180° the lid is shaded as if it bulged, and the side changes towards the rim: both borrow normals from each other.
# At 30° the side is round, because there neighbours differ by $360° / 24 = 15°$ only, and the rim is sharp, because
# side and lid differ by 90°. At 0° every face keeps its own normal: flat shading.
#
# glsim makes the normals of meshes that have none in this way, with a crease of 40° and the angles as weights. A simpler
# rule is one mean for all, and the triangle's own normal where that is too far off. It has a sharp rim, too, but on a tin
# with vertices at its rims only it gives a faceted side. So it must be asked for each two triangles that meet:

# %%
glsim.source("scenes/mesh.py", "near = own[one]", lines=2)


# %% What the weights do to the tin that is all smooth: the plain mean and the areas twist the normals of the rim
def draw_weighted(weight):
    begin((0, 3.0, 5.2))
    P, T = tin(10)
    triangles(P, T, vertex_normals(P, T, weight))


glsim.compare(
    draw_weighted,
    sweep={"weight": ["equal", "area", "angle"]},
    columns="weight",
    modes="phong",
    size=290,
    samples=4,
    differences="x4",
    reference="angle",
    title="weights of the mean",
)


# %% How far the normals of the rim point away from the axis's plane, in degrees: 0 by symmetry
P, T = tin(10)
for weight in ("equal", "area", "angle"):
    N = vertex_normals(P, T, weight)
    rim = (T >= 10) & (T < 20)
    out = P[T][rim] * [1, 0, 1]  # the direction from the axis, of length 1
    flat = unit(N[rim] * [1, 0, 1])
    twist = np.degrees(np.arccos(np.clip((flat * out).sum(axis=1), -1, 1)))
    print(f"{weight:6} {twist.max():.2f}")

# %% [markdown]
# By symmetry the normal at the rim must lie in the plane of the axis. Each side of the tin is a rectangle cut along a
# diagonal, so at a vertex one neighbour counts with two triangles and the other with one: the plain mean is twisted
# to the side where there are more. Two triangles of a rectangle share its 90°, so angles have no preference.
#
# ## Try this
#
# 1. Write `"7623"` as `"6237"`: the top is cut along its other diagonal. Which of the three normals move?
# 2. Set the crease angles to `[100, 80, 10]`. Between which two does the rim become sharp, and what
#    happens below 15°?
# 3. Set `tin(slices=24)` to `tin(slices=8)`, with the crease angle 30. Is the side still round? What is 360° / 8?
#
# ## Questions
#
# A mesh has each vertex three times, once for each triangle (as STL files do). What does `vertex_normals` give?
#
# <details><summary>Answer</summary>
#
# Flat shading: no two triangles share a number, so no mean has more than one term. First find the points that are
# equal and give them one number.
#
# </details>
#
# Why can no crease angle be right for all models?
#
# <details><summary>Answer</summary>
#
# The edges of a coarse ball of eight slices differ by 45°, those of a cut gem by less. Only the modeller knows which
# of them are meant. Formats that carry normals (OBJ, glTF) let the modeller say so.
#
# </details>
#
# ## Exercise
#
# Exercise 17 (lesson 21): vertex normals.
