# %% [markdown]
# # 31. The linear system
#
# $B_i = E_i + \rho_i \sum_j F_{ij} B_j$ says what one patch sends, if one knows what all others send. But those do not
# know either before they know the first. The way out is to write the sentence down for all patches at once: $n$
# equations for $n$ unknowns, and linear ones at that.

# %% [markdown]
# ## Predict
#
# A cube has six walls; the front wall is a lamp. Each wall is one patch. The two walls that touch a corner see each
# other at a right angle, opposite walls face each other. Which pair has the larger form factor?
#
# - opposite walls: they face each other
# - neighbours: they are nearer
# - both have the same

# %% Form factors of the six walls of a cube
import numpy as np

import glsim
from glsim import plots, radiosity

cube = radiosity.solve("goral", patches=6)
walls = ["left", "right", "floor", "ceiling", "back", "lamp"]
plots.matrix(cube, labels=walls)

# %% [markdown]
# ## What you should see
#
# All are 0.2, to two digits: opposite walls see each other straight on but are a whole side apart, neighbours touch but
# see each other at an angle, and the two effects come out almost even (exactly: 0.1998 and 0.2000). The diagonal is 0,
# for flat walls do not see themselves. Each row sums to 1: the cube is closed.

# %% [markdown]
# ## The formula
#
# Bring all unknowns to one side, $E_i = B_i - \rho_i \sum_j F_{ij} B_j$, and write one row for each patch:
#
# $$ \begin{pmatrix} E_1 \\ E_2 \\ \vdots \\ E_n \end{pmatrix} = \begin{pmatrix} 1 - \rho_1 F_{11} & -\rho_1 F_{12} &
# \cdots & -\rho_1 F_{1n} \\ -\rho_2 F_{21} & 1 - \rho_2 F_{22} & \cdots & -\rho_2 F_{2n} \\ \vdots & & \ddots & \vdots
# \\ -\rho_n F_{n1} & -\rho_n F_{n2} & \cdots & 1 - \rho_n F_{nn} \end{pmatrix} \begin{pmatrix} B_1 \\ B_2 \\ \vdots
# \\ B_n \end{pmatrix} $$
#
# or $E = (I - R F)\, B$, with the reflectances $\rho_i$ on the diagonal of $R$. There is one such system for each
# colour channel: $F$ is the same for all, $\rho$ and $E$ are not.

# %%
glsim.source("radiosity/solvers.py", "result = -(self.rho[:, channel]", lines=3)

# %% The whole system of the cube for red light: E, the matrix I - R F, and the solution B
plots.system(cube, channel=0)

# %% [markdown]
# The lamp reflects nothing, so its row is the bare equation $B = E = 1$. The left wall is red ($\rho = 0.75$), the
# right one blue ($\rho = 0.1$ for red light): their rows are the same but for that factor.
#
# > **The slide says** "solve the system for the exiting fluxes $B_i$". The $B_i$ are flux *densities*, power per unit
# > of area (W/m²). The flux of a patch is $B_i A_i$.

# %% Six walls become a few hundred patches: the cube's picture, with each wall's own light and the colours it catches
fine = radiosity.solve("goral", patches=400)
fine.picture(480)

# %% The matrix of form factors of all patches, on a logarithmic scale; blocks are pairs of walls
plots.matrix(fine, log=True)

# %% [markdown]
# Blocks on the diagonal are empty: patches of one wall do not see each other. The matrix is never sparse otherwise,
# and it grows with $n^2$: 1,000 patches have a million form factors, 100,000 have ten thousand million. That is why
# the matrix is solved by iterations that read it a few times, and why large scenes need links between coarse patches
# instead of a matrix.

# %% The largest term of a row is the diagonal: at most rho of the light is passed on
M = np.eye(6) - cube.patches.rho[:, [0]] * np.array(
    [cube.factors.row(i) for i in range(6)]
)
print(
    "diagonal",
    np.diag(M).round(2),
    "  sum of the others",
    (np.abs(M).sum(axis=1) - np.diag(M)).round(2),
)
print("solved by numpy:", np.linalg.solve(M, cube.patches.E[:, 0]).round(4))

# %% [markdown]
# ## Try this
#
# 1. `channel=0` to `channel=2`: which numbers of the system change, and which do not?
# 2. Solve `"furnace"` with `patches=6`. Why are all entries of $B$ equal?
# 3. `patches=400` to `patches=900`: how do the matrix picture and the seconds in `fine.report()["seconds"]` grow?
#
# ## Questions
#
# Why has the system exactly one solution?
#
# <details><summary>Answer</summary>
#
# Rows of $F$ sum to at most 1 and $\rho_i < 1$, so in each row the diagonal is larger than the sum of the others: the
# matrix is *strictly diagonally dominant*, and such a matrix can be inverted. It also makes Jacobi's and Gauss-Seidel's
# iterations converge from any start.
#
# </details>
#
# ## Exercise
#
# Exercise 27 (lesson 31): assemble the n x n system.
