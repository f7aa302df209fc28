# %% [markdown]
# # 28. Ray tracing, the other global method
#
# Radiosity knows where light goes and forgets from where one looks. Ray tracing does the opposite: it starts at the eye,
# asks at each pixel what is seen there, and at what is seen, what is seen *from there*. Mirrors, glass and sharp shadows
# come by themselves.

# %% [markdown]
# ## Predict
#
# Two mirror spheres stand in a room, side by side. How often may a ray be reflected until the picture no longer changes
# visibly?
#
# - once: a mirror shows what is in front of it
# - about three times
# - hundreds of times: mirrors in mirrors have no end

# %% Two mirror spheres in a box, with 0, 1, 2 and 5 reflections
import numpy as np

import glsim
from glsim import shading
from glsim.pictures import tiles

SPHERES = [
    ((-0.45, -0.5, 0.2), 0.5),
    ((0.5, -0.6, -0.2), 0.4),
]  # centre, radius: mirrors
LAMP = np.array([0.0, 0.95, 0.1])
COLORS = {0: ((0.75, 0.12, 0.1), (0.1, 0.5, 0.15)), 1: ((0.75,) * 3, (0.8,) * 3),
          2: ((0.75, 0.73, 0.7),) * 2}  # fmt: skip


def hit_spheres(O, D):
    """Distances along the rays O + t D to the nearest sphere, and its number."""
    t, which = np.full(len(O), np.inf), np.full(len(O), -1)
    for k, (center, radius) in enumerate(SPHERES):
        oc = O - np.array(center)
        b = np.sum(oc * D, axis=1)
        root = b * b - (np.sum(oc * oc, axis=1) - radius**2)
        near = -b - np.sqrt(np.where(root > 0, root, np.nan))
        closer = (near > 1e-6) & (near < t)
        t, which = np.where(closer, near, t), np.where(closer, k, which)
    return t, which


def hit_box(O, D):
    """Distances to the walls of the box, with the normals and colours there."""
    with np.errstate(divide="ignore"):
        t = (np.sign(D) - O) / D
    t[~np.isfinite(t)] = np.inf
    axis = t.argmin(axis=1)
    rows = np.arange(len(O))
    upper = (D[rows, axis] > 0).astype(int)
    N = np.zeros_like(D)
    N[rows, axis] = -np.sign(D[rows, axis])
    color = np.array([COLORS[a][u] for a, u in zip(axis, upper)])
    return t[rows, axis], N, color


def radiance(O, D, reflections):
    """The light that comes back along the rays."""
    sphere_t, which = hit_spheres(O, D)
    wall_t, N, color = hit_box(O, D)
    mirror = sphere_t < wall_t
    P = O + np.minimum(sphere_t, wall_t)[:, None] * D
    to_lamp = LAMP - P
    distance = np.linalg.norm(to_lamp, axis=1, keepdims=True)
    L = to_lamp / distance
    shadow = hit_spheres(P + 1e-4 * N, L)[0] < distance[:, 0]
    N_L = np.where(shadow[:, None], 0, shading.lambert(N, L))
    result = color * (0.12 + 0.9 * N_L / (0.5 + distance**2))
    if mirror.any():
        result[mirror] = 0
        if reflections > 0:
            center = np.array([c for c, _ in SPHERES])[which[mirror]]
            N_s = shading.terms.normalize(P[mirror] - center)
            R = shading.reflection(N_s, -D[mirror])
            result[mirror] = 0.9 * radiance(P[mirror], R, reflections - 1)
    return result


def picture(reflections, size=300):
    """What a camera before the open front of the box sees."""
    y, x = np.mgrid[1 : -1 : size * 1j, -1 : 1 : size * 1j]
    O = np.stack([x, y, np.full_like(x, 0.999)], axis=-1)  # in the open front
    D = shading.terms.normalize(np.stack([x, y, np.full_like(x, -2.2)], axis=-1))
    light = radiance(O.reshape(-1, 3), D.reshape(-1, 3), reflections)
    shown = 255 * np.clip(light, 0, 1) ** (1 / 2.2)
    return shown.astype(np.uint8).reshape(size, size, 3)


labels = (0, 1, 2, 5)
tiles("", [[(f"reflections: {n}", picture(n)) for n in labels]], 300)

# %% [markdown]
# ## What you should see
#
# Without reflections the mirrors are black: they have no colour of their own. With one they show the room, and each
# other as a black disc. The second fills the discs in, the third what is seen in those. Each reflection covers fewer
# pixels and keeps 90 % of the light, so the change dies away: between three and five there is little to see.

# %% Where the next reflection still changes the picture: the mean difference in 1/255 from that with 8 reflections
final = picture(8).astype(int)
for n in range(7):
    difference = np.abs(picture(n).astype(int) - final)
    changed = (difference.max(axis=2) > 2).mean()
    print(f"{n} reflections: {changed:6.2%} of the pixels still change")

# %% [markdown]
# ## The formula
#
# A ray is $O + t\,\mathbf{D}$, with a unit vector $\mathbf{D}$ and $t > 0$. It meets a sphere with the centre $C$ and the
# radius $r$ where $|O + t\,\mathbf{D} - C| = r$, a quadratic equation:
#
# $$ t = -b - \sqrt{b^2 - \left( |O - C|^2 - r^2 \right)}, \qquad b = (O - C) \cdot \mathbf{D} $$
#
# No real root: the ray misses. At the point that is hit a second ray asks whether the lamp is seen (the shadow), and at
# a mirror a third one goes on in the direction $\mathbf{R}$ of the law of reflection:

# %%
glsim.source("shading/terms.py", "def reflection", lines=5)

# %% [markdown]
# Radiosity and ray tracing are two halves of one thing. Compare:
#
# | | radiosity | ray tracing |
# |---|---|---|
# | starts | at the lamps | at the eye |
# | surfaces | diffuse | mirrors, glass; diffuse by the lamps' direct light |
# | indirect diffuse light | exact | none (here: a constant 0.12) |
# | shadows | soft | sharp |
# | another camera | nothing to do | everything again |
#
# ## Try this
#
# 1. Turn one sphere into chalk: give it the colour `(0.8, 0.8, 0.8)` and light it like a wall.
# 2. Replace `0.12` by 0. Which part of the room was only lit by that constant?
# 3. Send four rays through each pixel, at a quarter of a pixel from its middle, and take the mean. What gets better?
#
# ## Questions
#
# Why does the shadow ray start a little above the surface, at $P + 10^{-4}\,\mathbf{N}$?
#
# <details><summary>Answer</summary>
#
# $P$ was computed with rounding and may lie just below the surface. The ray would then meet its own surface at once,
# and half of all points would lie in the shadow of themselves, in a pattern called *shadow acne*.
#
# </details>
#
# ## Exercise
#
# Exercise 24 (lesson 28): a ray meets a sphere.
