# %% [markdown]
# # 5. Reflection and refraction
#
# Stand at a lake. At your feet you see the stones on the ground; far out you see the sky. It is the same water. Where
# light meets a smooth boundary, one part is thrown back and the rest goes on, bent. Three laws say where to, and how much.

# %% [markdown]
# ## Predict
#
# A lamp inside a block of glass shines at the boundary to the air, at 20°, 40° and 60° from the normal. How does the
# ray at 60° leave the glass?
#
# - bent towards the normal
# - bent away from it, almost along the boundary
# - it does not leave

# %% Rays from glass into air at 20°, 40° and 60°; their width is the share of the light
import glsim
from glsim.gl import *

glsim.plots.refraction("glass", "air", (20, 40, 60))

# %% [markdown]
# ## What you should see
#
# From glass into air a ray is bent *away* from the normal: 20° become 31°, 40° become 75°. There is no angle beyond 90°,
# and so at 60° nothing leaves: the boundary is a perfect mirror. This **total reflection** begins at 41.8° and keeps
# light inside a glass fibre. Each of the other rays is split: a weak part is reflected, the rest goes through.

# %% [markdown]
# ## The formula
#
# The **law of reflection**: the reflected ray lies in the plane of $\mathbf{N}$ and $\mathbf{L}$, and leaves at the angle
# at which the light came, $\theta_r = \theta_i$. With unit vectors
#
# $$ \mathbf{R} = 2\,(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} - \mathbf{L} $$
#
# **Snell's law** of refraction: $n_1 \sin\theta_1 = n_2 \sin\theta_2$, where $n_1, n_2$ are the refractive indices of the
# two media (the speed of light in vacuum over that in the medium: air 1.0, water 1.33, glass 1.5, diamond 2.42) and the
# angles are taken from the normal.

# %%
glsim.source("shading/terms.py", "projected = dot(N, L)", lines=3)

# %%
glsim.source("shading/terms.py", "ratio = n_1 / n_2", lines=4)

# %% The law of reflection at 20°, 45° and 70°: each ray leaves at the angle at which it came
glsim.plots.reflection((20, 45, 70))

# %% Snell's law as curves: into water and glass, and out of glass, where it ends at 41.8°
glsim.plots.snell()

# %% [markdown]
# ## How much
#
# **Fresnel's equations** give the share that is reflected. For light across the plane of incidence ($s$) and in it ($p$)
#
# $$ F_s = \left(\frac{n_1\cos\theta_1 - n_2\cos\theta_2}{n_1\cos\theta_1 + n_2\cos\theta_2}\right)^2, \qquad
#    F_p = \left(\frac{n_1\cos\theta_2 - n_2\cos\theta_1}{n_1\cos\theta_2 + n_2\cos\theta_1}\right)^2 $$
#
# Ordinary light is half of each: $F = (F_s + F_p)/2 \in [0, 1]$. The rest, $1 - F$, goes into the second medium. At
# $\theta_1 = 0$ both are $((n_1 - n_2)/(n_1 + n_2))^2$: 4 % for glass, 2 % for water.

# %% Fresnel: the share reflected by water, glass, diamond, gold and silver over the angle of incidence
glsim.plots.fresnel()

# %% [markdown]
# Every curve ends at 1: at a grazing angle everything is a mirror, even water. That is the lake: at your feet you
# look straight down, where 2 % are reflected; far out you look along the surface.

# %% Three balls as bright as the share they reflect to the eye: water, glass, diamond
from math import cos, sin, sqrt, tau

from glsim.shading import fresnel

screen = glsim.offscreen(780, 260, samples=4)
glClearColor(0.02, 0.02, 0.03, 1)
glClear(GL_COLOR_BUFFER_BIT)
for column, n in enumerate((1.333, 1.5, 2.417)):
    glViewport(260 * column, 0, 260, 260)
    for k in range(60):  # rings; at the radius r N.V is sqrt(1 - r r)
        glBegin(GL_QUAD_STRIP)
        for j in range(91):
            for r in (k / 60, (k + 1) / 60):
                F = float(fresnel(sqrt(1 - r * r), 1.0, n))
                glColor3f(F, F, F)
                angle = tau * j / 90
                glVertex2f(0.9 * r * cos(angle), 0.9 * r * sin(angle))
        glEnd()
screen

# %% [markdown]
# A ball of water is nearly black in the middle and shines at its rim. Diamond reflects 17 % even straight on.
#
# > **The slide says** nothing about lengths. But $\mathbf{R} = 2(\mathbf{N} \cdot \mathbf{L})\mathbf{N} - \mathbf{L}$ needs
# > a unit $\mathbf{N}$: with a normal twice as long the first term is four times as large, and $\mathbf{R}$ points
# > elsewhere.

# %% [markdown]
# ## Try this
#
# 1. Swap the media: `refraction("air", "glass", (20, 40, 60))`. Is there still an angle at which nothing goes through?
# 2. Ask for `fresnel(["glass"], polarised=True)`. At which angle is one of the two polarisations not reflected at all?
# 3. Put `"diamond"` in place of `"glass"` in the first figure. Which of the three rays still leaves?

# %% [markdown]
# ## Questions
#
# From which angle on is light from water reflected totally at the air?
#
# <details><summary>Answer</summary>
#
# Where $\sin\theta_2 = 1$: $\sin\theta_1 = 1/1.333$, so $\theta_1 \approx 48.6°$.
#
# </details>
#
# What share of the light gets straight through a window pane of glass, which has two boundaries?
#
# <details><summary>Answer</summary>
#
# About $0.96 \cdot 0.96 \approx 92\,\%$. (A little more, because light that is reflected to and fro inside comes out, too.)
#
# </details>
#
# ## Exercise
#
# Exercise 4 (lesson 9): the reflection vector. Exercise 5 (lesson 5): Snell's refraction.
