# %% [markdown]
# # 29. Patches and form factors
#
# A lamp does not light a wall only: the wall lights the floor, the floor the ceiling, and all of them each other, for
# ever. Radiosity makes this countable. It cuts all surfaces into small **patches**, gives each patch one brightness,
# and asks of every pair of patches a single number: which share of what leaves the first arrives at the second?

# %% [markdown]
# ## Predict
#
# In the picture below one patch of the floor, in front of the short block, is orange. It sends light in all
# directions. Which of the surfaces that you see gets the most of it, per unit of area?
#
# - the ceiling straight above it, because it faces the patch
# - the side of the short block next to it, because it is near
# - the back wall, because it is the largest

# %% Where the light of the orange patch goes: bright patches get much of it, per unit of area
import numpy as np

import glsim
from glsim import radiosity

box = radiosity.solve("cornell", patches=400)
middle = box.patches.center
floor = np.flatnonzero(middle[:, 1] < 1)
patch = floor[np.argmin(np.linalg.norm(middle[floor] - [200, 0, 40], axis=1))]
box.row_picture(patch, size=600)

# %% [markdown]
# ## What you should see
#
# The foot of the block beside the patch is brightest, 25 times as bright as the best place of the ceiling: it is near.
# The share falls with the square of the distance, and the ceiling, straight above, is more than ten times as far away.
# Behind the block it is black: from there the patch cannot be seen.

# %% [markdown]
# ## The formula
#
# The **form factor** $F_{ij}$ is the share of the light leaving patch $i$ that arrives at patch $j$, between 0 and 1:
#
# $$ F_{ij} = \frac{1}{A_i} \int_{A_i} \int_{A_j} \frac{\cos\theta_i \cos\theta_j}{\pi r^2}\, V\; dA_j\, dA_i $$
#
# $A_i$, $A_j$ are the patches' areas, $r$ is the distance between two of their points, $\theta_i$ and $\theta_j$ are the
# angles between the line that joins the points and the normals, and $V$ is 1 where the points see each other and 0
# where they do not. Geometry alone decides: no colour, no lamp.
#
# > **The slide says** "fraction of energy leaving polygon $A_i$ and arriving at polygon $A_i$". The second one is $A_j$.

# %% Two cosines and a distance: the form factor of a small square that is turned away
from glsim import plots

plots.form_factor_angle()

# %% Far away the form factor falls with the square of the distance; near, it approaches 1 and the small-patch formula fails
plots.form_factor_distance()

# %% [markdown]
# Nusselt's picture of the same number: seen from a point, a patch covers a part of the hemisphere. Projected down to
# the ground, that part covers a share of the unit disc. The share *is* the form factor. Two patches that look alike
# from the point have the same form factor, however far away they are.

# %% Nusselt's analog: the solid angle, and its projection on the ground
plots.nusselt()

# %% [markdown]
# How does one find the double integral? For a few pairs there is a closed formula. Otherwise one takes the mean over
# random points of both patches, as glsim's method `monte-carlo` does: a ray for each pair of points says whether $V$ is
# 1 or 0. Its default method integrates along the patches' edges, which is exact, and uses rays for $V$ only.

# %%
glsim.source("radiosity/textbook.py", "values[seen] = kernel[seen]")

# %% [markdown]
# ## Try this
#
# 1. Move the patch: `[200, 0, 40]` to `[420, 0, 60]`, in front of the tall block. Where does its light go now?
# 2. `patches=400` to `patches=100`, then `1500`. Which features of the picture belong to the patches, not to the light?
# 3. Print `box.factors.row(patch).sum()`. What must it be in a closed room, and why is it not exactly that?
#
# ## Questions
#
# What is $F_{ii}$ of a flat patch?
#
# <details><summary>Answer</summary>
#
# 0. Light that leaves a flat patch never comes back to it directly: every direction leads away. A patch that is curved
# inwards, like the inside of a bowl, has $F_{ii} > 0$.
#
# </details>
#
# ## Exercise
#
# Exercise 25 (lesson 29): write the form factor of two patches.
