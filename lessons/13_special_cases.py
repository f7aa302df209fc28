# %% [markdown]
# # 13. Special cases
#
# The equation is a sum of products, and sums may grow: beyond 1, where the screen ends. And cosines may be negative,
# where the light is behind the surface. What to do then is not in the equation. It has to be decided, and the decision
# is seen in the picture.

# %% [markdown]
# ## Predict
#
# A ball gets brighter and brighter: the light's intensity goes from 0.5 to 1, 2 and 4. Its colour is an orange,
# $k_d = (0.9, 0.45, 0.1)$. What happens to the colour in the brightest places?
#
# - it stays orange, only brighter
# - it turns yellow, then white
# - it turns red

# %% The light's intensity is 0.5, 1, 2 and 4; what is more than 1 is clamped
import glsim
from glsim.gl import *
from glsim.glut import glutSolidSphere


def begin(width, height):
    screen = glsim.offscreen(width, height, samples=4)
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glShadeModel(GL_PHONG_WIN)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, [0.9, 0.45, 0.1, 1])
    return screen


screen = begin(840, 210)
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 1.5, 0])
for column, I_L in enumerate((0.5, 1, 2, 4)):
    glViewport(210 * column, 0, 210, 210)
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [I_L, I_L, I_L, 1])
    glutSolidSphere(0.85, 64, 48)
screen

# %% [markdown]
# ## What you should see
#
# Each channel is clamped by itself. Red reaches 1 first and stays there; green follows, and orange turns yellow; blue,
# the smallest, comes last. The colour of an overexposed surface is wrong, and its shape is gone: a flat disc.

# %% [markdown]
# ## The formula
#
# The slides answer three questions:
#
# $$ I > 1: \quad I \leftarrow \min(I, 1) \qquad\qquad \mathbf{N} \cdot \mathbf{L} < 0: \quad \max(\mathbf{N} \cdot \mathbf{L},\, 0)
# \;\text{ or }\; \mathbf{N} \leftarrow -\mathbf{N} $$
#
# $$ \text{many lights:} \quad I = I_a k_a + \sum_i I_{L,i} \big( k_d\, (\mathbf{N} \cdot \mathbf{L}_i) + k_s\, (\mathbf{R}_i \cdot \mathbf{V})^n \big) $$
#
# $I$ is the intensity of a channel, 1 the brightest that the screen shows; $\mathbf{N}$, $\mathbf{L}_i$, $\mathbf{R}_i$ and
# $\mathbf{V}$ are unit vectors; $i$ counts the lights.
#
# > **The slide says** "clamp the value of $I$ to 0" where $\mathbf{N} \cdot \mathbf{L} < 0$. What is clamped is the *term* of
# > that light, not the sum: the ambient glow and the other lights stay. And the sum is clamped to 1 once, at the end.

# %%
glsim.source("shaders/light.glsl", "float side = FLIP_NORMAL", lines=3)

# %% N.L < 0: the term is 0 and the back of an open bowl is black; or the normal is flipped; or the back has a material
from glsim.glu import gluNewQuadric, gluSphere

screen = begin(840, 280)
glLightfv(GL_LIGHT0, GL_POSITION, [0.4, 0.7, 1, 0])
bowl = gluNewQuadric()
for column in range(3):
    glViewport(280 * column, 0, 280, 280)
    flip = GL_FLIP_NORMAL_GLSIM if column == 1 else GL_CLAMP_NORMAL_GLSIM
    glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, flip)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, column == 2)
    glMaterialfv(GL_BACK, GL_DIFFUSE, [0.1, 0.4, 0.8, 1])
    glPushMatrix()
    glClipPlane(GL_CLIP_PLANE0, [-0.25, -0.55, -0.8, 0.1])
    glEnable(GL_CLIP_PLANE0)
    gluSphere(bowl, 0.85, 48, 32)
    glPopMatrix()
screen

# %% [markdown]
# Left: **clamp**. The inside of the bowl turns its normals away from the light, and OpenGL gives it none. Middle:
# **flip**. The normal is turned where it looks away from the light, so that both sides are lit. Right: what OpenGL
# offers itself, **two-sided lighting** (`GL_LIGHT_MODEL_TWO_SIDE`): back faces, as seen by the eye, get $-\mathbf{N}$ and
# a material of their own.

# %% Many lights: red, green and blue from three sides. Two make yellow, cyan or magenta, all three make grey
screen = begin(420, 420)
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.9, 0.9, 0.9, 1])
for k, (x, y) in enumerate(((-1, -0.6), (1, -0.6), (0, 1.15))):
    glEnable(GL_LIGHT0 + k)
    glLightfv(GL_LIGHT0 + k, GL_POSITION, [x, y, 1.4, 0])
    glLightfv(GL_LIGHT0 + k, GL_DIFFUSE, [k == 0, k == 1, k == 2, 1])
glutSolidSphere(0.85, 64, 48)
screen

# %% [markdown]
# ## Try this
#
# 1. In the last figure give each light the intensity 2. Where is it clamped first?
# 2. Clamp each light's term to 1 *before* adding, in NumPy: for which materials is the result different?
# 3. In the bowl, move the light to the back, `[0, 0, -1, 0]`. Which of the three decisions shows the light at all?
#
# ## Questions
#
# Two lights give a pixel 0.7 and 0.6 in red. What is shown, and what would be shown if the light of one were clamped to
# 0 because it is behind the surface?
#
# <details><summary>Answer</summary>
#
# $\min(0.7 + 0.6, 1) = 1$. If the second is behind the surface, its term is 0 and 0.7 is left: not 0, for only that term
# is clamped.
#
# </details>
#
# ## Exercise
#
# Exercise 10: clamp, flip, two sides and many lights.
