# %% [markdown]
# # 1. The pipeline
#
# A program names a corner of a triangle: three numbers. A moment later a pixel lights up. Between the two lie four
# changes of coordinates and one division, always the same, for every vertex of every picture in this course. Whoever
# knows in which coordinates a number is, makes half of the mistakes.

# %% [markdown]
# ## Predict
#
# A teapot stands in the middle of the picture. The program moves it by 1.5 to the right and turns it by 40° about the
# axis that points at us. Then somebody swaps the two lines, so that `glRotatef` comes first. What changes?
#
# - nothing: both are done in either case
# - the teapot ends at the same place, but turned the other way
# - the teapot ends at another place, turned as before

# %% One teapot, two orders of glTranslatef and glRotatef; the grey cross is the origin
import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective, gluProject
from glsim.glut import glutSolidTeapot


def camera():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 0, 7, 0, 0, 0, 0, 1, 0)


def cross(size):
    glDisable(GL_LIGHTING)
    glColor3f(0.5, 0.5, 0.55)
    glBegin(GL_LINES)
    for x, y in ((-size, 0), (size, 0), (0, -size), (0, size)):
        glVertex2f(x, y)
    glEnd()
    glEnable(GL_LIGHTING)


def teapot(first):
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    camera()
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 2, 3, 0])
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.85, 0.55, 0.15, 1])
    cross(2.4)
    if first == "glTranslatef":
        glTranslatef(1.5, 0, 0)
        glRotatef(40, 0, 0, 1)
    else:
        glRotatef(40, 0, 0, 1)
        glTranslatef(1.5, 0, 0)
    glutSolidTeapot(0.7)


glsim.compare(
    teapot,
    sweep={"first": ["glTranslatef", "glRotatef"]},
    size=380,
    samples=4,
    modes="gouraud",
    differences="off",
    title="Which line comes first?",
    columns="first",
    live="camera",
)

# %% [markdown]
# ## What you should see
#
# Both teapots are turned by the same 40°. But the second has also travelled: up and to the right, to
# $(1.5\cos 40°,\ 1.5\sin 40°) \approx (1.15,\ 0.96)$, because its step of 1.5 was taken along an axis that had been
# turned already.
#
# Read the calls from bottom to top: the one that stands *last* meets the teapot *first*. Left it is turned on the
# spot, then moved. Right it is moved, then everything, the distance included, is turned about the origin.

# %% [markdown]
# ## The formula
#
# $$ \mathbf{P}_{eye} = M\,\mathbf{P}_{object}, \qquad \mathbf{P}_{clip} = P\,\mathbf{P}_{eye} $$
#
# $M$ is the modelview matrix, $P$ the projection matrix, 4 × 4 numbers each; a point is $(x, y, z, 1)$. Each call
# multiplies from the right, $M \leftarrow M\,T$, which is why the last call is applied first. `gluLookAt` is such a
# factor too: OpenGL has no camera, it moves the world in front of the eye.
#
# $$ \mathbf{P}_{ndc} = \frac{(x, y, z)_{clip}}{w_{clip}}, \qquad
#    x_{window} = x_0 + \frac{\text{width}}{2}\,(x_{ndc} + 1) $$
#
# With a perspective $w_{clip}$ is the distance in front of the eye, $-z_{eye}$: the division makes far things small.
# What lies in $[-1, 1]$ after the division is seen; the viewport stretches it over the pixels. These are the lines of
# the vertex shader behind every picture here:

# %%
glsim.source("shaders/main.vert", "vec4 E = transform.modelview * P;", lines=2)

# %%
glsim.source("shaders/main.vert", "vec4 C = transform.modelview_projection * P;")

# %% [markdown]
# The division and the viewport are not in the shader: the hardware does them.
#
# ## From outside
#
# | coordinates | what has been done | where 0 is |
# | --- | --- | --- |
# | object | nothing: the numbers of `glVertex` | in the model |
# | eye | modelview | in the eye, looking along $-z$ |
# | clip | projection | the four numbers before the division |
# | normalised device | division by $w$ | in the middle of the picture |
# | window | viewport | in the lower left corner, in pixels |
#
# Lighting happens in eye coordinates. That is the space of the next figure.


# %% Eye space from outside: the eye, its frustum, the teapot, a lamp, and the picture on a plane between them
def scene():
    glClearColor(0.16, 0.18, 0.22, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1, 2, 9)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(0, 2, 5, 0, 0, 0, 0, 1, 0)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE):
        glEnable(capability)
    glLightfv(GL_LIGHT0, GL_POSITION, [-2, 2.5, 1, 1])
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.85, 0.55, 0.15, 1])
    glutSolidTeapot(1)


glsim.outside(scene)

# %% [markdown]
# ## One point, all the way
#
# Follow the point $(1, 0, 0)$ of this scene, first by hand, then with a program that asks OpenGL for its two matrices.

# %% The point (1, 0, 0) in all coordinates, printed
import numpy as np

screen = glsim.offscreen(400, 400, samples=4)
scene()
M = np.array(glGetDoublev(GL_MODELVIEW_MATRIX)).T  # OpenGL writes columns first
P = np.array(glGetDoublev(GL_PROJECTION_MATRIX)).T

eye = M @ [1, 0, 0, 1]
clip = P @ eye
ndc = clip[:3] / clip[3]
print("eye   ", eye.round(3))
print("clip  ", clip.round(3))
print("ndc   ", ndc.round(3))
print(
    "window",
    (200 * (ndc[:2] + 1)).round(1),
    "as gluProject says:",
    gluProject(1, 0, 0)[:2],
)

# %% [markdown]
# The eye is $\sqrt{2^2 + 5^2} = \sqrt{29} \approx 5.385$ from the origin, and the point lies at right angles to that
# line: $z_{eye} = -5.385$, so $w_{clip} = 5.385$. The cotangent of half of 40° is 2.747, hence
# $x_{ndc} = 2.747 / 5.385 \approx 0.51$ and $x_{window} = 200 \cdot 1.51 = 302$.

# %% [markdown]
# ## A light is a point, too
#
# `glLightfv(GL_LIGHT0, GL_POSITION, ...)` multiplies the position with the modelview matrix *of that moment*, and
# keeps the result in eye coordinates. So the same numbers, said before or after `gluLookAt`, are two lamps.


# %% The same light position, set before and after gluLookAt, while the camera goes round the teapot
def lit(light, azimuth):
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(30, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0, GL_NORMALIZE):
        glEnable(capability)
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.85, 0.55, 0.15, 1])
    if light == "before gluLookAt":
        glLightfv(GL_LIGHT0, GL_POSITION, [-1, 0.3, 0, 0])
    a = np.radians(azimuth)
    gluLookAt(6 * np.sin(a), 2, 6 * np.cos(a), 0, 0, 0, 0, 1, 0)
    if light == "after gluLookAt":
        glLightfv(GL_LIGHT0, GL_POSITION, [-1, 0.3, 0, 0])
    glutSolidTeapot(1)


glsim.compare(
    lit,
    sweep={
        "azimuth": [0, -45, -90],
        "light": ["before gluLookAt", "after gluLookAt"],
    },
    size=270,
    samples=4,
    differences="off",
    title="The camera walks round, the light's numbers stay",
    live="camera",
)

# %% [markdown]
# Set *before* the camera, the light is a lamp on the photographer's hat: wherever he walks, it shines from his left.
# Set *after* the camera, it stands in the world: at $-90°$ the photographer has walked round to the lamp's side, has it
# behind him, and sees the teapot lit from the front. For a lamp of the scene: first the camera, then the light.

# %% [markdown]
# ## Try this
#
# 1. In `teapot`, turn by 180° instead of 40°. Where does the second one stand now? Could you have said so before?
# 2. In `scene`, set the near plane from 2 to 5.2. Which part of the teapot is missing, and what is inside?
# 3. In `scene`, take an angle of 20° in `gluPerspective`, and draw `scene(); screen`. The teapot grows. By which
#    factor? (Ask for $x_{ndc}$ again.)

# %% [markdown]
# ## Questions
#
# Why is the light computed in eye coordinates, and not in clip coordinates, which are nearer to the screen?
#
# <details><summary>Answer</summary>
#
# The equation needs angles and distances. The modelview of a scene without odd scales keeps both; the projection bends
# space so that far things become small, and the angle between $N$ and $L$ would be another.
#
# </details>
#
# Two points lie on one ray from the eye. Which of their coordinates agree?
#
# <details><summary>Answer</summary>
#
# $x$ and $y$ in normalised device and in window coordinates: they fall on one pixel. Their depth differs, which is how the
# depth test knows which of the two is seen.
#
# </details>
#
# ## Exercise
#
# Exercise 1 (lesson 1): place the camera, then the light.
