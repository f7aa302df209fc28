# %% [markdown]
# # 11. The ambient glow
#
# In a room with one lamp the wall behind the lamp is not black. Light bounces: from the lit wall to the floor, to the
# ceiling, to you. A local model knows nothing of bounces. So it cheats: it adds a light that comes from nowhere.

# %% [markdown]
# ## Predict
#
# A white ball is lit from the left. An ambient term of 0.3 is added. How does the dark half look then?
#
# - softly rounded, just darker than the lit half
# - flat: one even grey, without any shape
# - black still: ambient light only brightens what is lit

# %% The same ball without and with an ambient glow of 0.3
import glsim
from glsim.gl import *
from glsim.glut import glutSolidSphere


def ball(I_a=0.3):
    glClearColor(0.2, 0.16, 0.13, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glShadeModel(GL_PHONG_WIN)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [I_a, I_a, I_a, 1])
    glLightfv(GL_LIGHT0, GL_POSITION, [-2, 1, 0.6, 0])
    glMaterialfv(GL_FRONT, GL_AMBIENT, [1, 1, 1, 1])  # k_a
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.7, 0.7, 0.7, 1])  # k_d
    glutSolidSphere(0.8, 64, 48)


glsim.compare(
    ball,
    modes="phong",
    sweep={"I_a": [0.0, 0.3]},
    columns="I_a",
    size=380,
    samples=4,
    differences="off",
    live="ambient, lights.position, materials.ambient",
)

# %% [markdown]
# ## What you should see
#
# The dark half is lifted to one even grey. There is light now, but no shape: the term contains neither the normal nor
# the light nor the eye, only a constant. The lit half is brighter by the same amount.

# %% [markdown]
# ## The formula
#
# $$ I = I_a\, k_a + I_L\, k_d\, (\mathbf{N} \cdot \mathbf{L}) + I_L\, k_s\, (\mathbf{R} \cdot \mathbf{V})^n $$
#
# $I_a$ is the intensity of the glow, $k_a \in [0, 1]$ the surface's ambient reflectance, per channel. Both are inventions:
# $k_a$ is usually set equal to $k_d$, for the bounced light is reflected as any other is.
#
# > **The slide says** $I = I_L k_a \cos\theta + I_L k_s \cos^n\varphi + I_a k_a$. The first $k_a$ must be $k_d$: the diffuse
# > term has its own reflectance. It makes a difference as soon as the two are not equal:

# %% Turquoise with k_d in the diffuse term, and with k_a in its place, as on the slide
K_A, K_D = [0.1, 0.187, 0.175, 1], [0.396, 0.742, 0.691, 1]


def turquoise(slip):
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.3, 0.3, 0.3, 1])
    glClearColor(0.2, 0.16, 0.13, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for what in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(what)
    glLightfv(GL_LIGHT0, GL_POSITION, [-2, 1, 2, 0])
    glMaterialfv(GL_FRONT, GL_AMBIENT, K_A)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, K_A if slip else K_D)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glutSolidSphere(0.8, 64, 48)


glsim.compare(
    turquoise,
    modes="phong",
    sweep={"slip": [False, True]},
    columns="slip",
    captions={"False": "k_d (N·L): right", "True": "k_a (N·L): the slide"},
    size=300,
    samples=4,
    differences="off",
)

# %%
glsim.source(
    "shaders/light.glsl", "color = face.emission.rgb + face.k_a.rgb * I_a_scene.rgb;"
)

# %% [markdown]
# OpenGL has *two* ambient intensities. `glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ...)` is the glow of the scene, the
# lecture's $I_a$; it is (0.2, 0.2, 0.2) unless you change it. `glLightfv(GL_LIGHT0, GL_AMBIENT, ...)` is what each lamp
# adds to it, black by default; it is attenuated and confined to the cone like the lamp's other light.

# %% The picture of the ball taken apart: the ambient glow alone is a flat disc
glsim.terms(ball, size=320)

# %% What the glow stands for: the same room by OpenGL's lights with a glow, and with light that really bounces
glsim.compare(
    "cornell", modes=["gouraud", "radiosity"], size=380, patches=300, differences="off"
)

# %% [markdown]
# On the left the lamp does not reach the ceiling; all that the ceiling has is the glow, an even brown. On the right the
# bounced light is red on the block beside the red wall, and weak in the corners and beside the blocks. A constant is a
# poor guess at all that; lessons 29 to 33 compute it.
#
# ## Try this
#
# 1. Set `I_a` to 1. What is left of the picture, and why is it called overexposed?
# 2. Make the glow blue, `[0.1, 0.1, 0.3]`, and the lamp yellow. Which painters did that with shadows?
# 3. Remove the call of `glLightModelfv` from `ball`. How bright is the dark half now, and why?
#
# ## Questions
#
# What is the value of a pixel in the dark half, out of 255, with $I_a = 0.3$ and $k_a = 1$?
#
# <details><summary>Answer</summary>
#
# $0.3 \cdot 255 = 76.5$: 76 or 77. `glsim.probe(ball, 400, 300)` shows it term by term.
#
# </details>
#
# ## Exercise
#
# Exercise 8 (lesson 11): add the ambient glow, and the sum of all terms.
