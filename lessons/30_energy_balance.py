# %% [markdown]
# # 30. Energy balance and reciprocity
#
# Light is not lost on its way through a room. What a patch sends is what it emits plus what it reflects; what it
# reflects is a share of what arrives; and what arrives was sent by other patches. Written down, this sentence is the
# whole theory of radiosity.

# %% [markdown]
# ## Predict
#
# All walls of a closed cube emit the radiosity 1 and reflect a half of what arrives, all alike. What is the radiosity
# of the walls once light has bounced to and fro for long enough?
#
# - 1.5: what it emits and half of that
# - 2
# - infinite: light is added in every bounce and cannot leave

# %% Radiosity of the walls after 0, 1, 2, ... bounces of light
import numpy as np

import glsim
from glsim import plots, radiosity

cube = radiosity.solve("furnace", patches=6)
bounces = [
    step.B.mean() for step, _ in zip(cube.iterations("jacobi"), range(12), strict=False)
]
plots.curves(
    {"mean radiosity $B$": (range(12), bounces)}, "bounces", "radiosity", markers=True
)

# %% [markdown]
# ## What you should see
#
# The curve climbs to 2 and stays there. The walls emit 1; the first bounce adds a half, the second a quarter, then an
# eighth: $1 + \frac12 + \frac14 + \ldots = 2$. In general $B = E / (1 - \rho)$. Nothing is infinite, because at each
# bounce the wall keeps a half and warms up. With $\rho = 1$ the sum would have no end, and glsim refuses such a wall.

# %% [markdown]
# ## The formula
#
# Power is radiosity times area. The power that leaves patch $i$ is what it emits and the reflected share of what
# arrives from every patch $j$:
#
# $$ B_i A_i = E_i A_i + \rho_i \sum_j B_j A_j F_{ji} $$
#
# $B_i$ is the **radiosity**, the power that leaves per unit of area (W/m²), $E_i$ the part of it that the patch emits
# by itself (W/m²), $A_i$ the area (m²), $\rho_i \in [0, 1)$ the reflectance, which the slides call $R_i$, and $F_{ji}$
# the form factor from $j$ to $i$.

# %% [markdown]
# The **reciprocity** of form factors makes it simpler. A pair of patches has one integral over both areas, and each of
# the two form factors is that integral over the sender's area:
#
# $$ A_i F_{ij} = A_j F_{ji} $$
#
# The large patch sends a small share to the small one, the small one a large share to the large one. Put it in, divide
# by $A_i$, and the areas are gone:
#
# $$ B_i = E_i + \rho_i \sum_j F_{ij} B_j $$
#
# The index order has turned round: $F_{ij}$, though the light comes from $j$. It reads well once one knows why: the
# patch *gathers*, and $F_{ij}$ is how much of its view patch $j$ fills.

# %%
glsim.source("radiosity/solvers.py", "residual = self.E + self.rho * H - B")

# %% Reciprocity in numbers: A_i F_ij and A_j F_ji of a lamp and a patch of the floor
box = radiosity.solve("cornell", patches=400)
area = box.patches.area
lamp = np.flatnonzero(box.patches.E.any(axis=1))[0]
floor = np.flatnonzero(box.patches.center[:, 1] < 1)[10]
F_ij, F_ji = box.factors.row(lamp)[floor], box.factors.row(floor)[lamp]
print(
    f"F from the lamp to the floor {F_ij:.6f}   from the floor to the lamp {F_ji:.6f}"
)
print(f"A_i F_ij = {area[lamp] * F_ij:.4f}   A_j F_ji = {area[floor] * F_ji:.4f}")

# %% [markdown]
# In a closed room all that leaves a patch arrives somewhere, so each row of form factors sums to 1. And all that the
# lamps emit must be absorbed in the end. A radiosity program that is right shows both, and one that is wrong rarely
# does:

# %% Two checks of a solution: rows of form factors that sum to 1, and power absorbed over power emitted
report = box.report()
print(f"rows differ from the sum 1 by {report['row_sum_error_mean']:.5f} in the mean")
print(f"power absorbed / power emitted = {report['energy_balance']:.6f}")

# %% The same box: the picture that these numbers are of
box.picture(500)

# %% [markdown]
# ## Try this
#
# 1. In the last cells solve `"cornell-closed"`, whose front wall is white. Is the energy balance still 1?
# 2. `range(12)` to `range(4)`: how much of the light is still missing after three bounces?
# 3. Print `box.patches.rho.max()`: how many bounces does a room of that white need until 1 % of the light is left?
#
# ## Questions
#
# Why does reciprocity hold although the patches may have different sizes and directions?
#
# <details><summary>Answer</summary>
#
# The integrand $\cos\theta_i \cos\theta_j V / (\pi r^2)$ does not change if $i$ and $j$ are exchanged: the distance, the
# two cosines and the visibility are the same from both ends. Only the division by the sender's area differs.
#
# </details>
#
# ## Exercise
#
# Exercise 26 (lesson 30): use reciprocity, and check the energy balance of a room.
