r"""Radiosity is a sum over bounces; direct illumination stops after the first one:

$$ B = \sum_{k=0}^{\infty} (R F)^k E, \qquad B_\mathrm{direct} = E + R F E $$

Two long parallel walls face each other, so close that all light that leaves one arrives at the other: $F_{12} = F_{21} = 1$. Wall 1 glows with $E = 1$, wall 2 does not; both have $\rho = 0.5$. Give as
numbers `DIRECT`, the radiosities of both walls in direct illumination; `FULL`, those with all bounces; and `SHARE`, the share of wall 2's light that direct illumination shows.

Write `direct(F, rho, E)`, $B_\mathrm{direct}$, (n, 3), and `indirect(F, rho, E)`, all that direct illumination leaves out, $B - B_\mathrm{direct}$. `F` is (n, n), `rho` and `E` are (n, 3).
Write `glow(F, A, rho, E)`: three numbers, the ambient glow $I_a$ that replaces the interreflection best, so that $\sum_i A_i \rho_i I_a$ is all the power of the indirect light, in each channel. `A` are the areas, (n,).
"""

import numpy as np

from glsim.course.exercise import Call, Definition, Mistake, Value, closed_room

STARTER = '''\
import numpy as np

DIRECT = (0, 0)
FULL = (0, 0)
SHARE = 0


def direct(F, rho, E):
    """Returns the radiosities (n, 3) of direct illumination.  F: (n, n); rho, E: (n, 3)."""
    return E


def indirect(F, rho, E):
    """Returns what all further bounces add: (n, 3)."""
    return 0 * E


def glow(F, A, rho, E):
    """Returns the ambient glow (3,) with the power of the indirect light.  A: areas (n,)."""
    return np.zeros(3)
'''


def bounces(F, rho, E, count):
    """(RF)^k E for k = 0, 1, ..."""
    result = [E]
    for _ in range(count):
        result.append(rho * (F @ result[-1]))
    return np.array(result)


def full(F, rho, E):
    solved = [
        np.linalg.solve(np.eye(len(F)) - rho[:, c, None] * F, E[:, c]) for c in range(3)
    ]
    return np.stack(solved, axis=1)


def direct(F, rho, E):
    return E + rho * (F @ E)


def indirect(F, rho, E):
    return full(F, rho, E) - direct(F, rho, E)


def glow(F, A, rho, E):
    return A @ indirect(F, rho, E) / (A @ rho)


ROOMS = [closed_room(n, n) for n in (3, 5, 8, 12)]
PLAIN = [(F, rho, E) for F, _, rho, E in ROOMS]

EXERCISE = Definition(
    title="Direct light and radiosity",
    lesson=33,
    starter=STARTER,
    parts=[
        Value(
            "two walls, in numbers",
            {"DIRECT": (1, 0.5), "FULL": (4 / 3, 2 / 3), "SHARE": 0.75},
            hint="Follow the light: wall 1 sends 1, wall 2 reflects half of it, wall 1 half of that, and so on.",
            wrong={
                "DIRECT": [((1, 1), "Wall 2 reflects only half of what arrives."),
                           ((1, 0), "This is the emitted light alone: direct illumination has one bounce."),
                           ((0, 0.5), "Wall 1 glows: its emitted light belongs to B."),
                           ((1.25, 0.5), "Wall 1 gets light back from wall 2, but that is the second bounce."),
                           ((0.5, 0.5), "The emitted light is not reflected first: wall 1 shows all of E.")],
                "FULL": [((1.25, 0.5), "This stops after two bounces; the light goes on for ever, ever weaker."),
                         ((1.25, 0.625), "This stops after three bounces; the light goes on for ever, ever weaker."),
                         ((1, 0.5), "This is direct illumination."),
                         ((2, 1), "One bounce takes the light to the other wall: coming back to the same one takes two, and a quarter is left."),
                         ((1 / 3, 1 / 6), "This is only what direct illumination leaves out."),
                         ((2 / 3, 4 / 3), "The walls are exchanged: wall 1 is the one that glows.")],
                "SHARE": [(0.25, "This is the share that direct illumination leaves out."),
                          (4 / 3, "The ratio is upside down: a share is at most 1."),
                          (75, "Give the share as a number between 0 and 1, not in percent.")],
            },
            points=2,
        ),
        Call(
            "direct illumination",
            "direct",
            PLAIN,
            direct,
            hint="Emitted light, and the light of the lamps that was reflected once.",
            mistakes=[
                Mistake(lambda F, r, E: r * (F @ E), "The emitted light E is missing: lamps are seen, too."),
                Mistake(lambda F, r, E: E + F @ E, "This is the arriving light; each patch reflects the share rho of it."),
                Mistake(lambda F, r, E: E + F @ (r * E), "The light is reflected by the patch at which it arrives: rho comes after F."),
                Mistake(lambda F, r, E: E + r * (F.T @ E), "F is transposed: patch i gathers with row i."),
                Mistake(lambda F, r, E: r * (E + F @ E), "E is emitted, not reflected."),
                Mistake(lambda F, r, E: bounces(F, r, E, 2).sum(axis=0), "This has two bounces; direct illumination has one."),
                Mistake(full, "These are all bounces; direct illumination has one."),
                Mistake(lambda F, r, E: E, "This is the emitted light alone."),
            ],
        ),
        Call(
            "the interreflection",
            "indirect",
            PLAIN,
            indirect,
            hint="Solve for all bounces, and take away what direct illumination has.",
            mistakes=[
                Mistake(full, "These are all bounces: take away what direct illumination has."),
                Mistake(lambda F, r, E: full(F, r, E) - E, "The first bounce is in it: that is direct light. Take it away as well."),
                Mistake(lambda F, r, E: full(F, r, E) - r * (F @ E), "The emitted light is in it: take it away as well."),
                Mistake(lambda F, r, E: direct(F, r, E) - full(F, r, E), "The sign is wrong: there is more light with all bounces."),
                Mistake(lambda F, r, E: bounces(F, r, E, 2)[2], "This is the second bounce only; there are more."),
                Mistake(lambda F, r, E: bounces(F, r, E, 3)[2:].sum(axis=0), "These are two bounces only; there are more."),
                Mistake(lambda F, r, E: np.stack([np.linalg.solve(np.eye(len(F)) - r[:, 0, None] * F, E[:, c]) for c in range(3)], axis=1) - direct(F, r, E),
                        "Every channel has its own reflectances: here the red ones are used for all."),
            ],
        ),
        Call(
            "the ambient glow",
            "glow",
            ROOMS,
            glow,
            hint="The power of the indirect light is the sum of A times B_indirect; an even glow has the power I_a times the sum of A rho.",
            mistakes=[
                Mistake(lambda F, A, r, E: indirect(F, r, E).mean(axis=0), "This is the plain mean of the indirect radiosities: areas and reflectances have to count."),
                Mistake(lambda F, A, r, E: A @ indirect(F, r, E) / A.sum(), "This is the mean radiosity. The glow is what arrives before it is reflected: rho has to count."),
                Mistake(lambda F, A, r, E: A @ indirect(F, r, E), "This is the power itself."),
                Mistake(lambda F, A, r, E: indirect(F, r, E).sum(axis=0) / r.sum(axis=0), "The areas are missing: large patches count more."),
                Mistake(lambda F, A, r, E: A @ full(F, r, E) / (A @ r), "The direct light is in it: the glow replaces only the indirect light."),
                Mistake(lambda F, A, r, E: (indirect(F, r, E) / r).mean(axis=0), "This is the plain mean of the arriving light: powers have to be equal, so areas and reflectances count."),
                Mistake(lambda F, A, r, E: A @ (indirect(F, r, E) / r) / A.sum(), "This is the mean of the arriving light. The power that is shown is to be the same: weigh with A rho."),
            ],
            points=2,
        ),
    ],
)  # fmt: skip
