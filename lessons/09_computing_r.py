# %% [markdown]
# # 9. Computing R
#
# The highlight needs the direction in which a mirror would send the light. No angle has to be computed for it, and no
# sine: two dot products and a subtraction do.

# %% [markdown]
# ## Predict
#
# $\mathbf{L}$ is a unit vector that stands at 35° to the normal $\mathbf{N}$. How long is its projection onto the normal,
# $(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N}$?
#
# - 1, because both are unit vectors
# - $\cos 35° \approx 0.82$
# - $\sin 35° \approx 0.57$

# %% L, its projection on N, the rest S, and R put together of both
import numpy as np

import glsim
from glsim import plots, shading

plots.computing_r(35)

# %% [markdown]
# ## What you should see
#
# $\mathbf{L}$ is made of two parts: its shadow on the normal, $(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N}$, of the length
# $\cos 35°$, and what is left over, lying flat on the surface. A mirror keeps the first part and turns the second round.
# With $\mathbf{S}$ as the arrow from $\mathbf{L}$ to the projection, $\mathbf{R}$ is the projection plus $\mathbf{S}$ once
# more.

# %% [markdown]
# ## The formula
#
# $$ \mathbf{S} = (\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} - \mathbf{L}, \qquad \mathbf{R} = (\mathbf{N} \cdot \mathbf{L})\,
# \mathbf{N} + \mathbf{S} = 2\,(\mathbf{N} \cdot \mathbf{L})\,\mathbf{N} - \mathbf{L} $$
#
# $\mathbf{N}$ is the unit normal, $\mathbf{L}$ the unit vector towards the light, $\mathbf{R}$ the direction of the mirrored
# light, away from the surface. $\mathbf{R}$ is a unit vector too, if the others are.

# %%
glsim.source("shaders/specular.glsl", "vec3 S = dot(N, L) * N - L;", lines=2)

# %% R in numbers: it has the length of L, and the same angle to N on the other side
N = np.array([0.0, 0.0, 1.0])
L = np.array([-0.6, 0.0, 0.8])
R = shading.reflection(N, L)
print("R =", R, "  length", np.linalg.norm(R), "  N.L =", N @ L, "  N.R =", N @ R)

# %% [markdown]
# All of this holds for **unit vectors** only. Here is what happens to the mirror direction if the normal is too long,
# as it is after `glScalef` without `GL_NORMALIZE`:

# %% The direction R for normals of the length 1, 1.1 and 1.5: only the first is a mirror
for length in (1.0, 1.1, 1.5):
    too_long = length * N
    R = 2 * (too_long @ L) * too_long - L
    angle = np.degrees(np.arccos(R[2] / np.linalg.norm(R)))
    print(f"|N| = {length}: R = {R.round(2)}, {angle:.1f} degrees from N")

# %% Four rays and their mirror directions
plots.reflection((15, 35, 55, 75))

# %% On a real surface: N, L, R and V at a pixel of the teapot
glsim.vectors("teapot", 200, 260)

# %% [markdown]
# > **The slide says** "all vectors are unit length!" and is right to shout: with a normal of the length 1.1 the
# > reflected ray has already turned by several degrees, and $(\mathbf{R} \cdot \mathbf{V})^n$ can exceed 1.
#
# ## Try this
#
# 1. `plots.computing_r(35)` with 10 and 80 degrees: which of the two parts is large where?
# 2. Compute `shading.reflection(N, R)`. Why is it `L` again?
# 3. Mirror a light from behind the surface, `L = [0.6, 0, -0.8]`. Where does R point, and why does OpenGL not care?
#
# ## Questions
#
# When is $\mathbf{R} = \mathbf{L}$, and when is $\mathbf{R} = -\mathbf{L}$?
#
# <details><summary>Answer</summary>
#
# $\mathbf{R} = \mathbf{L}$ if the light stands in the direction of the normal: $\mathbf{S} = 0$. $\mathbf{R} = -\mathbf{L}$ if
# it grazes the surface, $\mathbf{N} \cdot \mathbf{L} = 0$: the light goes straight on.
#
# </details>
#
# ## Exercise
#
# Exercise 4: write the reflection vector.
