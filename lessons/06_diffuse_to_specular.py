# %% [markdown]
# # 6. What we model: from diffuse to specular
#
# Chalk, silk, a waxed apple, a mirror: put them under one lamp and you can tell them apart with one eye closed. They
# differ in one thing only, in *where they send* the light that they reflect.

# %% [markdown]
# ## Predict
#
# Four balls of the same colour reflect about the same total share of the light. The first scatters it in all directions, the
# last sends it almost all into one. Which looks the brightest at its brightest point?
#
# - the first: it wastes nothing in one direction only
# - all alike, if they reflect the same share
# - the last, by far

# %% The same lamp on chalk, silk, wax and polished stone: from diffuse to glossy
import glsim
from glsim import plots
from glsim.gl import *
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(840, 210, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1.2, 2, 0])
glMatrixMode(GL_PROJECTION)
glOrtho(-1, 1, -1, 1, -1, 1)
glMatrixMode(GL_MODELVIEW)
finishes = [
    (0.75, 0.0, 1),
    (0.5, 0.3, 6),
    (0.35, 0.6, 30),
    (0.2, 1.0, 120),
]  # k_d, k_s, n
for column, (k_d, k_s, n) in enumerate(finishes):
    glViewport(210 * column, 0, 210, 210)
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [k_d, 0.6 * k_d, 0.35 * k_d, 1])
    glMaterialfv(GL_FRONT, GL_SPECULAR, [k_s, k_s, k_s, 1])
    glMaterialf(GL_FRONT, GL_SHININESS, n)
    glutSolidSphere(0.85, 64, 48)
screen

# %% [markdown]
# ## What you should see
#
# Chalk has no spot at all; it looks the same from every side. On silk the light gathers to a gleam, on wax to a
# highlight, on polished stone to a small glaring spot, while the rest of the ball gets darker. What is sent in one
# direction is missing in all others.

# %% [markdown]
# ## The formula
#
# The **reflectance distribution** of a surface says how much of the light from the direction $\mathbf{L}$ leaves towards
# $\mathbf{V}$. We model it as a sum of two extremes:
#
# $$ I = \underbrace{I_L\, k_d\, (\mathbf{N} \cdot \mathbf{L})}_{\text{diffuse}} + \underbrace{I_L\, k_s\, (\mathbf{R} \cdot
# \mathbf{V})^n}_{\text{specular}} $$
#
# $k_d, k_s \in [0, 1]$ are the shares, $n$ says how narrow the specular lobe is. Everything between matte and mirror is a
# mixture: matte has $k_s = 0$, **glossy** a moderate $n$, a mirror a very large one.

# %% Where the light goes that comes from 45 degrees: a half disc is diffuse, a finger specular
plots.lobes(
    {
        "matte": plots.phong_term(k_d=0.9, k_s=0.0),
        "silk": plots.phong_term(k_d=0.5, k_s=0.4, n=6),
        "glossy": plots.phong_term(k_d=0.25, k_s=0.8, n=60),
    },
    45,
)

# %%
glsim.source("shaders/light.glsl", "if (N_L > 0.0) {", lines=4)

# %% Two finishes of the same teapot: press 1 and 2
finishes = {"material": ["red-plastic", "red-rubber"]}
glsim.compare(
    "teapot", modes="phong", sweep=finishes, columns="material", size=380, samples=4
)

# %% [markdown]
# ## Try this
#
# 1. Give the last ball $k_d = 0.75$, too: more light leaves than arrives. Does it look wrong?
# 2. $n = 2000$ is not allowed: OpenGL ends at 128. What does the call say?
# 3. Take the lobes at 10 and at 75 degrees. Which of the three changes its shape?
#
# ## Questions
#
# Where on the way from chalk to mirror is paper, where fresh snow, where a road after rain?
#
# <details><summary>Answer</summary>
#
# Paper is almost diffuse, glossy paper has a wide specular lobe; snow is diffuse with countless tiny mirrors that
# glitter; a dry road is diffuse, a wet one is covered with a smooth film of water and specular.
#
# </details>
#
# ## Exercise
#
# Exercise 6: write the specular term.
