# %% [markdown]
# # 8. Specular reflection and the Phong model
#
# A billiard ball has a bright spot, and the spot is not painted on: walk around the ball and it walks with you. It is
# the image of the lamp, blurred by a surface that is not quite a mirror. In 1975 Bui Tuong Phong gave it a formula.

# %% [markdown]
# ## Predict
#
# A striped ball is lit by one lamp. Now the *eye* walks to the right; lamp and ball stay where they are. What moves over
# the stripes?
#
# - the highlight and the edge of the shadow
# - only the highlight
# - nothing: the lamp did not move

# %% The same ball and lamp, seen from the front and from 25 and 50 degrees to the right
from math import cos, pi, radians, sin

import glsim
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective


def ball():
    """A unit sphere in 12 stripes, red and cream."""
    for j in range(48):
        stripe = [0.65, 0.1, 0.08, 1] if j // 4 % 2 else [0.7, 0.62, 0.48, 1]
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, stripe)  # k_a, k_d
        glBegin(GL_QUAD_STRIP)
        for i in range(33):
            theta = pi * i / 32
            for phi in (2 * pi * j / 48, 2 * pi * (j + 1) / 48):
                N = sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi)
                glNormal3f(*N)
                glVertex3f(*N)
        glEnd()


def scene(degrees=0):
    """The ball, seen from so many degrees to the right."""
    glClearColor(0.16, 0.17, 0.2, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glShadeModel(GL_PHONG_WIN)
    glLightModeli(GL_LIGHT_MODEL_SPECULAR_LOBE_GLSIM, GL_PHONG_LOBE_GLSIM)
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1)
    glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])  # k_s
    glMaterialf(GL_FRONT, GL_SHININESS, 30)  # n
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(28, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    eye = 5 * sin(radians(degrees)), 0, 5 * cos(radians(degrees))
    gluLookAt(*eye, 0, 0, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [-3, 3, 5, 1])  # the lamp stays in the world
    ball()


glsim.compare(
    scene,
    modes="phong",
    lobes="phong",
    sweep={"degrees": [0, 25, 50]},
    columns="degrees",
    size=320,
    samples=4,
    differences="off",
    live="camera",
)

# %% [markdown]
# ## What you should see
#
# Count the stripes. The edge of the shadow lies on the same stripe in all three pictures: diffuse light does not know the
# eye. The highlight wanders over the stripes, after us. It is where the surface mirrors the lamp towards the eye, and
# another eye needs another place of the surface.

# %% [markdown]
# ## The formula
#
# $$ I = I_L\, k_d\, (\mathbf{N} \cdot \mathbf{L}) + I_L\, k_s\, (\mathbf{R} \cdot \mathbf{V})^n $$
#
# $\mathbf{R}$ is the direction of perfect reflection, $\mathbf{V}$ the direction towards the eye, both of unit length;
# their dot product is $\cos\varphi$. $k_s \in [0, 1]$ is the specular reflectance, and the **shininess** $n$ says how fast
# the highlight falls off: $n = 1$ is a wide gleam, $n = 100$ a small hard spot, $n \to \infty$ a mirror that shows
# nothing but the lamp. Where $\mathbf{N} \cdot \mathbf{L}$ or $\mathbf{R} \cdot \mathbf{V}$ is negative there is no highlight.

# %%
glsim.source("shaders/specular.glsl", "float phong(", lines=6)

# %% cos to the power of n for the angle between R and V
from glsim import plots

plots.powers((1, 5, 20, 100))

# %% A ball with n = 2, 10, 50 and 128: keys 1 to 4 swap the pictures in place
glsim.compare(
    "sphere:64",
    modes="phong:phong",
    sweep={"shininess": [2, 10, 50, 128]},
    columns="shininess",
    size=300,
    samples=4,
    differences="off",
    live="lights.position, materials.shininess",
)

# %% [markdown]
# The middle of the highlight, where $\mathbf{R} = \mathbf{V}$, is equally bright in all four: $1^n = 1$. Only its width
# changes.

# %% The vectors at a pixel below the highlight: R misses V by phi = 39 degrees, and 0.78 to the power of 30 is 0.0005
glsim.show(
    scene,
    still=glsim.vectors(scene, 165, 265),
    point=(165, 265),
    controls="lights.position, materials.specular, materials.shininess",
)

# %% [markdown]
# The model is empirical: no law of physics has a power of a cosine in it. It became popular because it is cheap, and
# because one look at a sphere tells whether $n$ is right.
#
# > **The slide says** $n$ twice: for the normal and for the exponent. We write $\mathbf{N}$ and $n$. And it does not say
# > that a negative $\mathbf{R} \cdot \mathbf{V}$ counts as 0. It must: with an even exponent $(-0.9)^{20} = 0.12$ would be a
# > highlight on the wrong side.
#
# ## Try this
#
# 1. Set `GL_SPECULAR` to `[0.8, 0.5, 0.1, 1]`. Does it still look like plastic, or more like metal?
# 2. Set `eye` 90 degrees to the right, `scene(90)`. How much of the highlight is left?
# 3. Move the lamp behind the ball, `[-1, 0, -5, 1]`. Look for a highlight at the rim: in which of the pictures?
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
# Exercise 6 (lesson 8): write Phong's (R·V)ⁿ.
