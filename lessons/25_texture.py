# %% [markdown]
# # 25. Texture: surface detail
#
# An orange is not an orange sphere. What is missing is not light but *detail*: pores, spots, a label. A texture gives a
# material a value for every point of the surface, without a single vertex more.

# %% [markdown]
# ## Predict
#
# A checkerboard texture is put on a lit sphere with `GL_REPLACE` instead of `GL_MODULATE`. What is lost?
#
# - the checkerboard
# - the shading: the sphere looks like a flat disc
# - nothing, both do the same on a lit surface

# %% The lit sphere alone; the texture by GL_REPLACE; both multiplied by GL_MODULATE
import numpy as np

import glsim
from glsim.gl import *
from glsim.glu import gluNewQuadric, gluPerspective, gluQuadricTexture, gluSphere

screen = glsim.offscreen(840, 280, samples=4)
glClearColor(0.12, 0.13, 0.16, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1.5, 2, 0])
glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [0.9, 0.9, 0.9, 1])
glMaterialfv(GL_FRONT, GL_SPECULAR, [0.6, 0.6, 0.6, 1])
glMaterialf(GL_FRONT, GL_SHININESS, 40)

y, x = np.mgrid[0:64, 0:64]
checks = np.where(((x // 8 + y // 8) % 2)[..., None], [235, 110, 20], [250, 225, 170])
glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE,
             checks.astype(np.uint8))  # fmt: skip

ball = gluNewQuadric()
gluQuadricTexture(ball, True)
glMatrixMode(GL_PROJECTION)
gluPerspective(30, 1, 1, 10)
glMatrixMode(GL_MODELVIEW)


def draw(column, environment):
    glViewport(280 * column, 0, 280, 280)
    glLoadIdentity()
    glTranslatef(0, 0, -4.6)
    glRotatef(-70, 1, 0.2, 0)
    (glEnable if environment else glDisable)(GL_TEXTURE_2D)
    if environment:
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, environment)
    gluSphere(ball, 1, 64, 48)


for column, environment in enumerate((None, GL_REPLACE, GL_MODULATE)):
    draw(column, environment)
screen

# %% [markdown]
# ## What you should see
#
# With `GL_REPLACE` the texture takes the place of the lit colour: bright on the dark side too, and the ball looks like a
# flat sticker. With `GL_MODULATE` both are multiplied, texel times light, and the texture works like a $k_d$ that
# changes from point to point.

# %% [markdown]
# ## The formula
#
# At each fragment the texture coordinates $(s, t)$ choose a texel $C_t$, a colour in $[0, 1]$ per channel, and the
# texture environment combines it with the lit colour $C_f$:
#
# $$ \text{MODULATE: } C = C_f\, C_t \qquad \text{REPLACE: } C = C_t \qquad \text{DECAL: } C = C_f (1 - A_t) + C_t A_t $$
#
# $A_t$ is the texel's alpha, its opacity. `GL_MODULATE` is right for diffuse light only. A highlight is the lamp's image
# and must not be tinted: it is multiplied too, unless `GL_SEPARATE_SPECULAR_COLOR` adds it after texturing.

# %%
glsim.source("shaders/texture.glsl", "if (TEXENV[unit] == GL_MODULATE) {", lines=3)

# %% The highlight on a dark texture: multiplied away, and added afterwards with GL_SEPARATE_SPECULAR_COLOR
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
dark = np.where(((x // 8 + y // 8) % 2)[..., None], [20, 30, 70], [60, 20, 30])
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE,
             dark.astype(np.uint8))  # fmt: skip
draw(0, GL_MODULATE)
glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)
draw(1, GL_MODULATE)
screen

# %% [markdown]
# A texture has to be *filtered*. Where a texel covers many pixels one sees blocks or a blur; where a pixel covers many
# texels one sees noise, unless a **mipmap** holds means of 2 x 2, 4 x 4, ... texels.

# %% A long floor: GL_NEAREST, GL_LINEAR, and mipmaps with GL_LINEAR_MIPMAP_LINEAR
glDisable(GL_LIGHTING)
glEnable(GL_TEXTURE_2D)
glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1)
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB, GL_UNSIGNED_BYTE,
             checks.astype(np.uint8))  # fmt: skip
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
filters = (GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR)
for column, smaller in enumerate(filters):
    glViewport(280 * column, 0, 280, 280)
    larger = GL_NEAREST if smaller == GL_NEAREST else GL_LINEAR
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smaller)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, larger)
    glLoadIdentity()
    glRotatef(11, 1, 0, 0)
    glBegin(GL_QUADS)
    for s, t, px, pz in (
        (0, 0, -9, -1),
        (9, 0, 9, -1),
        (9, 20, 9, -9.9),
        (0, 20, -9, -9.9),
    ):
        glTexCoord2f(s, t)
        glVertex3f(px, -0.9, pz)
    glEnd()
screen

# %% [markdown]
# > **The slide says** an orange sphere lacks the texture of an orange. Colour is only half of it: the *pores* need
# > normals that change from point to point. A texture of normals (bump or normal map) came after OpenGL 1.5.
#
# ## Try this
#
# 1. Use `GL_DECAL` in the first figure. Why is it the same as `GL_REPLACE` for a texture without alpha?
# 2. Leave out the line with `GL_TEXTURE_MIN_FILTER`. The texture is gone: the default asks for mipmaps, and there are
#    none. What does `glsim trace --mistakes` say?
# 3. `glMatrixMode(GL_TEXTURE)` and `glScalef(4, 4, 1)` before drawing: what is scaled?
#
# ## Questions
#
# A texel is (0.5, 0.5, 0.5), the diffuse light at the point 0.8, the highlight 0.4. Which grey do you get with
# `GL_MODULATE`, and which with the separate specular colour?
#
# <details><summary>Answer</summary>
#
# The lit colour is clamped before texturing: $\min(0.8 + 0.4, 1) \cdot 0.5 = 0.5$. Separately:
# $0.8 \cdot 0.5 + 0.4 = 0.8$.
#
# </details>
#
# ## Exercise
#
# Exercise 21 (lesson 25): texture and GL_MODULATE.
