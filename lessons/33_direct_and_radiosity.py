# %% [markdown]
# # 33. Direct illumination and radiosity
#
# OpenGL's lamps light what they see and leave the rest to an ambient glow that we made up. How much of the light in a
# real room is that? Here the same box is lit three times: by OpenGL, by the lamp's direct light with true soft
# shadows, and by radiosity.

# %% [markdown]
# ## Predict
#
# The ceiling of the Cornell box does not see the lamp, which hangs flush with it and shines down. How bright is the
# ceiling, compared with the floor?
#
# - black: no light reaches it
# - the same everywhere, like an ambient term
# - about two thirds as bright as the floor, brighter and tinted near the coloured walls

# %% The Cornell box: OpenGL's lights, direct illumination, radiosity. Press 1, 2, 3 to swap them in place
import numpy as np

import glsim
from glsim import radiosity

glsim.compare(
    "cornell",
    modes=["gouraud", "direct", "radiosity"],
    size=420,
    patches=400,
    reference="direct",
)

# %% [markdown]
# ## What you should see
#
# In direct light the ceiling is black, and so are the shadows. With radiosity it is lit from below: by the floor and
# the walls, reddish on the side of the red wall, greenish on the other. The shadows are filled and take the colour of
# what is near them. This is called **colour bleeding**, and no ambient constant can imitate it. OpenGL's own picture
# has no shadows at all.

# %% The numbers behind the eye: mean radiosity of the ceiling and the floor
box = radiosity.solve("cornell", patches=400)
direct = next(step for step in box.iterations("jacobi") if step.iteration == 1).B
middle, area, lamp = box.patches.center, box.patches.area, box.patches.E.any(axis=1)
for name, which in (
    ("ceiling", (middle[:, 1] > 548) & ~lamp),
    ("floor", middle[:, 1] < 1),
):
    both = [np.average(B[which], axis=0, weights=area[which]) for B in (direct, box.B)]
    print(f"{name:8} direct {both[0].round(3)}   radiosity {both[1].round(3)}")

# %% [markdown]
# ## The formula
#
# Radiosity is a sum over bounces, $B = E + RFE + (RF)^2 E + \ldots$ Direct illumination stops after the second term:
#
# $$ B_\mathrm{direct} = E + R F E, \qquad B = \sum_{k=0}^{\infty} (R F)^k E $$
#
# $E$ is the emitted radiosity (W/m²), $R$ the reflectances on a diagonal, $F$ the form factors. An ambient term
# $k_a I_a$ is a guess at everything from $(RF)^2 E$ on: the same number for all places and directions.

# %%
glsim.source("radiosity/result.py", "return self.at_vertices(self.patches.E)")

# %% How much of the light on each place came from the lamp directly: white all of it, black none
share = box.direct().sum(axis=1) / np.maximum(box.vertex_radiosity.sum(axis=1), 1e-9)
box.picture(480, colors=np.repeat(np.clip(share, 0, 1)[:, None], 3, axis=1))

# %% Direct light, direct light with an ambient glow, and radiosity, bounce by bounce: turn the box, change the exposure
glsim.show(box)

# %% [markdown]
# Under the lamp most of the light is direct. On the ceiling and in the shadows none is: there the picture is made of
# bounces alone.
#
# ## Try this
#
# 1. In the first code cell use `"cornell-closed"`, whose front wall is white instead of black: what gets brighter?
# 2. `reference="direct"` to `reference="radiosity"`: where is the difference greatest?
# 3. Compare `"museum"` in the same way. Which of the three pictures would you show a client?
#
# ## Questions
#
# Does an ambient term of the right size make OpenGL's picture right?
#
# <details><summary>Answer</summary>
#
# It can make the mean right, but the indirect light is neither white nor even: it is red beside the red wall, weak in
# corners and under tables, strong above a bright floor. And direct light needs shadows first.
#
# </details>
#
# ## Exercise
#
# Exercise 32 (lesson 33): read the numbers of direct light and radiosity.
