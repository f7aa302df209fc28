"""The states of random programs, and the words that they are written with."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random

FORMATS = {
    "GL_RGB": ("GL_RGB", 3), "GL_RGBA": ("GL_RGBA", 4), "GL_LUMINANCE": ("GL_LUMINANCE", 1),
    "GL_ALPHA": ("GL_ALPHA", 1), "GL_LUMINANCE_ALPHA": ("GL_LUMINANCE_ALPHA", 2), "GL_INTENSITY": ("GL_LUMINANCE", 1),
    "GL_RGBA8": ("GL_BGRA", 4), "GL_RGB8": ("GL_BGR", 3),
}  # fmt: skip
BLENDING = [
    "GL_ZERO",
    "GL_ONE",
    "GL_SRC_COLOR",
    "GL_ONE_MINUS_SRC_COLOR",
    "GL_DST_COLOR",
    "GL_ONE_MINUS_DST_COLOR",
    "GL_SRC_ALPHA",
    "GL_ONE_MINUS_SRC_ALPHA",
    "GL_DST_ALPHA",
    "GL_ONE_MINUS_DST_ALPHA",
    "GL_CONSTANT_COLOR",
    "GL_ONE_MINUS_CONSTANT_COLOR",
    "GL_CONSTANT_ALPHA",
    "GL_ONE_MINUS_CONSTANT_ALPHA",
]
TESTS = ["GL_LESS", "GL_LEQUAL", "GL_GREATER", "GL_GEQUAL", "GL_EQUAL", "GL_NOTEQUAL", "GL_ALWAYS"]
STENCILS = ["GL_KEEP", "GL_ZERO", "GL_REPLACE", "GL_INCR", "GL_DECR", "GL_INVERT", "GL_INCR_WRAP", "GL_DECR_WRAP"]
MATERIAL = ["GL_AMBIENT", "GL_DIFFUSE", "GL_AMBIENT_AND_DIFFUSE", "GL_SPECULAR", "GL_EMISSION"]
LOGIC = [
    "GL_CLEAR",
    "GL_AND",
    "GL_AND_REVERSE",
    "GL_COPY",
    "GL_AND_INVERTED",
    "GL_NOOP",
    "GL_XOR",
    "GL_OR",
    "GL_NOR",
    "GL_EQUIV",
    "GL_INVERT",
    "GL_OR_REVERSE",
    "GL_COPY_INVERTED",
    "GL_OR_INVERTED",
    "GL_NAND",
    "GL_SET",
]


class States:
    """A program in the making: statements that set states; author.py has those that draw.

    exact: colours are the same all over each primitive, so that tests of equality and logic operations may follow.
    lit, fogged, summed, outlined, tracked, stenciled, blended: features that are on.
    curved: attributes are not linear.
    """

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)
        self.lines: list[str] = []
        self.exact = self.chance(0.2)
        self.perspective = False
        self.lit = self.fogged = self.summed = self.outlined = self.tracked = self.stenciled = self.blended = (
            self.curved
        ) = False
        self.units: list[str] = []  # targets of the texture units that are on
        self.lists = 0
        self.in_list = False

    # ------------------------------------------------------------ words

    def chance(self, probability: float) -> bool:
        return self.random.random() < probability

    def pick(self, choices: Sequence[str]) -> str:
        return self.random.choice(choices)

    def number(self, low: float, high: float) -> str:
        return f"{self.random.uniform(low, high):.3g}"

    def numbers(self, count: int, low: float = 0.0, high: float = 1.0) -> str:
        return ", ".join(self.number(low, high) for _ in range(count))

    def say(self, *lines: str) -> None:
        self.lines += lines

    def join(self, first: int) -> None:
        """The lines from ``first`` on become one statement: a shorter program has all of them or none."""
        self.lines[first:] = ["\n".join(self.lines[first:])]

    def color(self, low: float = 0.1) -> str:
        """Red, green, blue, alpha."""
        return self.numbers(4, low)

    # ------------------------------------------------------------ the beginning

    def rectangle(self) -> None:
        """Something in the middle of the picture."""
        raise NotImplementedError

    def camera(self) -> None:
        self.say(f"glClearColor({self.numbers(3, 0, 0.4)}, {self.number(0, 1)})" if self.chance(0.3) else "")
        self.say(
            "glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)", "glEnable(GL_DEPTH_TEST)"
        )
        self.perspective = self.chance(0.5)
        lens = "glFrustum(-0.4, 0.4, -0.4, 0.4, 1, 20)" if self.perspective else "glOrtho(-1.3, 1.3, -1.2, 1.2, -3, 3)"
        self.say(f"glMatrixMode(GL_PROJECTION); {lens}; glMatrixMode(GL_MODELVIEW)")
        self.say(*(["glTranslatef(0, 0, -3)"] if self.perspective else []))
        if self.chance(0.2):
            self.say(f"glViewport({self.random.randint(-9, 30)}, {self.random.randint(0, 30)}, 101, 90)")
        self.lines = [line for line in self.lines if line]

    def transform(self) -> None:
        kind = self.random.randrange(4)
        if kind == 0:
            self.say(f"glTranslatef({self.numbers(3, -0.4, 0.4)})")
        elif kind == 1:
            self.say(f"glRotatef({self.number(-90, 90)}, {self.numbers(3, -1, 1)})")
        elif kind == 2:
            self.say(f"glScalef({self.numbers(3, 0.5, 1.3)})")
        else:
            self.say(f"glMultMatrixf([1, {self.number(-0.3, 0.3)}, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1, 0, 0, 1])")

    # ------------------------------------------------------------ states

    def lighting(self) -> None:
        if self.lit:
            return
        self.lit = True
        self.say(f"glEnable(GL_LIGHTING); glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, {self.number(1, 60)})")
        for light in self.random.sample(range(8), self.random.randint(1, 3)):
            self.light(f"GL_LIGHT{light}")
        if self.chance(0.3):
            self.say(f"glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [{self.color(0)}])")
        if self.chance(0.3):
            self.say("glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE)")
        if self.chance(0.3):
            self.say("glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE)")
        if self.chance(0.2) and not self.fogged:
            self.summed = True
            self.say("glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR)")
        if self.chance(0.6):
            self.say(f"glEnable({self.pick(['GL_NORMALIZE', 'GL_RESCALE_NORMAL'])})")
        self.tracked = self.chance(0.25)
        for _ in range(0 if self.tracked else self.random.randint(0, 3)):
            self.material()
        if self.tracked:
            mode = self.pick(MATERIAL)
            self.say(f"glColorMaterial({self.pick(['GL_FRONT', 'GL_FRONT_AND_BACK'])}, {mode})")
            self.say("glEnable(GL_COLOR_MATERIAL)")

    def light(self, light: str) -> None:
        self.say(f"glEnable({light})")
        w = self.pick(["0", "1", "1", "0.5"])
        self.say(f"glLightfv({light}, GL_POSITION, [{self.numbers(2, -2, 2)}, {self.number(0.5, 3)}, {w}])")
        for parameter in ("GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR"):
            if self.chance(0.5):
                self.say(f"glLightfv({light}, {parameter}, [{self.color(0)}])")
        if self.chance(0.3):
            self.say(f"glLightf({light}, GL_SPOT_CUTOFF, {self.number(15, 90)})")
            self.say(f"glLightfv({light}, GL_SPOT_DIRECTION, [{self.numbers(2, -0.5, 0.5)}, -1])")
            self.say(f"glLightf({light}, GL_SPOT_EXPONENT, {self.number(0, 20)})")
        for parameter in ("GL_CONSTANT_ATTENUATION", "GL_LINEAR_ATTENUATION", "GL_QUADRATIC_ATTENUATION"):
            if self.chance(0.2):
                self.say(f"glLightf({light}, {parameter}, {self.number(0.2, 1)})")

    def material(self) -> None:
        face = self.pick(["GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK", "GL_FRONT_AND_BACK"])
        if self.chance(0.3):
            self.say(f"glMaterialf({face}, GL_SHININESS, {self.number(1, 100)})")
        else:
            name = self.pick(MATERIAL)
            self.say(f"glMaterialfv({face}, {name}, [{self.color(0)}])")

    def texture(self) -> None:
        if self.units:
            return
        self.unit(0)
        if self.chance(0.3):
            self.unit(self.random.randint(1, 3))

    def unit(self, number: int) -> None:
        first = len(self.lines)
        if number:
            self.say(f"glActiveTexture(GL_TEXTURE{number})")
        target = self.pick(["GL_TEXTURE_2D"] * 5 + ["GL_TEXTURE_1D", "GL_TEXTURE_3D", "GL_TEXTURE_CUBE_MAP"])
        internal = self.pick(list(FORMATS))
        format, components = FORMATS[internal]
        self.say(f"glBindTexture({target}, {len(self.units) + 1})")
        mipmaps = target != "GL_TEXTURE_3D" and not self.perspective and self.chance(0.3)
        if mipmaps:
            self.say(f"glTexParameteri({target}, GL_GENERATE_MIPMAP, GL_TRUE)")
        width, height = self.random.choice([(8, 8), (16, 4), (4, 4), (4, 16)])
        if target == "GL_TEXTURE_CUBE_MAP":
            for face in range(6):
                data = f"texels(8, 8, {components})[::{-1 if face % 2 else 1}] // {1 + face // 2}"
                where = f"GL_TEXTURE_CUBE_MAP_POSITIVE_X + {face}"
                self.say(f"glTexImage2D({where}, 0, {internal}, 8, 8, 0, {format}, GL_UNSIGNED_BYTE, {data})")
        else:
            size = {"GL_TEXTURE_1D": "8", "GL_TEXTURE_2D": f"{width}, {height}", "GL_TEXTURE_3D": "4, 4, 2"}[target]
            data = {
                "GL_TEXTURE_1D": f"texels(8, 1, {components})",
                "GL_TEXTURE_2D": f"texels({width}, {height}, {components})",
                "GL_TEXTURE_3D": f"texels(4, 8, {components})",
            }[target]  # fmt: skip
            image = f"glTexImage{target[-2:]}({target}, 0, {internal}, {size}, 0, {format}"
            kind, values = self.random.choice(
                [("GL_UNSIGNED_BYTE", data), ("GL_FLOAT", f"({data} / 255).astype('f4')"),
                 ("GL_UNSIGNED_SHORT", f"{data}.astype('u2') * 257")]
            )  # fmt: skip
            self.say(f"{image}, {kind}, {values})")
        self.filters(target, mipmaps)
        self.environment(internal)
        self.say(f"glEnable({target})")
        self.units.append(target)
        if self.chance(0.3):
            self.generators(target, mipmaps)
        if self.chance(0.2):
            self.transform()
            self.lines[-1] = f"glMatrixMode(GL_TEXTURE); {self.lines[-1]}; glMatrixMode(GL_MODELVIEW)"
        if number:
            self.say("glActiveTexture(GL_TEXTURE0)")
        self.join(first)

    def filters(self, target: str, mipmaps: bool) -> None:
        filters = ["GL_LINEAR"]
        if mipmaps:
            filters = ["GL_LINEAR", "GL_LINEAR_MIPMAP_LINEAR"]
        self.say(f"glTexParameteri({target}, GL_TEXTURE_MIN_FILTER, {self.pick(filters)})")
        for axis in "STR":
            if target != "GL_TEXTURE_CUBE_MAP" and self.chance(0.5):
                wraps = ["GL_CLAMP", "GL_REPEAT", "GL_CLAMP_TO_EDGE", "GL_CLAMP_TO_BORDER", "GL_MIRRORED_REPEAT"]
                self.say(f"glTexParameteri({target}, GL_TEXTURE_WRAP_{axis}, {self.pick(wraps)})")
        if self.chance(0.4):
            self.say(f"glTexParameterfv({target}, GL_TEXTURE_BORDER_COLOR, [{self.color(0)}])")

    def environment(self, internal: str) -> None:
        modes = ["GL_MODULATE", "GL_BLEND", "GL_REPLACE", "GL_ADD", "GL_COMBINE"]
        mode = self.pick(modes + (["GL_DECAL"] if internal in ("GL_RGB", "GL_RGBA") else []))
        self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {mode})")
        if self.chance(0.5):
            self.say(f"glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [{self.color(0)}])")
        if mode != "GL_COMBINE":
            return
        functions = ["GL_REPLACE", "GL_MODULATE", "GL_ADD", "GL_ADD_SIGNED", "GL_INTERPOLATE", "GL_SUBTRACT"]
        self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, {self.pick(functions)})")
        self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, {self.pick(functions)})")
        for k in range(3):
            source = self.pick(["GL_TEXTURE", "GL_CONSTANT", "GL_PRIMARY_COLOR", "GL_PREVIOUS"])
            self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE{k}_RGB, {source})")
            operands = ["GL_SRC_COLOR", "GL_ONE_MINUS_SRC_COLOR", "GL_SRC_ALPHA", "GL_ONE_MINUS_SRC_ALPHA"]
            self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND{k}_RGB, {self.pick(operands)})")
            self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND{k}_ALPHA, {self.pick(operands[2:])})")

    def generators(self, target: str, mipmaps: bool) -> None:
        modes = ["GL_OBJECT_LINEAR", "GL_EYE_LINEAR"]
        if target != "GL_TEXTURE_CUBE_MAP" and not mipmaps:
            modes.append("GL_SPHERE_MAP")
        mode = self.pick(modes)
        self.curved |= mode == "GL_SPHERE_MAP"
        for axis in "STR" if target == "GL_TEXTURE_CUBE_MAP" else "ST":
            self.say(f"glTexGeni(GL_{axis}, GL_TEXTURE_GEN_MODE, {mode})")
            if mode in ("GL_OBJECT_LINEAR", "GL_EYE_LINEAR"):
                self.say(f"glTexGenfv(GL_{axis}, {mode.replace('LINEAR', 'PLANE')}, [{self.numbers(4, -1, 1)}])")
            self.say(f"glEnable(GL_TEXTURE_GEN_{axis})")

    def fog(self) -> None:
        if self.summed:
            return
        self.fogged = True
        self.say("glEnable(GL_FOG)", f"glFogfv(GL_FOG_COLOR, [{self.color()}])")
        mode = self.pick(["GL_LINEAR", "GL_EXP", "GL_EXP2"])
        self.say(f"glFogi(GL_FOG_MODE, {mode})", f"glFogf(GL_FOG_DENSITY, {self.number(0.1, 0.6)})")
        self.say(f"glFogf(GL_FOG_START, {self.number(0, 2)})", f"glFogf(GL_FOG_END, {self.number(2.5, 5)})")
        if self.chance(0.2):
            self.say("glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD)")

    def sum(self) -> None:
        if not self.fogged:
            self.summed = True
            self.say("glEnable(GL_COLOR_SUM)", f"glSecondaryColor3f({self.numbers(3, 0, 0.5)})")

    def flat(self) -> None:
        self.say("glShadeModel(GL_FLAT)")

    def blend(self) -> None:
        self.blended = True
        self.say("glEnable(GL_BLEND)", f"glBlendColor({self.color()})")
        equation = self.pick(
            ["GL_FUNC_ADD", "GL_FUNC_ADD", "GL_FUNC_SUBTRACT", "GL_FUNC_REVERSE_SUBTRACT", "GL_MIN", "GL_MAX"]
        )
        self.say(f"glBlendEquation({equation})")
        factors = BLENDING if self.exact else [factor for factor in BLENDING if "SRC" not in factor]
        if not self.exact and self.chance(0.4):
            self.say("glBlendEquation(GL_FUNC_ADD)", "glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)")
        elif self.chance(0.7):
            self.say(f"glBlendFunc({self.pick(factors)}, {self.pick(factors)})")
        else:
            self.say(f"glBlendFuncSeparate({', '.join(self.pick(factors) for _ in range(4))})")

    def depth(self) -> None:
        self.say(f"glDepthFunc({self.pick(['GL_LESS', 'GL_LEQUAL', 'GL_GREATER', 'GL_ALWAYS', 'GL_NOTEQUAL'])})")
        if "GREATER" in self.lines[-1]:
            self.say("glClearDepth(0)", "glClear(GL_DEPTH_BUFFER_BIT)")
        if self.chance(0.3):
            self.say(f"glDepthRange({self.number(0, 0.4)}, {self.number(0.6, 1)})")

    def stencil(self) -> None:
        self.stenciled = True
        self.say("glEnable(GL_STENCIL_TEST)")
        self.say(f"glStencilFunc(GL_ALWAYS, {self.random.randint(0, 3)}, {self.pick(['255', '1', '3'])})")
        self.say("glStencilOp(GL_KEEP, GL_REPLACE, GL_INCR)")
        self.rectangle()
        if self.chance(0.4):
            self.say(f"glStencilMask({self.random.randint(0, 7)})")
        self.say(f"glStencilFunc({self.pick(TESTS)}, {self.random.randint(0, 2)}, {self.pick(['255', '1', '3'])})")
        self.say(f"glStencilOp({', '.join(self.pick(STENCILS) for _ in range(3))})")

    def scissor(self) -> None:
        self.say(
            "glEnable(GL_SCISSOR_TEST)", f"glScissor({', '.join(str(self.random.randint(10, 80)) for _ in range(4))})"
        )
        if self.chance(0.5):
            self.say(f"glClearColor({self.color()})", "glClear(GL_COLOR_BUFFER_BIT)")

    def mask(self) -> None:
        self.say(f"glColorMask({', '.join(self.pick(['GL_TRUE', 'GL_TRUE', 'GL_FALSE']) for _ in range(4))})")

    def clip(self) -> None:
        for plane in self.random.sample(range(6), self.random.randint(1, 2)):
            self.say(f"glClipPlane(GL_CLIP_PLANE{plane}, [{self.numbers(3, -1, 1)}, {self.number(-0.2, 0.5)}])")
            self.say(f"glEnable(GL_CLIP_PLANE{plane})")

    def polygons(self) -> None:
        if self.exact and self.chance(0.5):
            self.outlined = True
            self.say("glDisable(GL_DEPTH_TEST)")
            self.say(f"glPolygonMode({self.pick(['GL_FRONT', 'GL_BACK', 'GL_FRONT_AND_BACK'])}, "
                     f"{self.pick(['GL_LINE', 'GL_POINT'])})")  # fmt: skip
        elif self.chance(0.5):
            self.say(
                "glEnable(GL_POLYGON_STIPPLE)",
                f"glPolygonStipple(bytes([{self.random.randint(1, 255)}, 51, 15, 204]) * 32)",
            )
        if self.chance(0.4):
            self.say("glEnable(GL_CULL_FACE)", f"glCullFace({self.pick(['GL_FRONT', 'GL_BACK'])})")
        if self.chance(0.3):
            self.say("glFrontFace(GL_CW)")
        if self.chance(0.3):
            self.say("glEnable(GL_POLYGON_OFFSET_FILL)", f"glPolygonOffset({self.numbers(2, -2, 2)})")

    def points(self) -> None:
        self.say(f"glPointSize({self.random.randint(1, 9)})")

    def alpha(self) -> None:
        self.say("glEnable(GL_ALPHA_TEST)", f"glAlphaFunc({self.pick(TESTS)}, {self.number(0.2, 0.8)})")

    def logic(self) -> None:
        self.say("glEnable(GL_COLOR_LOGIC_OP)", f"glLogicOp({self.pick(LOGIC)})")


EXACT_STATES = (
    States.flat, States.depth, States.stencil, States.scissor, States.mask, States.clip, States.polygons, States.points,
    States.alpha, States.logic, States.blend, States.transform,
)  # fmt: skip
STATES = (
    States.lighting, States.lighting, States.lighting, States.texture, States.texture, States.fog, States.sum,
    States.flat, States.blend, States.depth, States.stencil, States.scissor, States.mask, States.clip, States.polygons,
    States.points, States.transform,
)  # fmt: skip
