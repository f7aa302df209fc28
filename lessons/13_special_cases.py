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
# - it turns yellow
# - it turns red

# %% The light's intensity is 0.5, 1, 2 and 4; what is more than 1 is clamped
import glsim
from glsim.gl import *
from glsim.glut import glutSolidSphere


def begin():
    glClearColor(0.3, 0.31, 0.34, 1)
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


screen = glsim.offscreen(840, 210, samples=4)
begin()
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 1.5, 0])
for column, I_L in enumerate((0.5, 1, 2, 4)):
    glViewport(210 * column, 0, 210, 210)
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [I_L, I_L, I_L, 1])
    glutSolidSphere(0.85, 64, 48)
screen

# %% [markdown]
# ## What you should see
#
# Each channel is clamped by itself. With $I_L = 4$ and the light straight above, the sums are 3.6, 1.8 and 0.4: shown are
# 1, 1 and 0.4, a yellow. At $I_L = 10$ blue is clamped too, and the ball is white. The colour of an overexposed surface is
# wrong, and its shape is gone: a flat disc.

# %% [markdown]
# ## The formula
#
# The slides answer three questions:
#
# $$ I > 1: \quad I \leftarrow \min(I, 1) \qquad\qquad \mathbf{N} \cdot \mathbf{L} < 0: \quad \max(\mathbf{N} \cdot \mathbf{L},\, 0)
# \;\text{ or }\; \mathbf{N} \leftarrow -\mathbf{N} $$
#
# $$ \text{many lights:} \quad I = I_a k_a + \sum_i I_{L,i} \big( k_d \max(\mathbf{N} \cdot \mathbf{L}_i, 0) + k_s\, (\mathbf{R}_i \cdot \mathbf{V})^n \big) $$
#
# $I$ is the intensity of a channel, 1 the brightest that the screen shows; $\mathbf{N}$, $\mathbf{L}_i$, $\mathbf{R}_i$ and
# $\mathbf{V}$ are unit vectors; $i$ counts the lights. Where $\mathbf{N} \cdot \mathbf{L}_i \le 0$ the highlight of that light is 0
# as well, even if $\mathbf{R}_i \cdot \mathbf{V}$ or $\mathbf{N} \cdot \mathbf{H}_i$ is not.
#
# > **The slide says** "clamp the value of $I$ to 0" where $\mathbf{N} \cdot \mathbf{L} < 0$. What is clamped is the *term* of
# > that light, not the sum: the ambient glow and the other lights stay. And the sum is clamped to 1 once, at the end.

# %%
glsim.source("shading/terms.py", "def lambert", lines=3)

# %% A lamp on the left and one on the right. First picture: each term is clamped; second: only their sum
import numpy as np
from PIL import Image

from glsim import shading

y, x = np.mgrid[1.1:-1.1:480j, -1.1:1.1:480j]
inside = (x**2 + y**2 < 1)[..., None]
N = np.stack([x, y, np.sqrt(np.clip(1 - x**2 - y**2, 0, None))], axis=-1)
N_L = [shading.dot(N, shading.normalize(L)) for L in ([-2, 1, 0.8], [2, -0.5, 0.3])]
orange = np.array([0.9, 0.45, 0.1])
terms = sum(np.maximum(cosine, 0) for cosine in N_L)
whole = np.maximum(sum(N_L), 0)
pair = [
    np.where(inside, shading.clamp(orange * share), 0.32) for share in (terms, whole)
]
Image.fromarray((255 * np.concatenate(pair, axis=1)).astype(np.uint8)).reduce(2)

# %% [markdown]
# In the first picture each lamp adds what it has, or nothing. In the second a lamp *takes light away* where it is behind the
# surface, and the ball is dullest where it should be brightest. In fact $\mathbf{N} \cdot \mathbf{L}_1 + \mathbf{N} \cdot
# \mathbf{L}_2 = \mathbf{N} \cdot (\mathbf{L}_1 + \mathbf{L}_2)$: without the clamp two lamps are a single one, from somewhere
# between them, and weak if they face each other.

# %% [markdown]
# ## Flip, or two sides?
#
# A bowl shows its inside: back faces, whose normals point away from us, and here from the lamp too. The ball in the lower row
# is closed, and lit from the right.

# %% An open bowl, and a closed ball: no light where N.L < 0; the normal flipped; two-sided lighting with a blue back
from glsim.glu import gluNewQuadric, gluSphere


def begin_glowing():
    begin()
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.5, 0.5, 0.5, 1])
    glMaterialfv(GL_BACK, GL_DIFFUSE, [0.1, 0.4, 0.8, 1])


def bowl():
    glLightfv(GL_LIGHT0, GL_POSITION, [0.4, 0.7, 1, 0])
    glClipPlane(GL_CLIP_PLANE0, [-0.25, -0.55, -0.8, 0.1])
    glEnable(GL_CLIP_PLANE0)
    gluSphere(gluNewQuadric(), 0.85, 48, 32)
    glDisable(GL_CLIP_PLANE0)


screen = glsim.offscreen(840, 560, samples=4)
begin_glowing()
for column in range(3):
    flip = GL_FLIP_NORMAL_GLSIM if column == 1 else GL_CLAMP_NORMAL_GLSIM
    glLightModeli(GL_LIGHT_MODEL_BACK_LIGHTING_GLSIM, flip)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, column == 2)
    glViewport(280 * column, 280, 280, 280)
    bowl()
    glViewport(280 * column, 0, 280, 280)
    glLightfv(GL_LIGHT0, GL_POSITION, [1, 0.3, 0.2, 0])
    gluSphere(gluNewQuadric(), 0.85, 48, 32)
screen

# %% [markdown]
# Left, **clamp**: the inside of the bowl has only the glow. Middle, **flip**: the normal is turned wherever it looks away
# from the lamp, and the inside is lit. But so is the night side of the ball, as if the lamp shone through it. Right, what
# OpenGL offers, **two-sided lighting** (`GL_LIGHT_MODEL_TWO_SIDE`): back faces, as seen by the *eye*, get $-\mathbf{N}$ and a
# material of their own. A closed ball has no visible back faces, and keeps its night.


# %% The bowl, to turn until its inside is seen, under a lamp to drag: clamp, flip, two sides
def bowl_alone():
    begin_glowing()
    bowl()


glsim.compare(
    bowl_alone,
    modes="phong:clamp,phong:flip,phong:two-sided",
    lobes="blinn",
    size=280,
    samples=4,
    differences="off",
    live="lights.position",
)

# %%
glsim.source("shaders/light.glsl", "float side = FLIP_NORMAL", lines=3)


# %% Many lights: red, green and blue from three sides. Two make yellow, cyan or magenta, all three make grey
def three_lights():
    begin()
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.9, 0.9, 0.9, 1])
    for k, (x, y) in enumerate(((-1, -0.6), (1, -0.6), (0, 1.15))):
        glEnable(GL_LIGHT0 + k)
        glLightfv(GL_LIGHT0 + k, GL_POSITION, [x, y, 1.4, 0])
        glLightfv(GL_LIGHT0 + k, GL_DIFFUSE, [k == 0, k == 1, k == 2, 1])
    glutSolidSphere(0.85, 64, 48)


glsim.show(three_lights, size=420, controls="lights.position, lights.diffuse")

# %% [markdown]
# ## Try this
#
# 1. In the last figure give each light the intensity 2. Where is it clamped first?
# 2. In the NumPy cell clamp each lamp's term to 1 *before* adding, too. Why can the final picture never differ?
# 3. Put the lamp behind the bowl, `[0, 0, -1, 0]`. In which of the three pictures is the inside lit all the same?
#
# ## Questions
#
# The first lamp gives a pixel 0.7. For the second $I_L k_d = 1$ and $\mathbf{N} \cdot \mathbf{L} = -0.4$. What is shown? And
# what if $\mathbf{N} \cdot \mathbf{L}$ were $+0.4$?
#
# <details><summary>Answer</summary>
#
# 0.7: the term of the second lamp is clamped to 0. Clamping only the sum would give $\max(0.7 - 0.4, 0) = 0.3$; setting
# $I$ to 0, as the slide has it, would lose the first lamp too. With $+0.4$ the sum is 1.1, and 1 is shown.
#
# </details>
#
# ## Exercise
#
# Exercise 10 (lesson 13): clamp, flip, two sides and many lights.
