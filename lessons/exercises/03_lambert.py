"""Lambert's law says how much of a distant light a dull surface reflects:

$$ I = I_L\\, k_d \\max(\\mathbf{N} \\cdot \\mathbf{L}, 0) $$

Write `lambert(N, L)`, the factor $\\max(\\mathbf{N} \\cdot \\mathbf{L}, 0)$, and `diffuse(I_L, k_d, N, L)`, the reflected
intensity of each channel.  `N` and `L` are arrays of three numbers: the unit normal, and the unit vector towards the
light.  `I_L` and `k_d` are arrays of three numbers, red, green and blue.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, unit_vectors
from glsim.shading import terms

STARTER = '''\
import numpy as np


def lambert(N, L):
    """Returns max(N.L, 0), a number.  N: unit normal.  L: unit vector towards the light."""
    return 1.0


def diffuse(I_L, k_d, N, L):
    """Returns I_L k_d max(N.L, 0) for red, green and blue, three numbers."""
    return I_L
'''


def angle(N, L):
    return float(np.arccos(np.clip(N @ L, -1, 1)))


def lambert(N, L):
    return float(terms.lambert(N, L)[..., 0])


UP = np.array([0.0, 0.0, 1.0])
SIMPLE = [
    (UP, UP),
    (UP, np.array([0.6, 0.0, 0.8])),
    (UP, np.array([0.0, 1.0, 0.0])),
    (UP, -UP),
]
RANDOM = list(zip(unit_vectors(20, 1), unit_vectors(20, 2), strict=True))
COLORS = [(*np.random.default_rng(3).uniform(0, 1, (2, 3)), N, L) for N, L in RANDOM]

EXERCISE = Definition(
    title="Lambert's law",
    lesson=7,
    starter=STARTER,
    parts=[
        Call(
            "surfaces that face the light",
            "lambert",
            [(N, L) for N, L in SIMPLE[:3] + RANDOM if N @ L >= 0],
            lambert,
            hint="The factor is the cosine of the angle between N and L, and of unit vectors that is N·L.",
            mistakes=[
                Mistake(angle, "This is the angle between N and L; its cosine is asked for, and that is N·L itself."),
                Mistake(lambda N, L: np.sqrt(1 - (N @ L) ** 2), "This is the sine of the angle between N and L."),
                Mistake(lambda N, L: (N @ L) ** 2, "This is the square of the cosine."),
                Mistake(lambda N, L: 1.0, "Every surface is equally bright here: let the light's direction count."),
                Mistake(lambda N, L: np.cos(np.radians(angle(N, L))),
                        "The angle is in radians already: numpy's cos wants radians."),
            ],
            points=2,
        ),
        Call(
            "surfaces that face away",
            "lambert",
            [(N, L) for N, L in SIMPLE + RANDOM if N @ L < 0],
            lambert,
            hint="A surface that faces away from the light gets none.",
            mistakes=[
                Mistake(lambda N, L: N @ L, "N·L is negative where the surface faces away: no light is less than none."),
                Mistake(lambda N, L: abs(N @ L), "The light comes from behind: it must not shine through the surface."),
            ],
            points=1,
        ),
        Call(
            "the colour",
            "diffuse",
            COLORS,
            lambda I_L, k_d, N, L: I_L * k_d * lambert(N, L),
            hint="Each channel is I_L k_d max(N·L, 0), with the channel's own I_L and k_d.",
            mistakes=[
                Mistake(lambda I_L, k_d, N, L: k_d * lambert(N, L), "The light's intensity I_L is missing."),
                Mistake(lambda I_L, k_d, N, L: I_L * lambert(N, L), "The reflectance k_d is missing."),
                Mistake(lambda I_L, k_d, N, L: I_L * k_d, "N·L is missing: every surface is equally bright."),
                Mistake(lambda I_L, k_d, N, L: I_L * k_d * (N @ L), "Where N·L < 0 the result must be 0."),
                Mistake(lambda I_L, k_d, N, L: (I_L + k_d) * lambert(N, L),
                        "A surface reflects a share of the light: multiply I_L by k_d, do not add."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
