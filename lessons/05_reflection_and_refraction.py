# %% [markdown]
# # 5. Local physics: reflection and refraction
#
# A ray of light meets a lake. A part comes back up, a part goes on below the surface, in another direction. Three laws
# say how much and where: the first has been known for two thousand years, the second for four hundred, the third for two hundred.

# %% [markdown]
# ## Predict
#
# You look out of the water at the sky, at a flatter and flatter angle. What happens?
#
# - the sky gets dimmer, and at a grazing angle it is gone
# - from a certain angle on one sees no sky at all, but the bottom of the lake, mirrored
# - nothing: light goes the same way in both directions

# %% Rays from below the surface of water, at 20, 40 and 60 degrees: the last is reflected altogether
import numpy as np

import glsim
from glsim import plots, shading

plots.refraction("water", "air", (20, 40, 60))

# %% [markdown]
# ## What you should see
#
# The ray at 20° leaves at 27°, the one at 40° at 59°. At 60° no ray leaves at all: **total internal reflection**. The
# limit is where the refracted ray would graze the surface, at 48.6° for water. Beyond it the surface is a perfect
# mirror.

# %% [markdown]
# ## The formula
#
# **Law of reflection**: the mirrored ray makes the same angle to the normal as the arriving one, in the same plane:
#
# $$ \theta_r = \theta_i $$
#
# **Snell's law of refraction**, with the refractive indices $n_1$ and $n_2$ of the two media (air 1, water 1.33, glass 1.5;
# light is slower by this factor), and the angles to the normal:
#
# $$ n_1 \sin\theta_1 = n_2 \sin\theta_2 $$

# %%
glsim.source("shading/terms.py", "def refraction", lines=13)

# %% Into glass: rays bend towards the normal. Their width is the share of the light that takes this way
plots.refraction("air", "glass", (20, 45, 70))

# %% The angle of refraction against the angle of incidence
plots.snell()

# %% [markdown]
# How much is reflected and how much goes through, **Fresnel's** equations say. For us one thing matters: at grazing
# incidence everything becomes a mirror, water, paper, a varnished table.

# %% Reflected share of the light against the angle of incidence: insulators, and metals which start high
plots.fresnel()

# %% The reflected share of glass in numbers: Fresnel's equations and Schlick's short formula
for degrees in (0, 30, 60, 75, 85, 89):
    cosine = np.cos(np.radians(degrees))
    exact = shading.fresnel(cosine, 1.0, 1.5).item()
    short = shading.fresnel_schlick(cosine, 0.04).item()
    print(f"{degrees:3} degrees: {exact:.3f}   Schlick {short:.3f}")

# %% [markdown]
# Neither law is in OpenGL's lighting equation. Its $k_s$ is a constant that does not know the angle, and transparent
# things do not bend the light behind them. But the law of reflection is there, in the vector $\mathbf{R}$ of lesson 9.
#
# > **The slide says** only the names. Mind that both laws are about directions of *unit length* and about angles to the
# > **normal**, not to the surface.
#
# ## Try this
#
# 1. `plots.refraction("glass", "water", (20, 60))`: which of the two is the denser medium, and is there a critical angle?
# 2. `shading.fresnel(1.0, 1.0, 1.33)`: which share of the light does a calm lake reflect straight up?
# 3. Find the angle at which glass reflects a half of the light.
#
# ## Questions
#
# A diamond has the index 2.42. At which angle does total reflection begin inside it, and what has that to do with its
# sparkle?
#
# <details><summary>Answer</summary>
#
# $\arcsin(1 / 2.42) \approx 24.4°$. Most rays that have entered hit the next facet at a larger angle and are reflected,
# several times, until one finds the way out: upwards, if the stone is well cut.
#
# </details>
#
# ## Exercise
#
# Exercise 5: Snell's law and Fresnel's.
