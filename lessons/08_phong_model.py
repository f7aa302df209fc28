# %% [markdown]
# # 8. Specular reflection and the Phong model
#
# A billiard ball has a bright spot, and the spot is not painted on: walk around the ball and it walks with you. It is
# the image of the lamp, blurred by a surface that is not quite a mirror. In 1975 Bui Tuong Phong gave it a formula.

# %% [markdown]
# ## Predict
#
# A ball is lit by one lamp. Now the *eye* moves to the side, lamp and ball stay where they are. What moves across the
# ball?
#
# - the bright side and the highlight
# - only the highlight
# - nothing: the lamp did not move

# %% The same ball and lamp, seen from the front and from 20 and 40 degrees to the right
from math import cos, radians, sin

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(840, 280, samples=4)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM)
glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.6, 0.12, 0.1, 1])  # k_d
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.8, 0.8, 0.8, 1])  # k_s
glMaterialf(GL_FRONT, GL_SHININESS, 30)  # n
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)

for column, degrees in enumerate((0, 20, 40)):
    glViewport(280 * column, 0, 280, 280)
    glLoadIdentity()
    eye = 5 * sin(radians(degrees)), 0, 5 * cos(radians(degrees))
    gluLookAt(*eye, 0, 0, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [-3, 3, 5, 1])  # the lamp stays in the world
    glutSolidSphere(1.1, 64, 48)
screen

# %% [markdown]
# ## What you should see
#
# The lit half stays with the lamp: as we walk to the right, more of the dark half comes into view. The highlight comes
# along. It is where the surface mirrors the lamp towards the eye, and another eye needs another place of the surface.

# %% [markdown]
# ## The formula
#
# $$ I = I_L\, k_d\, (\mathbf{N} \cdot \mathbf{L}) + I_L\, k_s\, (\mathbf{R} \cdot \mathbf{V})^n $$
#
# $\mathbf{R}$ is the direction of perfect reflection, $\mathbf{V}$ the direction towards the eye, both of unit length;
# their dot product is $\cos\varphi$. $k_s \in [0, 1]$ is the specular reflectance, and the **shininess** $n$ says how fast
# the highlight falls off: $n = 1$ is a wide gleam, $n = 100$ a small hard spot, $n \to \infty$ a mirror that shows
# nothing but the lamp. Where $\mathbf{N} \cdot \mathbf{L} < 0$ there is no highlight.

# %%
glsim.source("shaders/specular.glsl", "float phong(", lines=6)

# %% cos to the power of n for the angle between R and V
from glsim import plots

plots.powers((1, 5, 20, 100))

# %% The same ball with n = 2, 10, 50 and 128: keys 1 to 4 swap the pictures in place
glsim.compare("sphere", modes="phong:phong", sweep={"shininess": [2, 10, 50, 128]},
              size=320, samples=4, differences="off", columns="shininess")  # fmt: skip

# %% Where the vectors point at a pixel beside the highlight: R misses V by the angle phi
glsim.vectors("sphere:48", 200, 190)

# %% [markdown]
# The model is empirical: no law of physics has a power of a cosine in it. It became popular because it is cheap, and
# because one look at a sphere tells whether $n$ is right.
#
# > **The slide says** "a common specular reflection term is added". Mind what it multiplies: $k_s$ is a colour of its
# > own. On plastic it is white whatever the plastic's colour; on metals it has the metal's colour.
#
# ## Try this
#
# 1. Set `GL_SPECULAR` to the colour of `GL_DIFFUSE`. Does it still look like a billiard ball, or more like metal?
# 2. Use `glShadeModel(GL_SMOOTH)` and a sphere of 12 slices: what happens to the highlight? (Lesson 15 is about it.)
# 3. Move the lamp behind the ball, `[-1, 0, -5, 1]`. Is there a highlight at the rim?
#
# ## Questions
#
# The highlight of $n = 20$ has fallen to a half at some angle. At which, and at which for $n = 80$?
#
# <details><summary>Answer</summary>
#
# $\cos^n \varphi = 0.5$ gives $\varphi = \arccos(0.5^{1/n})$: 15.0° for 20, 7.5° for 80. Four times the exponent halves
# the width, as long as the angles are small.
#
# </details>
#
# ## Exercise
#
# Exercise 6: write Phong's (R·V)ⁿ.
