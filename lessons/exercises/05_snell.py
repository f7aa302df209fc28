r"""Light that enters water bends towards the normal. Snell's law says by how much, Fresnel's how much is reflected:

$$ n_1 \sin\theta_1 = n_2 \sin\theta_2 $$

`n_1` and `n_2` are the refractive indices of the medium the light comes from and of the medium it enters. Write

- `refracted_angle(theta_1, n_1, n_2)`: the angle $\theta_2$ in **degrees** for an angle of incidence in degrees, or -1
  if nothing is refracted (total internal reflection).
- `critical_angle(n_1, n_2)`: the angle of incidence in degrees from which on everything is reflected; $n_1 > n_2$.
- `schlick(cosine, n_1, n_2)`: the reflected share by Schlick's formula $F = F_0 + (1 - F_0)(1 - \cos\theta)^5$ with
  $F_0 = \left(\frac{n_1 - n_2}{n_1 + n_2}\right)^2$.
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake

STARTER = '''\
import numpy as np


def refracted_angle(theta_1, n_1, n_2):
    """Returns the angle of the refracted ray in degrees, or -1 for total internal reflection.  Angles in degrees."""
    return theta_1


def critical_angle(n_1, n_2):
    """Returns the smallest angle of incidence, in degrees, at which nothing is refracted.  n_1 > n_2."""
    return 90.0


def schlick(cosine, n_1, n_2):
    """Returns the reflected share of the light, in [0, 1].  cosine: of the angle of incidence."""
    return 0.0
'''


def refracted_angle(theta_1, n_1, n_2):
    sine = n_1 / n_2 * np.sin(np.radians(theta_1))
    return -1.0 if sine > 1 else float(np.degrees(np.arcsin(sine)))


def critical_angle(n_1, n_2):
    return float(np.degrees(np.arcsin(n_2 / n_1)))


def schlick(cosine, n_1, n_2):
    F_0 = ((n_1 - n_2) / (n_1 + n_2)) ** 2
    return float(F_0 + (1 - F_0) * (1 - cosine) ** 5)


RNG = np.random.default_rng(5)
BENDING = [(30.0, 1.0, 1.5), (0.0, 1.0, 1.33), (60.0, 1.0, 1.33)]
BENDING += [
    (float(t), 1.0, float(n))
    for t, n in zip(RNG.uniform(1, 89, 12), RNG.uniform(1.1, 2.4, 12), strict=True)
]
OUTWARDS = [(20.0, 1.5, 1.0), (60.0, 1.5, 1.0), (50.0, 1.33, 1.0)]
OUTWARDS += [(float(t), 1.5, 1.0) for t in RNG.uniform(1, 89, 12)]

EXERCISE = Definition(
    title="Snell's law and Fresnel's",
    lesson=5,
    starter=STARTER,
    parts=[
        Call(
            "light that enters a denser medium",
            "refracted_angle",
            BENDING,
            refracted_angle,
            hint="Solve n_1 sin(theta_1) = n_2 sin(theta_2) for theta_2.",
            mistakes=[
                Mistake(lambda t, a, b: np.degrees(np.arcsin(np.clip(b / a * np.sin(np.radians(t)), -1, 1))),
                        "The indices are exchanged: light bends towards the normal in a denser medium."),
                Mistake(lambda t, a, b: a / b * t, "Angles are not proportional; their sines are."),
                Mistake(lambda t, a, b: np.radians(refracted_angle(t, a, b)), "The angle is asked for in degrees."),
                Mistake(lambda t, a, b: a / b * np.sin(np.radians(t)), "This is the sine of the angle."),
                Mistake(lambda t, a, b: np.degrees(np.arcsin(np.clip(a / b * np.sin(t), -1, 1))),
                        "numpy's sin takes radians, and theta_1 is in degrees."),
                Mistake(lambda t, a, b: t, "The ray does not bend yet."),
                Mistake(lambda t, a, b: np.degrees(np.arccos(a / b * np.cos(np.radians(t)))),
                        "Snell's law has sines, not cosines: the angles are those to the normal."),
            ],
            points=2,
        ),
        Call(
            "light that leaves it, with total reflection",
            "refracted_angle",
            OUTWARDS,
            refracted_angle,
            hint="Where n_1/n_2 sin(theta_1) > 1 no angle has such a sine: all the light is reflected, return -1.",
            mistakes=[
                Mistake(lambda t, a, b: np.degrees(np.arcsin(min(a / b * np.sin(np.radians(t)), 1.0))),
                        "Beyond the critical angle no light leaves: return -1, not 90 degrees."),
            ],
        ),
        Call(
            "the critical angle",
            "critical_angle",
            [(1.5, 1.0), (1.33, 1.0), (2.4, 1.0), (2.4, 1.33)],
            critical_angle,
            hint="At the critical angle the refracted ray grazes the surface: theta_2 = 90 degrees.",
            mistakes=[
                Mistake(lambda a, b: np.arcsin(b / a), "The angle is asked for in degrees."),
                Mistake(lambda a, b: np.degrees(np.arccos(b / a)), "This is measured from the surface; angles are to the normal."),
                Mistake(lambda a, b: np.degrees(np.arctan(b / a)), "This is Brewster's angle; it has a tangent."),
            ],
        ),
        Call(
            "the reflected share",
            "schlick",
            [(1.0, 1.0, 1.5), (0.5, 1.0, 1.5), (0.0, 1.0, 1.5), (0.3, 1.0, 1.33), (0.05, 1.0, 2.4)],
            schlick,
            hint="F_0 is the share at normal incidence, 0.04 for glass; at grazing incidence all is reflected.",
            mistakes=[
                Mistake(lambda c, a, b: ((a - b) / (a + b)) ** 2, "The share must grow towards grazing incidence, to 1."),
                Mistake(lambda c, a, b: (1 - c) ** 5, "F_0 is missing: at normal incidence glass still reflects 4 %."),
                Mistake(lambda c, a, b: abs((a - b) / (a + b)) + (1 - abs((a - b) / (a + b))) * (1 - c) ** 5,
                        "F_0 is the square of the quotient."),
                Mistake(lambda c, a, b: schlick(1 - c, a, b), "The share grows as the cosine falls: (1 - cosine) to the power of 5."),
            ],
        ),
    ],
)  # fmt: skip
