# %% [markdown]
# # 27. BRDFs: what a surface does with light
#
# Phong's lobe was found by looking at pictures. Physics asks for more: a function that says, for every direction the
# light comes from and every direction it leaves in, how much of it goes there. And this function has to obey two laws.

# %% [markdown]
# ## Predict
#
# A surface with Phong's highlight, $k_s = 1$, $n = 5$, and no diffuse part is lit at a more and more grazing angle.
# Which share of the light that arrives does it reflect?
#
# - the same at all angles: $k_s$ is a constant
# - less: the surface turns away from the light
# - more and more, in the end more than arrives

# %% Share of the arriving light that leaves again (albedo) against the angle of incidence
import numpy as np

import glsim
from glsim import plots, shading

degrees = np.arange(0, 87, 3)
models = {
    "lecture's Phong": shading.Phong(k_s=1.0, n=5),
    "normalised Phong": shading.NormalizedPhong(k_s=1.0, n=5),
    "Cook-Torrance": shading.CookTorrance(F_0=0.9, m=0.3),
    "Lambert": shading.Lambertian(k_d=0.8),
}
albedo = {
    name: (degrees, [float(f.albedo(np.cos(np.radians(t)))[0]) for t in degrees])
    for name, f in models.items()
}
plots.curves(albedo, "angle of incidence (degrees)", "albedo", marks={})

# %% [markdown]
# ## What you should see
#
# The lecture's highlight does not know $\mathbf{N} \cdot \mathbf{L}$: as the light becomes grazing, less of it arrives, but
# hardly less leaves. Beyond about 70° more leaves than arrives: 1.4 times as much at 80°, 18 times at 89.5°. Lambert's stays flat at $k_d$. The normalised lobe never exceeds 1, and
# the microfacets of Cook and Torrance stay below it too: that is what "physics-based" means.

# %% [markdown]
# ## The formula
#
# The **bidirectional reflectance distribution function** is the ratio of the light that leaves towards $\mathbf{V}$ and
# the light that arrives from $\mathbf{L}$, per unit of solid angle (1/sr):
#
# $$ I(\mathbf{V}) = \sum_\mathrm{lights} f(\mathbf{L}, \mathbf{V})\, I_L\, (\mathbf{N} \cdot \mathbf{L}) $$
#
# The slides write it $\rho(\theta_i, \varphi_i, \theta_r, \varphi_r, \lambda)$: the directions in polar angles, and the
# wavelength $\lambda$, for which we take red, green and blue. Two laws:
#
# $$ f(\mathbf{L}, \mathbf{V}) = f(\mathbf{V}, \mathbf{L}), \qquad \int_\Omega f(\mathbf{L}, \mathbf{V})\, (\mathbf{N} \cdot
# \mathbf{V})\; d\omega_V \le 1 $$

# %% [markdown]
# The first is **reciprocity**: light that goes one way goes back the same way. The second is **energy**: no more leaves
# than arrives.

# %%
glsim.source(
    "shading/brdf.py",
    "return np.asarray(np.asarray(self.k_s) * power(dot(reflection(N, L), V), self.n)",
)

# %% Both laws in numbers: the largest breach of reciprocity, and the albedo at 0 and 80 degrees
for name, f in models.items():
    steep, grazing = (float(f.albedo(np.cos(np.radians(t)))[0]) for t in (0, 80))
    print(f"{name:18} breach {f.reciprocity_error():6.1%}   {steep:.2f}  {grazing:.2f}")

# %% The functions as lobes in the plane of incidence, for light from 45 degrees (times N.L)
plots.lobes(
    {
        "Lambert": shading.Lambertian(k_d=0.8),
        "normalised Phong, n = 20": shading.NormalizedPhong(k_s=0.25, n=20),
        "Cook-Torrance, m = 0.2": shading.CookTorrance(F_0=0.25, m=0.2),
    },
    45,
    cosine=True,
)

# %% [markdown]
# Lambert's lobe is a half disc: the same in all directions. Phong's points in the mirror direction. The lobe of
# microfacets leans further: there are always facets that mirror the light to a lower angle, where the same facets fill
# more of the view and the Fresnel reflectance grows. Watch it at several angles:

# %% Cook-Torrance for light from 20, 45 and 60 degrees: the lobe grows, and leans beyond the mirror direction
plots.lobes(
    {"light": shading.CookTorrance(F_0=0.25, m=0.2)},
    (20, 45, 60),
    cosine=True,
)

# %% Three spheres, one light from the upper left: Lambert, normalised Phong over it, Cook-Torrance over it
from PIL import Image

y, x = np.mgrid[1.15:-1.15:480j, -1.15:1.15:480j]
inside = x**2 + y**2 < 1
N = np.stack([x, y, np.sqrt(np.where(inside, 1 - x**2 - y**2, 0))], axis=-1)
L = np.array([-0.5, 0.6, 0.62])
L = L / np.linalg.norm(L)
V = np.array([0.0, 0.0, 1.0])
N_L = np.clip(N @ L, 0, None)[..., None]
base = shading.Lambertian(k_d=np.array([0.5, 0.28, 0.12]))
over = [
    None,
    shading.NormalizedPhong(k_s=0.12, n=30),
    shading.CookTorrance(F_0=0.12, m=0.22),
]
row = []
for f in over:
    value = base.evaluate(N, L, V) + (f.evaluate(N, L, V) if f else 0)
    shown = np.clip(3.0 * value * N_L, 0, 1) ** (1 / 2.2)
    row.append(np.where(inside[..., None], shown, 0.12))
Image.fromarray((255 * np.concatenate(row, axis=1)).astype(np.uint8)).reduce(2)

# %% [markdown]
# ## Try this
#
# 1. `m=0.2` to `m=0.1` and `m=0.6` in the lobes: which number of Phong's does the roughness correspond to?
# 2. Give the normalised Phong $k_s = 1$ and add Lambert with $k_d = 0.5$. Which law is broken, and how would you mend it?
# 3. Turn the light of the spheres to the side, `L = [-1, 0.2, 0.1]`: which highlight changes its shape?
#
# ## Questions
#
# Lambert's BRDF is $k_d / \pi$. Where does the $\pi$ come from?
#
# <details><summary>Answer</summary>
#
# From the second law: the integral of the cosine over the hemisphere is $\pi$. With $f = k_d / \pi$ the albedo is $k_d$.
# In OpenGL's equation the $\pi$ is hidden in the unit of the light.
#
# </details>
#
# ## Exercise
#
# Exercise 23 (lesson 27): energy and reciprocity of a BRDF.
