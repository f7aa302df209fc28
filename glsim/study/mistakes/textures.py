"""Mistakes with textures."""

from __future__ import annotations

from glsim.machine import constants as gl
from glsim.machine.frame import Frame
from glsim.machine.state import TextureUnit
from glsim.machine.texture import Texture
from glsim.study.mistakes.rules import Findings, Rule, Seen, rule


def enabled(unit: TextureUnit) -> Texture | None:
    """The enabled texture of most dimensions of a unit, complete or not."""
    return next((t for t, on in zip(reversed(unit.bound), reversed(unit.enabled), strict=True) if on), None)


@rule
class IncompleteTexture(Rule):
    """Silent for texture 0 without an image, which is a way to switch textures off."""

    kind, topic = "incomplete-texture", "texture"
    looks_at = "a texture without its mipmaps or image"
    sentence = "this is drawn as if it had no texture, because the texture is not complete: {cause}"

    def on_draw(self, seen: Seen) -> Findings:
        for number, unit in enumerate(seen.state.texture.units):
            texture = enabled(unit)
            if texture is None or texture.complete or not len(seen.chosen):
                continue
            base, sampler = texture.base, texture.sampler
            named = any(name for name, on in zip(unit.names, unit.enabled, strict=True) if on)
            if base is not None and texture.mipmapped:
                minify = repr(gl.GL_NEAREST_MIPMAP_LINEAR) if sampler.min_filter == gl.GL_NEAREST_MIPMAP_LINEAR else ""
                initial = f" (at the start it is {minify})" if minify else ""
                cause = (
                    f"its GL_TEXTURE_MIN_FILTER wants mipmaps{initial}, and they are missing or of wrong size;"
                    " glTexParameteri(..., GL_TEXTURE_MIN_FILTER, GL_LINEAR), or gluBuild2DMipmaps"
                )
            elif base is not None:
                cause = "its images do not fit each other"
            elif named:
                cause = "it has no image; call glTexImage after glBindTexture"
            else:
                continue
            which = max(k for k in range(4) if unit.enabled[k])
            yield seen.at(seen.setter("texture", "units", number, "bound", which)), {"cause": cause}


@rule
class ReplacedLight(Rule):
    """GL_REPLACE, or GL_DECAL with a texture without alpha, on something with normals.  Silent if nothing has normals,
    for what is around the eye (a sky), or drawn without depth test or depth mask where others have it (a background),
    with GL_COMBINE, and with GL_SEPARATE_SPECULAR_COLOR."""

    kind, topic = "texture-replaces-light", "texture"
    looks_at = "GL_REPLACE that hides lighting"
    sentence = (
        "GL_LIGHTING is on, but the texture replaces the lit colour ({mode}), so the light has no effect:"
        " glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE)"
    )

    def __init__(self, frame: Frame) -> None:
        super().__init__(frame)
        self.hidden: list[tuple[Seen, int, str]] = []  # a Draw, the call that set its mode, and the mode
        self.depth = False  # whether any draw uses the depth buffer

    def on_draw(self, seen: Seen) -> Findings:
        state = seen.state
        self.depth |= uses_depth(seen)
        separate = state.lighting.color_control == gl.GL_SEPARATE_SPECULAR_COLOR
        shining = seen.lit and any(state.lighting.light_enabled) and seen.normals_given
        if not shining or not seen.areas or separate or seen.bent:
            return
        units = [(k, unit, unit.active) for k, unit in enumerate(state.texture.units) if unit.active is not None]
        if any(unit.environment == gl.GL_COMBINE for _, unit, _ in units):
            return
        for number, unit, texture in units:
            if replaces(unit, texture) and not seen.surface.eye_inside:
                mode = "GL_REPLACE" if unit.environment == gl.GL_REPLACE else "GL_DECAL"
                self.hidden.append((seen, seen.at(seen.setter("texture", "units", number, "environment")), mode))
        yield from ()

    def at_end(self, draws: list[Seen]) -> Findings:
        for seen, number, mode in self.hidden:
            if uses_depth(seen) or not self.depth:
                yield number, {"mode": mode}


def uses_depth(seen: Seen) -> bool:
    return seen.asked.depth.test and seen.asked.depth.mask


def replaces(unit: TextureUnit, texture: Texture | None) -> bool:
    """Whether the unit leaves nothing of the colour that it gets."""
    base = texture.base.base_format if texture is not None and texture.base is not None else gl.GL_ALPHA
    if unit.environment == gl.GL_REPLACE:
        return base != gl.GL_ALPHA
    return unit.environment == gl.GL_DECAL and base == gl.GL_RGB
