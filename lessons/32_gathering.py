# %% [markdown]
# # 32. Gathering step by step
#
# A system with a thousand unknowns is not solved by elimination. One guesses, puts the guess into the right side of
# $B_i = E_i + \rho_i \sum_j F_{ij} B_j$, gets a better guess, and repeats. The nice thing about radiosity: every step
# of this arithmetic is a step of light.

# %% [markdown]
# ## Predict
#
# Jacobi's iteration begins with $B = E$: only the lamps shine. Below is the Cornell box after 0, 1, 2, 3 and 8 steps.
# What does the first step add?
#
# - light on everything, but too dark: it has to be amplified step by step
# - light where the lamp shines directly, and only there
# - light on the ceiling too, because white walls reflect at once

# %% The Cornell box after 0, 1, 2, 3 and 8 steps of Jacobi's iteration
import numpy as np

import glsim
from glsim import plots, radiosity
from glsim.pictures import tiles

box = radiosity.solve("cornell", patches=250, drawn=0)


def pictures(solver, numbers, size=320):
    """Pictures of the box after these numbers of iterations, with their labels."""
    row = []
    for step in box.iterations(solver, many=1):
        if step.iteration in numbers:
            colors = box.colors(step.B[box.mesh.patch])
            picture = np.asarray(box.picture(size, colors=colors))
            row.append((f"{solver}, step {step.iteration}", picture))
        if step.iteration == max(numbers):
            return row


tiles("", [pictures("jacobi", (0, 1, 2, 3, 8))], 320)

# %% [markdown]
# ## What you should see
#
# Step 0 is the lamp alone. Step 1 is direct illumination: lit where the lamp is seen, black elsewhere, the ceiling too.
# Step 2 adds light that was reflected once, and the ceiling appears, with red and green from the walls. Each step adds
# one bounce, weaker than the one before. (Each patch is drawn in one colour here: these are the $B_i$ themselves.)

# %% [markdown]
# ## The formula
#
# **Jacobi** gathers for all patches from the radiosities of the step before:
#
# $$ B_i^{(k+1)} = E_i + \rho_i \sum_j F_{ij} B_j^{(k)} $$
#
# **Gauss-Seidel** takes the new value of every patch that was already visited in this sweep, so light may bounce many
# times within one sweep:
#
# $$ B_i^{(k+1)} = E_i + \rho_i \Big( \sum_{j<i} F_{ij} B_j^{(k+1)} + \sum_{j>i} F_{ij} B_j^{(k)} \Big) $$

# %% The light bounce by bounce, to step through and to walk round
glsim.show(box)

# %% [markdown]
# **Shooting** turns it round. The patch that has the most power not yet sent, $A_i\, \Delta B_i$, sends it to all others
# at once:
#
# $$ B_j \mathrel{+}= \rho_j F_{ji}\, \Delta B_i , \qquad \Delta B_j \mathrel{+}= \rho_j F_{ji}\, \Delta B_i , \qquad \Delta B_i = 0 $$
#
# $B^{(k)}$ is the radiosity after $k$ steps (W/m²), $E$ the emitted part, $\rho$ the reflectance, $F$ the form factors,
# $\Delta B$ the part of the radiosity that has not been sent yet.

# %%
glsim.source("radiosity/solvers.py", "def jacobi", lines=9)

# %% Shooting after 1, 3, 10, 40 and 160 shots: each shot is one row of form factors
tiles("", [pictures("shooting", (1, 3, 10, 40, 160))], 320)

# %% [markdown]
# A single shot already lights the room: the lamp's two halves come first, then the brightest patches of the floor. One
# shot needs one row of form factors where a sweep needs all of them, so the first useful picture is there long before
# the first sweep ends. That made shooting, or progressive refinement, the method of choice when computers were slow.

# %% How fast the three come to the solution; a sweep of gathering reads as many form factors as one shot of every patch
n = len(box.patches)


def balance(solver, sweeps, cost):
    steps = [
        step
        for step, _ in zip(
            box.iterations(solver), range(round(sweeps / cost) + 1), strict=False
        )
    ]
    return [step.iteration * cost for step in steps], [
        1 - step.balance for step in steps
    ]


plots.curves(
    {
        "Jacobi": balance("jacobi", 8, 1),
        "Gauss-Seidel": balance("gauss-seidel", 8, 1),
        "shooting": balance("shooting", 8, (n // 20) / n),
    },
    "work, in sweeps over all form factors",
    "share of the light still on its way",
    log=True,
)

# %% [markdown]
# ## Try this
#
# 1. `(0, 1, 2, 3, 8)` to `(0, 1, 2, 3, 4)` for `"gauss-seidel"`: at which step does the ceiling get light?
# 2. Solve `"cornell-closed"`, whose front wall is white instead of black. Which method suffers most?
# 3. Print `[step.residual for step, _ in zip(box.iterations("jacobi"), range(6))]` and divide neighbours: what does the
#    factor mean?
#
# ## Questions
#
# Why does Jacobi's iteration converge at all?
#
# <details><summary>Answer</summary>
#
# In each step what is still missing is multiplied by $R F$. Rows of $F$ sum to at most 1, and $\rho < 1$: at most the
# share $\rho$ survives a bounce. After $k$ steps at most $\rho^k$ of the light is missing. A room with $\rho = 0.99$ is
# a hall of mirrors, and slow.
#
# </details>
#
# ## Exercise
#
# Exercise 28 (lesson 32): Jacobi's iteration. Exercise 29 (lesson 32): Gauss-Seidel's. Exercise 30 (lesson 32): shooting.
