# %% [markdown]
# # 15. Gouraud shading
#
# In 1971 Henri Gouraud wanted a face without facets, on a computer that could not afford an equation for each pixel. His
# idea: evaluate at the corners only, and let the colours run into each other. It is what OpenGL calls `GL_SMOOTH`. It is
# wonderful for chalk. For a polished surface it has a blind spot.

# %% [markdown]
# ## Predict
#
# One large square, four vertices. A lamp hangs in front of its centre, and the material is polished: $k_s = 0.7$,
# $n = 100$. What does `GL_SMOOTH` show?
#
# - a round highlight in the middle
# - a star-shaped highlight in the middle
# - no highlight at all

# %% A square of four vertices with a lamp in front of its centre, under GL_SMOOTH
import glsim
from glsim.gl import *


def square(cuts=1, lamp=0.0):
    """A square of cuts x cuts small ones, and a lamp in front of it at x = lamp."""
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    glLightfv(GL_LIGHT0, GL_POSITION, [lamp, 0, 1, 1])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.08, 0.14, 0.28, 1])  # k_d
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.7, 0.7, 0.7, 1])  # k_s
    glMaterialf(GL_FRONT, GL_SHININESS, 100)  # n
    glNormal3f(0, 0, 1)
    edge = 1.8 / cuts
    for i in range(cuts):
        for j in range(cuts):
            x, y = i * edge - 0.9, j * edge - 0.9
            glRectf(x, y, x + edge, y + edge)


screen = glsim.offscreen(360, 360)
square()
screen

# %% [markdown]
# ## What you should see
#
# No highlight at all. At the corners, where the equation is evaluated, the light comes from the side and
# $(\mathbf{N} \cdot \mathbf{H})^{100}$ is nearly 0. Between the corners nobody asks. Even the diffuse light is the same
# everywhere: four equal corners, so one colour.

# %% [markdown]
# ## The formula
#
# $$ C = w_1\, I(\mathbf{N}_1) + w_2\, I(\mathbf{N}_2) + w_3\, I(\mathbf{N}_3), \qquad w_1 + w_2 + w_3 = 1 $$
#
# $C$ is the pixel's colour, $I$ the illumination equation, clamped to $[0, 1]$, at the three vertices with the unit normals
# $\mathbf{N}_1, \mathbf{N}_2, \mathbf{N}_3$. The weights $w_k \in [0, 1]$ say how near the pixel is to each vertex. $C$ is
# never brighter than the brightest corner. The equation runs in the *vertex* shader:

# %%
glsim.source(
    "shaders/main.vert",
    "shade(track(material.front, own_color, FRONT_TRACKS), N,",
)

# %% The square cut finer: Gouraud above, the equation at every pixel (Phong shading) below. Keys 1 to 5 swap
glsim.compare(
    square,
    modes="gouraud,phong",
    sweep={"cuts": [1, 2, 3, 8, 40]},
    columns="cuts",
    size=230,
    differences="off",
    live="edges, lights.position, materials.shininess",
)

# %% [markdown]
# Two cuts: a vertex lies exactly in the middle, catches the full highlight, and spreads it over all its neighbours, far
# too wide; it even shows along which diagonal the squares were cut into triangles. Three cuts: the middle lies between
# four vertices, and the highlight is dark and square. With 40 cuts it looks right. The lower row never changes: at every pixel the equation is exact, whatever the mesh.

# %% Brightness along the horizontal line through the middle: Gouraud with 2, 3 and 8 cuts, and at every pixel
from glsim import plots

sheet = glsim.compare(
    square, modes="gouraud,phong", sweep={"cuts": [2, 3, 8]}, size=360
)
pixels = range(18, 342)
line = {
    f"Gouraud, {cuts} cuts": (pixels, sheet.images[cuts, "gouraud"][180, 18:342, 2])
    for cuts in ("2", "3", "8")
}
line["at every pixel"] = (pixels, sheet.images["8", "phong"][180, 18:342, 2])
plots.curves(line, "pixel", "blue, out of 255")

# %% [markdown]
# Straight lines between the vertices, and a curve that they try to follow. With 3 cuts the peak has lost most of its
# height; with 2 it is as high as it should be, by luck, and much too wide.
#
# ## The highlight that blinks
#
# Now the lamp moves to the right, from above a vertex to above the middle between two. The mesh has 6 cuts: cells 0.3
# wide.


# %% The lamp moves by half a cell: Gouraud's highlight (upper pictures) fades and widens, the real one just moves
def moving(lamp):
    square(6, lamp)


glsim.compare(
    moving,
    modes="gouraud,phong",
    sweep={"lamp": [0.0, 0.075, 0.15]},
    columns="lamp",
    size=300,
    differences="off",
    live="edges, lights.position",
)

# %% [markdown]
# Flip through the upper row. On a moving object the effect is famous: highlights flash whenever a vertex passes the place
# where the mirror image of the lamp is.
#
# > **The slide says** Gouraud shading "misses details that don't fall on vertex". It misses them *between* vertices, and
# > it also exaggerates those that do fall on one. And it is not only highlights: the cone of a spotlight suffers as much.
#
# ## Try this
#
# 1. Set the shininess to 5. With how many cuts is the highlight acceptable now?
# 2. Set `GL_SPECULAR` to black: how many cuts does chalk need?
# 3. Give `moving` 5 cuts instead of 6: where is the nearest vertex now, and at which lamp is the highlight brightest?
#
# ## Questions
#
# Can a pixel inside a Gouraud-shaded triangle be brighter than all three of its vertices? Darker?
#
# <details><summary>Answer</summary>
#
# Neither. $C$ is a mean of the three with weights that sum to 1. So a highlight inside is always lost, and a shadow inside
# as well.
#
# </details>
#
# ## Exercise
#
# Exercise 12 (lesson 15): Gouraud shading by hand.
