# %% [markdown]
# # 17. The whole equation, on one pixel
#
# Ten lessons, one formula. Time to put it on the table with numbers: every factor of every term of one pixel, and after
# them the pixel itself. If you can recompute it with pencil and paper, you have understood the lecture.

# %% A ball with a warm lamp on the left and a cool one on the right, and the vectors at the pixel that we ask about
import glsim
from glsim.gl import *
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(400, 400)
with glsim.capture(calls=True) as frame:
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glShadeModel(GL_PHONG_WIN)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0.2, 0.2, 0.2, 1])  # I_a
    glEnable(GL_LIGHT0)  # the warm lamp
    glLightfv(GL_LIGHT0, GL_POSITION, [-2, 2, 4, 0])
    glLightfv(GL_LIGHT0, GL_DIFFUSE, [1, 0.9, 0.7, 1])
    glLightfv(GL_LIGHT0, GL_SPECULAR, [1, 0.9, 0.7, 1])
    glEnable(GL_LIGHT1)  # the cool lamp
    glLightfv(GL_LIGHT1, GL_POSITION, [4, 0, 1, 0])
    glLightfv(GL_LIGHT1, GL_DIFFUSE, [0.2, 0.3, 0.5, 1])
    glLightfv(GL_LIGHT1, GL_SPECULAR, [0.2, 0.3, 0.5, 1])
    glMaterialfv(GL_FRONT, GL_EMISSION, [0.05, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_AMBIENT, [0.6, 0.25, 0.1, 1])  # k_a
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.6, 0.25, 0.1, 1])  # k_d
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.4, 0.4, 0.4, 1])  # k_s
    glMaterialf(GL_FRONT, GL_SHININESS, 20)  # n
    glMatrixMode(GL_PROJECTION)
    glOrtho(-1, 1, -1, 1, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glutSolidSphere(0.8, 64, 48)
glsim.show(
    frame,
    still=glsim.vectors(frame, 180, 165),
    point=(180, 165),
    controls="lights.position, materials.diffuse, materials.shininess",
)

# %% [markdown]
# ## Predict
#
# The ball is brown: its diffuse reflectance for blue is only 0.1. At the pixel where the arrows begin, which term gives
# most of the *blue*?
#
# - ambient: the glow has as much blue as red
# - diffuse: the pixel faces the warm lamp
# - specular: its reflectance is 0.4 in every channel

# %% The pixel (180, 165): every factor of every term
probe = glsim.probe(frame, 180, 165)
probe

# %% [markdown]
# ## What you should see
#
# In red the diffuse term of light 0 is the largest, 0.56 against 0.37 of the specular term. In blue it is the other way
# round: 0.07 diffuse, 0.26 specular. A highlight takes its colour from the lamp and from $k_s$, and cares nothing for
# brown. The cool lamp adds 0.01 at most: it grazes the ball here, $\mathbf{N} \cdot \mathbf{L} = 0.12$. The sum for red is
# 1.11. A screen has no more than 1, so red is clamped; 255 times the rest, rounded, is the pixel.

# %% [markdown]
# ## The formula
#
# $$ I = \underbrace{e}_{\text{emission}} + \underbrace{k_a I_a}_{\text{glow}} + \sum_i a_i s_i \big( k_a I_{a,i} + k_d I_{d,i}
# \max(\mathbf{N} \cdot \mathbf{L}_i, 0) + k_s I_{s,i}\, (\mathbf{N} \cdot \mathbf{H}_i)^n \big) $$
#
# $I$ is one channel of the colour, clamped to $[0, 1]$ at the end. $e$: light that the surface gives off by itself. $k_a, k_d,
# k_s \in [0, 1]$: the material; $n \in [0, 128]$: its shininess. $I_a$: the glow of the scene; $I_{a,i}, I_{d,i}, I_{s,i} \ge 0$:
# the colours of light $i$; $a_i$ its attenuation and $s_i$ its spotlight factor (lesson 23; both are 1 here).

# %% [markdown]
# $\mathbf{N}$, $\mathbf{L}_i$ and $\mathbf{H}_i$, halfway between $\mathbf{L}_i$ and $\mathbf{V}$, are unit vectors. Where
# $\mathbf{N} \cdot \mathbf{L}_i \le 0$ the specular term is 0 too. The lines of GLSL that add up one light:

# %%
glsim.source(
    "shaders/light.glsl", "color += strength * face.k_a.rgb * light.I_a.rgb;", lines=5
)

# %% The same sum in NumPy, written out: what comes out is the pixel
import numpy as np


def unit(v):
    return np.array(v) / np.linalg.norm(v)


N = np.array(probe.winner.N)
V = np.array([0, 0, 1])  # GL_LIGHT_MODEL_LOCAL_VIEWER is 0: the eye is far away
k_d, k_s, n = np.array([0.6, 0.25, 0.1]), 0.4, 20
I = np.array([0.05, 0, 0]) + k_d * 0.2  # emission + k_a I_a
lamps = (([-2, 2, 4], [1, 0.9, 0.7]), ([4, 0, 1], [0.2, 0.3, 0.5]))
for position, I_L in lamps:
    L = unit(position)
    H = unit(L + V)
    if N @ L > 0:
        I += np.array(I_L) * (k_d * (N @ L) + k_s * (N @ H) ** n)
print("by hand:  ", np.round(255 * np.clip(I, 0, 1)))
print("the pixel:", probe.pixel[:3])

# %% The picture taken apart: images that add up to it
glsim.terms(frame)

# %% [markdown]
# Each row is a picture of one factor or term. Emission and glow are flat discs without shape. The diffuse images have the
# lamps' colours times brown; the specular images have the lamps' own colours. Add all of them, pixel by pixel, and you
# have the first.
#
# ## And who said so?
#
# Every number of the equation was set by some call of the program, or is OpenGL's initial value. `glsim.explain` knows
# which:

# %% For each number of the equation the call that set it
for setting in glsim.explain(frame)[0].uniforms:
    if setting.name.startswith(("material", "I_a")):
        calls = [origin.text for origin in setting.origins]
        print(f"{setting.name:24} {calls[-1] if calls else 'the initial value'}")

# %% Where the equation is evaluated changes the pixel, too: a coarse ball, flat, Gouraud and Phong shaded
glsim.compare(
    "sphere:12",
    modes="flat,gouraud,phong",
    lobes="blinn",
    size=280,
    samples=4,
    differences="off",
    live="edges, lights.position",
)

# %% [markdown]
# That is the whole shading model of the lecture: **what** (the sum of terms, channel by channel) and **where** (per
# polygon, per vertex, per pixel).
#
# > **The slide says** on the ambient glow $I_L\, k_a \cos\theta$ for the diffuse term. It is $k_d$ that belongs there; if
# > your copy of the summary has a $k_a$ in that place too, mend it. And the summary writes the three terms without the sum
# > over the lights, without $\max(\cdot, 0)$ and without the clamp at the end: all three are needed to get a pixel right.
#
# ## Try this
#
# 1. Probe (300, 200), where the warm lamp is weak. Which lamp has the larger diffuse term there, in red and in blue?
# 2. Probe (20, 20), a corner. What does the probe say?
# 3. Set $k_s$ to 1. Which channels are clamped in the middle of the highlight, and which colour does it take?
#
# ## Questions
#
# Which factors of the equation change from pixel to pixel of this ball, and which are the same everywhere?
#
# <details><summary>Answer</summary>
#
# Only $\mathbf{N}$ changes, and with it $\mathbf{N} \cdot \mathbf{L}$ and $\mathbf{N} \cdot \mathbf{H}$. Both lights are
# directions and the viewer is infinitely far: $\mathbf{L}$, $\mathbf{V}$ and $\mathbf{H}$ are constant. That is why a sphere
# shows a material so well: it has every normal once.
#
# </details>
#
# ## Exercise
#
# Exercise 14 (lesson 17): mend a program with the classic mistakes.
