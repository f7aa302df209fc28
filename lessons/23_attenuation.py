# %% [markdown]
# # 23. Attenuation
#
# Twice as far from a candle it is four times as dark. A point light that obeys this looks strangely harsh on the screen:
# glaring near by, black three steps away. OpenGL therefore lets you choose the law, and many programs choose a wrong
# one on purpose.

# %% [markdown]
# ## Predict
#
# Five equal balls stand in a row, 1, 2, 3, 4 and 5 away from a lamp that falls off with the square of the distance. The
# first has the brightness 1. How bright is the fifth?
#
# - 0.2
# - 0.04
# - 0.5: light does not simply vanish

# %% Balls 1 to 5 away from the lamp: constant, linear and quadratic attenuation
import glsim
from glsim import plots
from glsim.gl import *
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(800, 480, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0.9, 0.75, 1])
glMatrixMode(GL_PROJECTION)
glOrtho(0.3, 5.7, -0.54, 0.54, -2, 2)
glMatrixMode(GL_MODELVIEW)
laws = ((1, 0, 0), (0, 1, 0), (0, 0, 1))  # constant, linear, quadratic
for row, (constant, linear, quadratic) in enumerate(laws):
    glViewport(0, 320 - 160 * row, 800, 160)
    glLoadIdentity()
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, 0, 1])
    glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, constant)
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, linear)
    glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, quadratic)
    for x in range(1, 6):
        glLoadIdentity()
        glTranslatef(x, 0, 0)
        glutSolidSphere(0.42, 48, 32)
screen

# %% [markdown]
# ## What you should see
#
# Upper row: no attenuation, all alike. Middle: $1/d$, the fifth has a fifth. Lower row: $1/d^2$, the law of nature: the
# fifth has $1/25 = 0.04$ and is nearly black. (The lamp stands left of the first ball, so only their left sides are lit.
# The nearest points of the first ball are closer than 1 and brighter than white.)

# %% [markdown]
# ## The formula
#
# $$ \mathrm{attenuation} = \frac{1}{k_0 + k_1 d + k_2 d^2} $$
#
# $d$ is the distance from the lamp to the point (in units of eye space), $k_0, k_1, k_2 \ge 0$ are
# `GL_CONSTANT_ATTENUATION` (1 unless changed), `GL_LINEAR_ATTENUATION` and `GL_QUADRATIC_ATTENUATION` (0). The factor
# multiplies all terms of that light, its ambient one too. A directional light has no distance and is not attenuated.

# %%
glsim.source("shaders/light.glsl", "return 1.0 / (light.constant_attenuation", lines=1)

# %% Four laws over the distance
plots.attenuation()

# %% [markdown]
# Why the square? The lamp's power spreads over a sphere, and the area of a sphere is $4 \pi d^2$. Nothing is lost on the
# way: there is only more and more room for the same light.
#
# Why do programs cheat? An eye sees brightness ratios, a film is exposed for the mean, a screen clamps at 1. A lamp with
# a pure $1/d^2$ is overexposed near by before it lights the corners. $1 / (1 + d^2)$ at least does not grow without end.

# %% The three laws on a floor: drag the lamp, and try laws of your own
from glsim.glu import gluLookAt, gluPerspective


def row(law):
    glClearColor(0.02, 0.02, 0.03, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0.9, 0.75, 1])
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(42, 1, 0.5, 30)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(-1.5, 3.5, 6, 2.6, -0.3, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 0.5, 0, 1])
    for k, name in enumerate(("CONSTANT", "LINEAR", "QUADRATIC")):
        glLightf(GL_LIGHT0, globals()[f"GL_{name}_ATTENUATION"], k == law)
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-8, 5), (12, 5), (12, -10), (-8, -10)):
        glVertex3f(x, -0.42, z)
    glEnd()
    for x in range(1, 6):
        glPushMatrix()
        glTranslatef(x, 0, 0)
        glutSolidSphere(0.42, 48, 32)
        glPopMatrix()


glsim.compare(
    row,
    sweep={"law": [0, 1, 2]},
    modes="phong",
    columns="law",
    captions={"0": "constant", "1": "linear", "2": "quadratic"},
    size=300,
    samples=4,
    differences="off",
    live="lights.position, lights.attenuation",
)

# %% A **spot** is confined by a cone as well: cos to the power of the exponent inside, 0 outside
plots.spot()

# %% The same lamp as a spot above a floor, with exponents 0, 8 and 60
screen = glsim.offscreen(840, 260, samples=4)
glClearColor(0.02, 0.02, 0.03, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0.95, 0.85, 1])
glMatrixMode(GL_PROJECTION)
gluPerspective(45, 280 / 260, 0.5, 30)
glMatrixMode(GL_MODELVIEW)
for column, exponent in enumerate((0, 8, 60)):
    glViewport(280 * column, 0, 280, 260)
    glLoadIdentity()
    gluLookAt(0, 3, 5, 0, 0, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [0, 3, 0, 1])
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, [0, -1, 0])
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30)
    glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent)
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-8, 5), (8, 5), (8, -8), (-8, -8)):
        glVertex3f(x, 0, z)
    glEnd()
screen

# %% [markdown]
# > **The slide says** "intensity falls off with the square of the distance to the light source". That is true of a point.
# > Before a long tube the light falls off with $1/d$, before a bright wall not at all, as long as one is near: lesson 26
# > and the form factors of lesson 29 say why.
#
# ## Try this
#
# 1. Set the laws to `(1, 0, 0.25)`, `(1, 0.5, 0)` and `(0.2, 0, 0.8)`. Which would you take for a living room?
# 2. Make the light directional, `w = 0`. Which calls still have an effect?
# 3. Give the spot the cutoff 180 and the exponent 2. OpenGL ignores the exponent then: why?
#
# ## Questions
#
# A lamp has $k_0 = 1$, $k_1 = 0$, $k_2 = 0.5$. At which distance is its light down to a quarter?
#
# <details><summary>Answer</summary>
#
# $1 + 0.5\, d^2 = 4$ gives $d = \sqrt 6 \approx 2.45$.
#
# </details>
#
# ## Exercise
#
# Exercise 19 (lesson 23): attenuation and spots.
