# %% [markdown]
# # 18. Orientation dependence and silhouettes
#
# Smooth shading is a clever lie: few colours or normals are known, the rest is interpolated. This lesson shows two
# places where the lie comes out. The picture of one and the same square can depend on the corner that you begin with,
# and a ball of a few faces, shaded as smoothly as you like, keeps the outline of a polygon.

# %% [markdown]
# ## Predict
#
# A square has two white corners, opposite each other, and two black ones. It is drawn twice with `GL_SMOOTH`: the
# same corners, the same colours, the same direction around. Only the first vertex is another one. What colour has its
# centre?
#
# - the mean of the corners, a medium grey, both times
# - white both times: bright wins
# - black in one picture and white in the other

# %% The same square twice: a bright ridge along one diagonal, and a dark valley along the other
import numpy as np

import glsim
from glsim.gl import *
from glsim.pictures import tiles

CORNERS = [(-0.85, -0.85), (0.85, -0.85), (0.85, 0.85), (-0.85, 0.85)]
COLORS = [
    1,
    0,
    1,
    0,
]  # of the corners: lower left, lower right, upper right, upper left


def square(first):
    glShadeModel(GL_SMOOTH)
    glClearColor(0.25, 0.3, 0.4, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glBegin(GL_QUADS)
    for k in range(4):
        corner = (first + k) % 4
        glColor3f(COLORS[corner], COLORS[corner], COLORS[corner])
        glVertex2f(*CORNERS[corner])
    glEnd()


screen = glsim.offscreen(720, 360, samples=4)
glViewport(0, 0, 360, 360)
square(first=0)
glEnable(GL_SCISSOR_TEST)  # so that the second glClear leaves the first picture alone
glViewport(360, 0, 360, 360)
glScissor(360, 0, 360, 360)
square(first=1)
screen

# %% [markdown]
# ## What you should see
#
# Two different pictures. A graphics card fills triangles only, so it cuts the square along a diagonal, and *which*
# diagonal depends on the vertex that comes first. On the diagonal lie mixtures of its two ends and of nothing else: cut
# from black to black the centre is black, cut from white to white it is white. The mean of all four corners, grey, is
# in neither picture. OpenGL leaves the choice to the implementation: another driver may cut the other way.

# %%
pixels = screen.pixels()
print("centres:", pixels[180, 180, 0], "and", pixels[180, 540, 0], "of 255")

# %% [markdown]
# ## The formula
#
# Inside a triangle the weights of the three vertices are shares of its area:
#
# $$ C = \alpha\, C_0 + \beta\, C_1 + \gamma\, C_2, \qquad \alpha + \beta + \gamma = 1, \quad \alpha, \beta, \gamma \ge 0 $$
#
# $C_i$ is the colour of vertex $i$ (each channel in $[0, 1]$). $\alpha$ is the area of the triangle between the point
# and the two *other* vertices, divided by the whole. Turn the triangle and no area changes: triangles do not depend on
# their orientation. Quads do, as soon as they are more than a plane of colours: four corners need
# $C_0 + C_2 = C_1 + C_3$ to be one.

# %% [markdown]
# ## Older hardware: along the scan line
#
# Gouraud's algorithm of 1971 filled any polygon directly, line by line: mix colours along the two edges that the line
# crosses, then along the line. Here it is in NumPy. Turn the square, and watch the centre.


# %% One square turned by 0, 20, 45 and 135 degrees, filled along scan lines: its pattern changes with the angle
def scan_lines(degrees, size=220):
    """Gouraud's way: interpolate along the edges, then along each line of pixels."""
    turn = np.radians(degrees)
    c, s = np.cos(turn), np.sin(turn)
    corners = np.array([(x * c - y * s, x * s + y * c) for x, y in CORNERS]) * 0.8
    image = np.full((size, size), 0.32)
    places = (np.arange(size) + 0.5) / size * 2 - 1  # of the pixels, from -1 to 1
    for row, y in enumerate(-places):
        crossings = []
        for k in range(4):
            (x0, y0), (x1, y1) = corners[k], corners[(k + 1) % 4]
            if (y0 <= y) != (y1 <= y):  # the line crosses this edge
                t = (y - y0) / (y1 - y0)
                color = COLORS[k] + t * (COLORS[(k + 1) % 4] - COLORS[k])
                crossings.append((x0 + t * (x1 - x0), color))
        if len(crossings) == 2:
            (left, a), (right, b) = sorted(crossings)
            inside = (places >= left) & (places <= right)
            image[row, inside] = np.interp(places[inside], [left, right], [a, b])
    return np.uint8(np.repeat(image[..., None] * 255, 3, axis=2))


tiles("", [[(f"turned by {d}°", scan_lines(d)) for d in (0, 20, 45, 135)]], 220)

# %% [markdown]
# At 0° the centre is grey. At 45° the line through the centre runs from a black corner to a black one, at 135° from
# white to white: so is the centre. In an animation the pattern would *swim* over the square while it turns. That is
# **orientation dependence**. Today's cards cut into triangles instead, and what remains of it is the choice of the
# diagonal.

# %% A floor of one quad with a lamp over one corner: the cut decides how much light the floor seems to get
screen = glsim.offscreen(720, 300, samples=4)
glClearColor(0.12, 0.13, 0.17, 1)
glClear(GL_COLOR_BUFFER_BIT)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.95, 0.85, 0.65, 1])
glLightfv(GL_LIGHT0, GL_POSITION, [-1, -1, 0.4, 1])  # close over the lower left
glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.5)

for column, first in enumerate((0, 1)):
    glViewport(40 + 360 * column, 10, 280, 280)
    glNormal3f(0, 0, 1)
    glBegin(GL_QUADS)
    for k in range(4):
        x, y = [(-1, -1), (1, -1), (1, 1), (-1, 1)][(first + k) % 4]
        glVertex2f(x, y)
    glEnd()
screen

# %% [markdown]
# One corner is bright, three are dark. On the left the cut runs through the bright corner: both triangles get its
# light. On the right it runs past it, one triangle stays dark all over. The truth, a round spot in the corner, is in
# neither. The cure is the same for all the tricks of interpolation: more, smaller polygons.

# %% Balls of 6, 12 and 32 slices, Gouraud and Phong shaded: the inside gets smooth, the outline stays a polygon
glsim.compare(
    "sphere",
    modes=["gouraud", "phong"],
    lobes="blinn",
    segments=[6, 12, 32],
    columns="segments",
    size=280,
    samples=4,
    differences="off",
)

# %% [markdown]
# ## Silhouettes
#
# Phong shading makes even six slices look round, inside. At the rim the eye is not fooled: the **silhouette** is made
# of straight edges. Shading changes colours; it moves no vertex. The two facts are two lines of the shaders. The normal
# is made up between the vertices, in every fragment:

# %%
glsim.source("shaders/main.frag", "vec3 N = normalize(eye_normal)")

# %% [markdown]
# The position is what the program gave, transformed, and nothing else:

# %%
glsim.source("shaders/main.vert", "gl_Position = C;")

# %% [markdown]
# How many slices are enough? A circle of radius $r$ (pixels) with $n$ corners is missed in the middle of each edge by
#
# $$ e = r \left(1 - \cos\frac{\pi}{n}\right) \approx \frac{r}{2} \left(\frac{\pi}{n}\right)^2 $$

# %% The error of the outline of a ball of radius 400 pixels falls with the square of the number of slices
n = np.arange(6, 97)
glsim.plots.curves(
    {"error of the outline": (n, 400 * (1 - np.cos(np.pi / n)))},
    "slices n",
    "error (pixels)",
    log=True,
    marks={63: "half a pixel"},
    title="A ball of radius 400 pixels",
)

# %% [markdown]
# ## Try this
#
# 1. Set `COLORS = [1, 0.5, 0, 0.5]` in the first cell. Why do both squares now look the same?
# 2. Cut the first square yourself: draw it as `GL_TRIANGLE_FAN` around a fifth, grey vertex in the middle. Which
#    picture do you get, and does it still depend on the first corner?
# 3. Set `segments=[6, 12, 32]` to `[48, 64, 96]`. From which number on does the outline look round to you?
#
# ## Questions
#
# One corner of a square is white, three are black. How bright is the square on average for either cut, and for the
# bilinear mixture of the four corners?
#
# <details><summary>Answer</summary>
#
# The mean over a triangle is the mean of its three corners. Cut *through* the white corner, both triangles have it:
# $\frac13$. Cut past it, one triangle has it and one is black: $\frac12 \cdot \frac13 = \frac16$. The bilinear mixture
# gives $\frac14$, between the two.
#
# </details>
#
# Why does nobody notice the polygon inside the ball, but everybody its rim?
#
# <details><summary>Answer</summary>
#
# Inside, neighbouring pixels differ by what the normals say, and these are smooth. At the rim the ball meets the
# background: a jump of brightness, and its place is decided by positions alone.
#
# </details>
#
# ## Exercise
#
# Exercise 16: mend the T-vertex.
