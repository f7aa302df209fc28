# %% [markdown]
# # 34. Soft shadows and the mesh
#
# A lamp with an area makes soft shadows: from some places one sees all of it, from some a part, from some none. The
# radiosity of a wall knows that exactly, at its patches. What we see is what the mesh of patches makes of it.

# %% [markdown]
# ## Predict
#
# A square lamp hangs above a square table. The lamp is enlarged, its total power stays the same. What happens to the
# shadow of the table on the floor?
#
# - it gets larger, with the lamp
# - the black core shrinks, the soft border grows
# - only its edge gets brighter

# %% Shadow of a table under a lamp of side 0.1, 0.8 and 2.4: the same power from a larger area
import numpy as np

import glsim
from glsim import radiosity
from glsim.pictures import tiles
from glsim.radiosity import Builder, Material, View


def square(middle, side, up):
    """A horizontal square with its front up or down."""
    x, y, z = middle
    h = side / 2
    corners = [
        (x - h, y, z + h),
        (x + h, y, z + h),
        (x + h, y, z - h),
        (x - h, y, z - h),
    ]
    return corners if up else corners[::-1]


def table_under(side, **options):
    """Solve a floor, a table of side 0.8 and a lamp of this side and of the power 1."""
    room = Builder("table")
    room.add([square((0, 0, 0), 4, up=True)], Material("floor", (0.75, 0.75, 0.7)))
    table = [square((0, 0.8, 0), 0.8, up=True), square((0, 0.8, 0), 0.8, up=False)]
    room.add(table, Material("table", (0.3, 0.15, 0.05)))
    power = 1 / side**2
    room.add(
        [square((0, 2, 0), side, up=False)],
        Material("lamp", (0, 0, 0), (power, power, power)),
    )
    return radiosity.solve(
        room.scene(View((0, 3.2, 4.6), (0, 0.1, 0), fov=40)), **options
    )


def picture(result, white=0.11):
    return np.asarray(
        result.picture(
            300, colors=np.clip(result.vertex_radiosity / white, 0, 1) ** (1 / 2.2)
        )
    )


row = [
    (f"lamp of side {side}", picture(table_under(side, patches=600)))
    for side in (0.1, 0.8, 2.4)
]
tiles("", [row], 300)

# %% [markdown]
# ## What you should see
#
# Under the small lamp the shadow is nearly sharp. With the larger one its **core** (umbra), where the lamp is hidden
# altogether, shrinks, and the **border** (penumbra), where a part of it is seen, grows. Under the largest lamp there is no
# core left on the floor: from every point of it one sees a part of the lamp beside the table.

# %% [markdown]
# ## The formula
#
# The light at a point of the floor is the integral over the part of the lamp that the point sees:
#
# $$ B = \rho \int_{A} E\, V\, \frac{\cos\theta \cos\theta'}{\pi r^2}\; dA $$
#
# $\rho$: reflectance of the floor; $E$: exitance of the lamp (W/m²); $A$: its area; $V$: 1 where the point of the lamp is
# seen, else 0; $\theta$, $\theta'$: angles to the two normals; $r$: the distance. $V$ is what softens the border.

# %%
glsim.source("radiosity/gather.py", "def radiosity_at", lines=12)

# %% The mesh size: the same shadow with 60, 250 and 1500 patches
row = [(f"{n} patches", picture(table_under(0.6, patches=n))) for n in (60, 250, 1500)]
tiles("", [row], 300)

# %% [markdown]
# With few patches the shadow is a blur with the wrong shape: no vertex lies where it begins. More patches everywhere
# cure that and cost their square. An **adaptive** mesh puts them where the light changes fast, along the shadow's
# border, and leaves the rest coarse.

# %% The same number of patches, spread evenly and put where the light changes fast
even = table_under(0.6, patches=600)
adaptive = table_under(0.6, patches=600, adaptive=True)
named = [("even", even), ("adaptive", adaptive)]
row = [(f"{name}, {len(one.patches)} patches", picture(one)) for name, one in named]
tiles("", [row], 400)

# %% [markdown]
# ## Try this
#
# 1. Lift the table: `0.8` to `1.4` in both places of `table_under` where it is a height. What happens to the core?
# 2. Add `vertices="averaged"` to `table_under(0.6, ...)`: vertices take the mean of their patches instead of gathering.
# 3. `patches=600` to `patches=150` in the last cell: which mesh suffers less?
#
# ## Questions
#
# How large may a square lamp 2 above the floor be so that a table of side 0.8 at the height 0.8 still has a core?
#
# <details><summary>Answer</summary>
#
# The middle of the floor must not see the lamp's edge past the table. Seen from there the table's edge is at
# $0.4 / 0.8 = 0.5$, the lamp's at $s / 2 / 2 = s / 4$. The core is there while $s / 4 < 0.5$: up to the side 2. (With
# the side 1.6 the core is a square of side $0.8 - \frac{0.8}{1.2}(1.6 - 0.8) \approx 0.27$, with the side 2 a point.)
#
# </details>
#
# ## Exercise
#
# Exercise 31 (lesson 35): vertex colours from patches.
