# %% [markdown]
# # 12. Lights and materials
#
# What colour has a green apple in red light? The apple is not green by itself: it reflects green light and swallows
# the rest. If there is no green light, there is nothing to reflect. The equation is the same for red, green and blue,
# and no channel knows of the others.

# %% [markdown]
# ## Predict
#
# Three balls under one red light, (1, 0, 0): a white one, a green one (0, 1, 0), and a green one with a white
# highlight, $k_s = (1, 1, 1)$. What do you see?
#
# - red, green, green with a white spot
# - red, yellow, yellow with a white spot
# - red, black, black with a red spot

# %% A white, a green, and a shiny green ball in red light; below them the same balls in white light
import glsim
from glsim.gl import *
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(720, 480, samples=4)
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
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1.5, 2, 0])
glMaterialf(GL_FRONT, GL_SHININESS, 40)
WHITE, GREEN, RED, BLACK = [1, 1, 1, 1], [0, 1, 0, 1], [1, 0, 0, 1], [0, 0, 0, 1]
balls = [(WHITE, BLACK), (GREEN, BLACK), (GREEN, WHITE)]  # k_d, k_s
for row, light in enumerate((WHITE, RED)):
    glLightfv(GL_LIGHT0, GL_DIFFUSE, light)
    glLightfv(GL_LIGHT0, GL_SPECULAR, light)
    for column, (k_d, k_s) in enumerate(balls):
        glViewport(240 * column, 240 * row, 240, 240)
        glMaterialfv(GL_FRONT, GL_DIFFUSE, k_d)
        glMaterialfv(GL_FRONT, GL_SPECULAR, k_s)
        glutSolidSphere(0.8, 64, 48)
screen

# %% [markdown]
# ## What you should see
#
# In red light (upper row) the white ball is red: it reflects what there is. The green ball is black: it would reflect
# green, and there is none. The shiny one is black with a *red* highlight: its $k_s$ is white, so the highlight has the
# colour of the light.

# %% [markdown]
# ## The formula
#
# One equation for each channel, here for red; for green and blue the index changes, and nothing else:
#
# $$ I_r = I_{d,r}\, k_{d,r}\, (\mathbf{N} \cdot \mathbf{L}) + I_{s,r}\, k_{s,r}\, (\mathbf{R} \cdot \mathbf{V})^n + I_{a,r}\, k_{a,r} $$
#
# A light has three colours, $I_d$, $I_s$, $I_a$ (`GL_DIFFUSE`, `GL_SPECULAR`, `GL_AMBIENT` of `glLightfv`), a material has
# three reflectances, $k_d$, $k_s$, $k_a \in [0, 1]$ (the same names in `glMaterialfv`), and the shininess $n$. That a
# real lamp has one colour only does not bother OpenGL.

# %%
glsim.source(
    "shaders/light.glsl",
    "color += strength * face.k_d.rgb * light.I_d.rgb * N_L;",
    lines=2,
)

# %% The three products as numbers: light times reflectance, channel by channel
import numpy as np

red = np.array([1.0, 0.0, 0.0])
for name, k_d in (("white", [1, 1, 1]), ("green", [0, 1, 0]), ("yellow", [1, 1, 0])):
    print(f"red light on a {name} surface: {red * k_d}")


# %% The same brown ball in white light: its highlight with a white k_s, and with a k_s of its own colour
def brown(metal):
    glClearColor(0.3, 0.31, 0.34, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for what in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(what)
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1.5, 2, 0])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.4, 0.22, 0.08, 1])
    k_s = [0.9, 0.6, 0.25, 1] if metal else [0.6, 0.6, 0.6, 1]
    glMaterialfv(GL_FRONT, GL_SPECULAR, k_s)
    glMaterialf(GL_FRONT, GL_SHININESS, 25)
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glutSolidSphere(0.8, 64, 48)


glsim.compare(
    brown,
    modes="phong",
    sweep={"metal": [False, True]},
    columns="metal",
    captions={"False": "like plastic", "True": "like copper"},
    size=320,
    samples=4,
    differences="off",
    live="lights.diffuse, lights.specular, materials.diffuse, materials.specular",
)

# %% Materials are little tables of k_a, k_d, k_s and n: metals have a coloured k_s, plastics a white one
glsim.compare(
    "teapot",
    modes="phong",
    sweep={"material": ["brass", "red-plastic", "emerald", "black-rubber"]},
    columns="material",
    differences="off",
    camera="30,20,3.8",
    size=260,
    samples=4,
    live="lights.position, materials",
)

# %% [markdown]
# ## Try this
#
# 1. Make the light yellow, (1, 1, 0). Which ball changes least against white light?
# 2. Give the shiny ball $k_s = (0, 1, 0)$. What is its highlight in red light, and which material does that?
# 3. Set `GL_DIFFUSE` of the light to red and leave `GL_SPECULAR` white. No lamp is like that; does the picture tell?
#
# ## Questions
#
# The slide asks: red light on a white object, on a green one, and the colour of the highlight on a shiny one?
#
# <details><summary>Answer</summary>
#
# Red: $(1,0,0) \cdot (1,1,1) = (1,0,0)$. Black: $(1,0,0) \cdot (0,1,0) = (0,0,0)$. The highlight is light times $k_s$:
# red on plastic ($k_s$ white); on a green metal ($k_s$ green) there is none.
#
# </details>
#
# ## Exercise
#
# Exercise 9 (lesson 12): lights and materials, channel by channel.
