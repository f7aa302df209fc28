# %% [markdown]
# # 20. T-vertices
#
# Two polygons meet along an edge. One of them has a vertex in the middle of that edge, the other does not know about
# it: the edges form a T. On paper the surface is closed. On the screen it has a jump of brightness at best, and holes
# at worst.

# %% [markdown]
# ## Predict
#
# A flat wall is one large square on the left and two small ones on the right. A lamp hangs close in front of the
# middle of the seam, where the two small squares share a vertex. The wall is Gouraud shaded. What does one see there?
#
# - nothing special: it is one flat wall of one material
# - the right half is bright at the seam, the left half dark
# - both halves are bright at the seam, but nowhere else

# %% A wall with a T-vertex in its middle: the right half has a bright spot that ends at the seam; on the right its edges
import glsim
from glsim.gl import *

LEFT = [(-1, -1), (0, -1), (0, 1), (-1, 1)]
RIGHT = [
    [(0, -1), (1, -1), (1, 0), (0, 0)],
    [(0, 0), (1, 0), (1, 1), (0, 1)],
]


def light():
    glClearColor(0.12, 0.13, 0.17, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, [0.95, 0.8, 0.6, 1])
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, 0.4, 1])  # close to the seam's middle
    glNormal3f(0, 0, 1)


def polygon(corners, first=0):
    glBegin(GL_POLYGON)
    for k in range(len(corners)):
        glVertex2f(*corners[(first + k) % len(corners)])
    glEnd()


def edges(corners):
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glDisable(GL_LIGHTING)
    glColor3f(0.9, 0.9, 0.9)
    polygon(corners)
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)


screen = glsim.offscreen(720, 360, samples=4)
glMatrixMode(GL_PROJECTION)
glOrtho(-1.03, 1.03, -1.03, 1.03, -1, 1)  # the outer edges, too, are in the picture
light()
for column, draw in enumerate((polygon, edges)):
    glViewport(15 + 360 * column, 15, 330, 330)
    for corners in (LEFT, *RIGHT):
        draw(corners)
screen

# %% [markdown]
# ## What you should see
#
# The small squares have a vertex right under the lamp. Gouraud shading evaluates the light there, and it is bright.
# The large square has vertices in the four outer corners only, all far from the lamp and dark; along the seam it mixes
# dark with dark. So the same point of the wall has two colours, one on either side of the seam.

# %% Two pixels beside each other at the middle of the seam
pixels = screen.pixels()
print("left of the seam", pixels[180, 178, 0], "  right of it", pixels[180, 182, 0])

# %% [markdown]
# ## The formula
#
# Let $A$ and $B$ be the ends of the seam and $M$ its middle. Along the seam the two sides show
#
# $$ C_\text{left}(t) = (1 - t)\, I(A) + t\, I(B), \qquad C_\text{right}(\tfrac12) = I(M) $$
#
# $I$ is the illumination equation at a vertex (per channel, in $[0, 1]$), $t \in [0, 1]$ the place between $A$ and $B$.
# At $M$ the jump is $I(M) - \frac12 (I(A) + I(B))$. It vanishes for all lights only if both sides evaluate at the same
# vertices. In the shader the equation runs once a vertex, and a polygon that lacks $M$ never asks for it:

# %%
glsim.source(
    "shaders/main.vert", "shade(track(material.front, own_color, FRONT_TRACKS)"
)

# %% [markdown]
# ## The cure
#
# Give the large square the vertex that it lacks. But mind how: a polygon is cut into triangles, here into a fan around
# its *first* vertex.


# %% The large square with the fifth vertex, begun at each of its five vertices: the order of the vertices decides
MENDED = [(-1, -1), (0, -1), (0, 0), (0, 1), (-1, 1)]  # with the vertex on the seam


def wall(first):
    light()
    glShadeModel(GL_SMOOTH)
    polygon(MENDED, first)
    for corners in RIGHT:
        polygon(corners)


glsim.compare(
    wall,
    sweep={"first": [0, 1, 2, 3]},
    columns="first",
    modes="gouraud",
    size=220,
    samples=4,
    differences="off",
    title="the large square is a fan around its vertex number",
    live="edges, lights.position",
)

# %% [markdown]
# Begun at the new vertex (number 2), the fan uses it in every triangle: a spot on both sides, and no seam. Begun at an
# end of the seam (1 or 3), one triangle of the fan is the seam itself, without area. The new vertex is used by nothing
# else, and the fault is back.
#
# > **The slide says** "If you do not have smooth normals, color changes if polygon order changes". These pictures show
# > it: same vertices, same normals, and the colour depends on the order in which the vertices are named. Smooth normals
# > make it milder; they do not cure it, as this flat wall shows, whose normals are all equal.

# %% [markdown]
# ## Holes
#
# Positions suffer too. The card rounds each vertex to a fine grid of the screen before it fills. After rounding, the
# vertex of the T is no longer *exactly* on the long edge, and between the two sides opens a crack less than a pixel
# wide. A pixel whose centre lies in it is painted by neither side: the background shines through.


# %% A wall that turns before a red background: the red points along its seam are holes
def turned(angle, split):
    glClearColor(1, 0, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glLoadIdentity()
    glRotatef(angle, 0, 0, 1)
    glColor3f(0.7, 0.75, 0.8)
    middle = (0, 0.137)  # the vertex on the seam
    if split:
        polygon([middle, (0, 1), (-1, 1), (-1, -1), (0, -1)])
    else:
        polygon(LEFT)
    glColor3f(0.5, 0.55, 0.6)
    polygon([(0, -1), (1, -1), (1, 0.137), middle])
    polygon([middle, (1, 0.137), (1, 1), (0, 1)])


def holes(split):
    """Red pixels inside of the wall, in 90 pictures."""
    count, worst = 0, (0, None)
    for step in range(90):
        turned(0.5 + step, split)
        pixels = screen.pixels()[60:300, 60:300]
        red = int((pixels[..., 1] == 0).sum())
        count += red
        if red > worst[0]:
            worst = red, screen.image()
    return count, worst[1]


screen = glsim.offscreen(360, 360)
open_seam, picture = holes(split=False)
mended, _ = holes(split=True)
print(f"holes in 90 pictures: {open_seam} with the T-vertex, {mended} without")
picture.crop((60, 60, 300, 300)).resize((720, 720), 0)  # enlarged three times

# %% [markdown]
# In a film these points flicker. Edges whose two ends are *the same* vertices on both sides never open: OpenGL promises
# that a pixel on such an edge is filled exactly once. That promise is the reason to mend T-vertices even in unlit,
# one-coloured walls.
#
# ## Try this
#
# 1. Draw the second figure with `modes="phong"`. Is the seam of `first=1` still there, and why not?
# 2. Move the lamp away: `[0, 0, 4, 1]`. How large is the jump now?
# 3. Set `0.137` to `0.5` in all three places. Are there fewer holes? Which rounding is exact?
#
# ## Questions
#
# Why do T-vertices often come with meshes that were refined where the light changes fast?
#
# <details><summary>Answer</summary>
#
# Where a small polygon borders on a large one, the small one's corners lie on the large one's edge. Each step of an
# adaptive refinement makes T-vertices, unless the neighbour is cut, too. (Lesson 34 refines patches in this way.)
#
# </details>
#
# The lamp is 0.4 in front of the wall, one unit from the seam's ends. By Lambert's law alone, how large is the jump?
#
# <details><summary>Answer</summary>
#
# At $M$: $\cos\theta = 1$. At $A$ and $B$: $0.4 / \sqrt{0.4^2 + 1^2} \approx 0.37$. The jump is 0.63 of the diffuse
# light: from 0.37 to 1.
#
# </details>
#
# ## Exercise
#
# Exercise 16 (lesson 20): mend the T-vertex.
