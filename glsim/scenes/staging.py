"""Lights and the camera of a scene, and how they are written: ``0,2,3:cutoff=20`` and ``25,20,4``."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from glsim.names import did_you_mean

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Camera:
    """Looks at the origin.  azimuth, elevation, angle of view: degrees; distance: radii of the scene."""

    azimuth: float = 25.0
    elevation: float = 20.0
    distance: float = 4.0
    angle: float = 30.0


@dataclass(frozen=True)
class Lamp:
    """A white light.

    position: (x, y, z, w) in eye space, w = 0 for a direction.  brightness: of I_d and I_s.
    cutoff: half the angle of a spot's cone in degrees, 0 to 90, or 180 for a light that is no spot; exponent: how much
    a spot fades towards the edge of its cone, 0 to 128; direction: its axis in eye space, None for one through the
    middle of the scene.  attenuation: (k_0, k_1, k_2), the light at distance d is divided by k_0 + k_1 d + k_2 d^2.
    """

    position: tuple[float, float, float, float]
    brightness: float = 1.0
    cutoff: float = 180.0
    exponent: float = 0.0
    direction: Vector | None = None
    attenuation: Vector = (1.0, 0.0, 0.0)

    def aim(self, middle: Vector) -> Vector:
        """The axis of its cone, if the middle of the scene is there in eye space."""
        x, y, z = (there - here for there, here in zip(middle, self.position, strict=False))
        return self.direction or ((x, y, z) if x or y or z else (0.0, 0.0, -1.0))


def numbers(text: str, least: int, most: int) -> list[float]:
    """Numbers separated by commas.  Raises ValueError if they are not from ``least`` to ``most`` finite ones."""
    try:
        values = [float(word) for word in text.split(",")]
    except ValueError:
        raise ValueError(f"numbers separated by commas are needed, not {text!r}") from None
    if not least <= len(values) <= most or not all(-1e6 < value < 1e6 for value in values):
        count = (
            "a number is" if most == 1 else f"{most} numbers are" if least == most else f"{least} to {most} numbers are"
        )
        raise ValueError(f"{count} needed, not {text!r}")
    return values


def lamp_of(text: str) -> Lamp:
    """A light as it is written: X,Y,Z[,W[,BRIGHTNESS]], and then any of :NAME=VALUE.

    A light with a cone or an attenuation is at a place (W = 1) unless W says otherwise.  Raises ValueError with a
    sentence for what cannot be read.
    """
    place, *options = text.split(":")
    x, y, z, *rest = numbers(place, 3, 5)
    result = Lamp((x, y, z, rest[0] if rest else 0.0), rest[1] if len(rest) == 2 else 1.0)
    for option in options:
        name, equals, value = option.partition("=")
        if name not in LAMP_OPTIONS or not equals:
            known = ", ".join(f"{name}=..." for name in LAMP_OPTIONS)
            raise ValueError(f"a light's options are {known}, not {option!r}{did_you_mean(name, LAMP_OPTIONS)}")
        result = LAMP_OPTIONS[name](result, value)
    placed = result.cutoff != 180.0 or result.attenuation != (1.0, 0.0, 0.0)
    return replace(result, position=(x, y, z, 1.0)) if placed and not rest else result


def within(name: str, text: str, least: float, most: float) -> float:
    """One number.  Raises ValueError if it is not from ``least`` to ``most``."""
    value = numbers(text, 1, 1)[0]
    if not least <= value <= most:
        raise ValueError(f"{name} is from {least:g} to {most:g}, not {value:g}")
    return value


def cutoff(text: str) -> float:
    return 180.0 if text == "180" else within("a spot's cutoff", text, 0.0, 90.0)


def attenuation(text: str) -> Vector:
    """ "0.2" is the quadratic term k_2 beside k_0 = 1; or all three."""
    values = numbers(text, 1, 3)
    k_0, k_1, k_2 = values if len(values) == 3 else (1.0, 0.0, values[0])
    if len(values) == 2 or min(k_0, k_1, k_2) < 0.0 or k_0 + k_1 + k_2 == 0.0:
        raise ValueError(f"attenuation is k_2, or k_0,k_1,k_2, none negative and not all 0; not {text!r}")
    return k_0, k_1, k_2


def _direction(text: str) -> Vector:
    x, y, z = numbers(text, 3, 3)
    if x == y == z == 0.0:
        raise ValueError("a spot's direction cannot be 0,0,0")
    return x, y, z


LAMP_OPTIONS: dict[str, Callable[[Lamp, str], Lamp]] = {
    "cutoff": lambda lamp, text: replace(lamp, cutoff=cutoff(text)),
    "exponent": lambda lamp, text: replace(lamp, exponent=within("a spot's exponent", text, 0.0, 128.0)),
    "direction": lambda lamp, text: replace(lamp, direction=_direction(text)),
    "attenuation": lambda lamp, text: replace(lamp, attenuation=attenuation(text)),
    "brightness": lambda lamp, text: replace(lamp, brightness=within("the brightness", text, 0.0, 1000.0)),
}


def camera_of(text: str) -> Camera:
    """A camera as it is written: AZIMUTH,ELEVATION[,DISTANCE].  Raises ValueError with a sentence."""
    values = numbers(text, 2, 3)
    if len(values) == 3 and values[2] <= 1.0:
        raise ValueError(f"the distance must be more than 1 radius of the scene, not {values[2]:g}")
    return Camera(*values)
