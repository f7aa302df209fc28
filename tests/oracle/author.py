"""Writes random programs that OpenGL decides: each statement is valid, and what it draws is specified.

A program is a list of statements in Python.  ``AVOIDED`` names what is left out, and why.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random

# What no program does -> why the two pictures may differ there.
AVOIDED = {
    "rectangles, quads and polygons with lighting or sphere maps": "how they are cut is not specified",
    "several blended layers, GL_SRC_COLOR as the second factor": "each rounds a source to 8 bits again",
    "alpha test and logic op on colours that vary": "one unit of rounding decides about a whole pixel",
    "GL_NEAREST and GL_LINEAR_MIPMAP_NEAREST": "where a texel or a level begins is a matter of the last bit",
    "wide, stippled and smooth lines": "ends may differ by a pixel; test_native.py has a measure for them",
    "smooth points": "Mesa draws hard discs",
    "glMaterial while GL_COLOR_MATERIAL is enabled, glColorMaterial(GL_BACK)": "Mesa contradicts the specification",
    "glMaterial between the vertices of a line loop": "Mesa loses the closing line",
    "glRect with lighting and flat shading": "Mesa draws a quad, whose last vertex counts, instead of a polygon",
    "the depth test on outlines": "an edge that two polygons share is drawn twice, and may hide itself",
    "generated directions in cube maps": "some lie just between two faces",
    "a shininess of 0": "Mesa drops the highlight where N.H < 0",
    "glBegin with fewer vertices than a primitive has": "Mesa drops the primitives that follow",
    "attributes and materials first set after the first vertex": "in lists, Mesa gives them to the vertices before",
    "several kinds of vertices in a list": "Mesa gives attributes of later primitives to earlier ones",
    "zoomed pixel rectangles at fractions of a pixel": "Mesa rounds the raster position first",
    "surfaces seen edge-on, outlines of triangles without area": "the last bit decides which side is seen",
    "outlines in several colours": "where two edges meet the last bit decides which is seen",
    "the current colour after GL_COMPILE_AND_EXECUTE": "Mesa does not keep it; programs set it again",
    "the current normal after GL_AUTO_NORMAL": "Mesa changes it; programs set it again",
    "pixel rectangles and bitmaps with fog, textures or a colour sum": "Mesa leaves these stages out",
    "bitmaps that overlap, with blending or the stencil test": "Mesa draws bitmaps late, and all at once",
    "glDrawPixels with GL_MAP_COLOR": "Mesa gets blue by none of the maps",
    "fog with a secondary colour": "Mesa does not clamp the sum before fog",
    "glPopAttrib(GL_ENABLE_BIT) around lights, GL_FOG_BIT around GL_COLOR_SUM": "Mesa leaves them as they are",
    "polygon stipple with GL_LINE and GL_POINT": "Mesa stipples the edges",
    "normals of GL_BYTE in arrays": "Mesa maps them by OpenGL 4.2's rule",
    "internal formats of other than 8 bits, texture borders": "glsim keeps 8 bits and no border (SUPPORT.md)",
    "textures without all their levels": "Mesa falls back to another dimension",
    "GL_DECAL with formats other than GL_RGB and GL_RGBA": "undefined in the specification",
}

FORMATS = {
    "GL_RGB": ("GL_RGB", 3), "GL_RGBA": ("GL_RGBA", 4), "GL_LUMINANCE": ("GL_LUMINANCE", 1), "GL_ALPHA": ("GL_ALPHA", 1),
    "GL_LUMINANCE_ALPHA": ("GL_LUMINANCE_ALPHA", 2), "GL_INTENSITY": ("GL_LUMINANCE", 1),
    "GL_RGBA8": ("GL_BGRA", 4), "GL_RGB8": ("GL_BGR", 3),
}  # fmt: skip
SIMPLE = (
    "GL_POINTS",
    "GL_LINES",
    "GL_LINE_STRIP",
    "GL_LINE_LOOP",
    "GL_TRIANGLES",
    "GL_TRIANGLE_STRIP",
    "GL_TRIANGLE_FAN",
)
BLENDING = (
    "GL_ZERO GL_ONE GL_SRC_COLOR GL_ONE_MINUS_SRC_COLOR GL_DST_COLOR GL_ONE_MINUS_DST_COLOR GL_SRC_ALPHA "
    "GL_ONE_MINUS_SRC_ALPHA GL_DST_ALPHA GL_ONE_MINUS_DST_ALPHA GL_CONSTANT_COLOR GL_ONE_MINUS_CONSTANT_COLOR "
    "GL_CONSTANT_ALPHA GL_ONE_MINUS_CONSTANT_ALPHA"
).split()
TESTS = "GL_LESS GL_LEQUAL GL_GREATER GL_GEQUAL GL_EQUAL GL_NOTEQUAL GL_ALWAYS".split()
STENCILS = "GL_KEEP GL_ZERO GL_REPLACE GL_INCR GL_DECR GL_INVERT GL_INCR_WRAP GL_DECR_WRAP".split()
MATERIAL = "GL_AMBIENT GL_DIFFUSE GL_AMBIENT_AND_DIFFUSE GL_SPECULAR GL_EMISSION".split()
LOGIC = (
    "GL_CLEAR GL_AND GL_AND_REVERSE GL_COPY GL_AND_INVERTED GL_NOOP GL_XOR GL_OR GL_NOR GL_EQUIV GL_INVERT "
    "GL_OR_REVERSE GL_COPY_INVERTED GL_OR_INVERTED GL_NAND GL_SET"
).split()


class Author:
    """One program in the making.

    exact: colours are the same all over each primitive, so that tests of equality and logic operations may follow.
    lit, fogged, summed, outlined, tracked, stenciled, blended: features that are on.  curved: attributes are not linear.
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

    def program(self) -> list[str]:
        self.camera()
        features = STATES if not self.exact else EXACT_STATES
        for feature in self.random.sample(features, self.random.randint(1, 6)):
            feature(self)
        for _ in range(1 if self.blended else self.random.randint(1, 4)):
            self.random.choice(THINGS)(self)
        return self.lines

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
        mipmaps = target != "GL_TEXTURE_3D" and self.chance(0.3)
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
                "GL_TEXTURE_1D": f"texels(8, 1, {components})", "GL_TEXTURE_2D": f"texels({width}, {height}, {components})",
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
            self.generators(target)
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
                wraps = "GL_CLAMP GL_REPEAT GL_CLAMP_TO_EDGE GL_CLAMP_TO_BORDER GL_MIRRORED_REPEAT".split()
                self.say(f"glTexParameteri({target}, GL_TEXTURE_WRAP_{axis}, {self.pick(wraps)})")
        if self.chance(0.4):
            self.say(f"glTexParameterfv({target}, GL_TEXTURE_BORDER_COLOR, [{self.color(0)}])")

    def environment(self, internal: str) -> None:
        modes = "GL_MODULATE GL_BLEND GL_REPLACE GL_ADD GL_COMBINE".split()
        mode = self.pick(modes + (["GL_DECAL"] if internal in ("GL_RGB", "GL_RGBA") else []))
        self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, {mode})")
        if self.chance(0.5):
            self.say(f"glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, [{self.color(0)}])")
        if mode != "GL_COMBINE":
            return
        functions = "GL_REPLACE GL_MODULATE GL_ADD GL_ADD_SIGNED GL_INTERPOLATE GL_SUBTRACT".split()
        self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, {self.pick([*functions, 'GL_DOT3_RGB', 'GL_DOT3_RGBA'])})")
        self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, {self.pick(functions)})")
        for k in range(3):
            source = self.pick("GL_TEXTURE GL_CONSTANT GL_PRIMARY_COLOR GL_PREVIOUS".split())
            self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE{k}_RGB, {source})")
            operands = "GL_SRC_COLOR GL_ONE_MINUS_SRC_COLOR GL_SRC_ALPHA GL_ONE_MINUS_SRC_ALPHA".split()
            self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND{k}_RGB, {self.pick(operands)})")
            self.say(f"glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND{k}_ALPHA, {self.pick(operands[2:])})")
        if self.chance(0.3):
            self.say(f"glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, {self.pick(['1', '2', '4'])})")

    def generators(self, target: str) -> None:
        modes = ["GL_OBJECT_LINEAR", "GL_EYE_LINEAR", "GL_SPHERE_MAP"]
        if target == "GL_TEXTURE_CUBE_MAP":
            modes = ["GL_OBJECT_LINEAR", "GL_EYE_LINEAR"]
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
        equation = self.pick("GL_FUNC_ADD GL_FUNC_ADD GL_FUNC_SUBTRACT GL_FUNC_REVERSE_SUBTRACT GL_MIN GL_MAX".split())
        self.say(f"glBlendEquation({equation})")
        destination = BLENDING if self.exact else [factor for factor in BLENDING if "SRC_COLOR" not in factor]
        if self.chance(0.7):
            self.say(f"glBlendFunc({self.pick([*BLENDING, 'GL_SRC_ALPHA_SATURATE'])}, {self.pick(destination)})")
        else:
            factors = [self.pick(choices) for choices in (BLENDING, destination, BLENDING, destination)]
            self.say(f"glBlendFuncSeparate({', '.join(factors)})")

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

    # ------------------------------------------------------------ things that are drawn

    def attributes(self) -> list[Callable[[], str]]:
        """What each vertex of a primitive sets, beside its position."""
        made: list[Callable[[], str]] = []
        if self.exact:
            self.say(f"glColor4f({self.color()})")
            return made
        if self.chance(0.7):
            made.append(lambda: f"glColor4f({self.color()})")
        if self.lit or self.chance(0.2):
            made.append(lambda: f"glNormal3f({self.numbers(2, -0.7, 0.7)}, {self.number(0.3, 1)})")
        for number, target in enumerate(self.units):
            if number == 0 and self.chance(0.8):
                made.append(lambda: f"glTexCoord{self.pick(['2f', '2d'])}({self.numbers(2, -0.4, 1.5)})")
            elif target == "GL_TEXTURE_CUBE_MAP" or self.chance(0.5):
                made.append(lambda: f"glMultiTexCoord3f(GL_TEXTURE1, {self.numbers(3, -0.5, 1.4)})")
        if self.summed and self.chance(0.5):
            made.append(lambda: f"glSecondaryColor3f({self.numbers(3, 0, 0.5)})")
        if self.fogged and self.chance(0.3):
            made.append(lambda: f"glFogCoordf({self.number(0, 4)})")
        return made

    def position(self) -> str:
        return f"glVertex3f({self.numbers(2, -1.1, 1.1)}, {self.number(-0.9, 0.9)})"

    def primitive(self) -> None:
        mode, count = self.pick(SIMPLE), self.random.randint(2, 4) * 3
        if self.blended:
            mode, count = "GL_TRIANGLES", 3
        made, first, changing = self.attributes(), len(self.lines), ""
        if self.lit and not self.tracked and not self.in_list and mode != "GL_LINE_LOOP" and self.chance(0.3):
            changing = f"{self.pick(['GL_FRONT', 'GL_BACK', 'GL_FRONT_AND_BACK'])}, {self.pick(MATERIAL)}"
        self.say(f"glBegin({mode})")
        for k in range(count):
            self.say(*(attribute() for attribute in made if k == 0 or self.chance(0.8)))
            if changing and (k == 0 or self.chance(0.3)):
                self.say(f"glMaterialfv({changing}, [{self.color(0)}])")
            self.say(self.position())
        self.say("glEnd()")
        self.join(first)

    def plane(self) -> None:
        """Four corners whose attributes are linear in x and y, however they are cut."""
        if self.lit or self.curved:
            return self.sphere()
        mode = self.pick(["GL_QUADS", "GL_POLYGON", "GL_QUAD_STRIP", "GL_TRIANGLE_STRIP"])
        x, y, z = self.random.uniform(-1, 0.2), self.random.uniform(-1, 0.2), self.random.uniform(-0.5, 0.5)
        w, h = self.random.uniform(0.3, 1), self.random.uniform(0.3, 1)
        corners = [(0, 0), (1, 0), (0, 1), (1, 1)] if "STRIP" in mode else [(0, 0), (1, 0), (1, 1), (0, 1)]
        ramp, first = not self.exact and self.chance(0.5), len(self.lines)
        self.say(f"glColor4f({self.color()})", f"glBegin({mode})")
        for a, b in corners:
            if ramp:
                self.say(
                    f"glColor4f({0.1 + 0.8 * a:g}, {0.2 + 0.6 * b:g}, {0.9 - 0.4 * a - 0.4 * b:g}, {0.3 + 0.5 * b:g})"
                )
            if self.units:
                self.say(f"glTexCoord2f({a}, {b})")
            self.say(f"glVertex3f({x + a * w:.3g}, {y + b * h:.3g}, {z:.3g})")
        self.say("glEnd()")
        self.join(first)

    def sphere(self) -> None:
        if self.outlined:
            return self.primitive()
        first = len(self.lines)
        if self.exact:
            self.say(f"glColor4f({self.color()})")
        if self.blended:
            self.say("glEnable(GL_CULL_FACE)")
        self.say("glPushMatrix()")
        self.transform()
        self.say(f"glRotatef({self.number(10, 80)}, {self.numbers(3, 0.2, 1)})")
        self.say(
            f"ball({self.random.randint(3, 12)}, {self.random.randint(2, 8)}, {self.number(0.3, 0.9)}, mode=GL_TRIANGLES)"
        )
        self.say("glPopMatrix()")
        self.join(first)

    def rectangle(self) -> None:
        if self.lit or self.curved:
            return self.sphere()
        first = len(self.lines)
        self.say(f"glColor4f({self.color()})")
        self.say(f"glRect{self.pick(['f', 'd'])}({self.numbers(2, -1, 0)}, {self.numbers(2, 0, 1)})")
        self.join(first)

    def arrays(self) -> None:
        count = 3 * self.random.randint(2, 5)
        self.say(f"random = np.random.default_rng({self.random.randint(0, 999)})")
        self.say(f"glColor4f({self.color()})", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)")
        self.positions(count)
        names = ["VERTEX"]
        if not self.exact and self.chance(0.7):
            names.append("COLOR")
            values, kind = self.random.choice(
                [("integers(0, 256, ({}, 4), np.uint8)", "UNSIGNED_BYTE"), ("random(({}, 4))", "DOUBLE")]
            )
            self.array(f"colors = random.{values.format(count)}", "COLOR", f"glColorPointer(4, GL_{kind}, 0, colors)")
        if self.chance(0.5):
            names.append("NORMAL")
            self.array(
                f"normals = random.uniform(-1, 1, ({count}, 3)).astype('f4')",
                "NORMAL",
                "glNormalPointer(GL_FLOAT, 0, normals)",
            )
        if self.units and self.chance(0.7):
            names.append("TEXTURE_COORD")
            values = f"coords = random.uniform(-0.3, 1.3, ({count}, 2)).astype('f4')"
            self.array(values, "TEXTURE_COORD", "glTexCoordPointer(2, GL_FLOAT, 0, coords)")
        mode, first = self.pick(SIMPLE), len(self.lines)
        if self.blended:
            mode, count = "GL_TRIANGLES", 3
        if self.chance(0.5):
            self.say(f"glDrawArrays({mode}, 0, {count})")
        elif self.chance(0.7):
            letters, kind = self.random.choice([("u1", "BYTE"), ("u2", "SHORT"), ("u4", "INT")])
            indices = f"random.integers(0, {count}, {count}).astype('{letters}')"
            self.say(f"glDrawElements({mode}, {count}, GL_UNSIGNED_{kind}, {indices})")
        else:
            self.say(f"glBegin({mode})", *(f"glArrayElement({k})" for k in range(count)), "glEnd()")
        self.say(*(f"glDisableClientState(GL_{name}_ARRAY)" for name in names))
        self.say(f"glColor4f({self.color()})", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)")
        self.join(first)

    def array(self, values: str, name: str, pointer: str) -> None:
        """One statement, so that no array is enabled that has no values."""
        self.say(f"{values}; {pointer}; glEnableClientState(GL_{name}_ARRAY)")

    def positions(self, count: int) -> None:
        """In the program's memory or in a buffer object."""
        letters, kind = self.random.choice([("f4", "FLOAT"), ("f8", "DOUBLE")])
        values = f"positions = random.uniform(-1, 1, ({count}, 3)).astype('{letters}')"
        if self.chance(0.6):
            self.array(values, "VERTEX", f"glVertexPointer(3, GL_{kind}, 0, positions)")
            return
        fill = "glBufferData(GL_ARRAY_BUFFER, positions.nbytes, positions.tobytes(), GL_STATIC_DRAW)"
        pointer = f"glVertexPointer(3, GL_{kind}, 0, None); glBindBuffer(GL_ARRAY_BUFFER, 0)"
        self.array(f"{values}; glBindBuffer(GL_ARRAY_BUFFER, 1); {fill}", "VERTEX", pointer)

    def display_list(self) -> None:
        if self.in_list:
            return
        self.lists += 1
        number, self.in_list = self.lists, True
        self.say(
            f"glNewList({number}, {self.pick(['GL_COMPILE', 'GL_COMPILE'] + ([] if self.blended else ['GL_COMPILE_AND_EXECUTE']))})"
        )
        self.random.choice([Author.primitive, Author.sphere, Author.rectangle, Author.plane, Author.stack])(self)
        if number > 1 and not self.blended and self.chance(0.4):
            self.say(f"glCallList({number - 1})")
        self.say("glEndList()", f"glColor4f({self.color()})", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)")
        self.in_list = False
        for _ in range(1 if self.blended else self.random.randint(1, 2)):
            first = len(self.lines)
            self.say("glPushMatrix()")
            self.transform()
            self.say(
                f"glColor4f({self.color()})", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)", f"glCallList({number})"
            )
            self.say("glPopMatrix()")
            self.join(first)
        self.say(f"glColor4f({self.color()})", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)")

    def stack(self) -> None:
        """State that is pushed, changed and popped."""
        bits = self.pick(
            ["GL_POLYGON_BIT | GL_POINT_BIT", "GL_CURRENT_BIT | GL_TRANSFORM_BIT",
             "GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT | GL_POLYGON_BIT | GL_POINT_BIT",
             *(["GL_ALL_ATTRIB_BITS"] if not self.summed else [])]
        )  # fmt: skip
        self.say(f"glPushAttrib({bits})")
        if "POLYGON" in bits or "ALL" in bits:
            self.say(
                self.pick(["glEnable(GL_CULL_FACE)", "glFrontFace(GL_CW)", "glPointSize(5)", "glDisable(GL_CULL_FACE)"])
            )
        if "TRANSFORM" in bits:
            self.say("glEnable(GL_NORMALIZE)")
        if "DEPTH" in bits:
            self.say(self.pick(["glDepthMask(GL_FALSE)", "glDisable(GL_DEPTH_TEST)", "glDepthFunc(GL_LEQUAL)"]))
        self.random.choice([Author.primitive, Author.rectangle, Author.sphere])(self)
        self.say("glPopAttrib()")

    def evaluator(self) -> None:
        """A curve or a surface, with normals of its own."""
        if self.blended:
            return self.primitive()
        self.say(f"glColor4f({self.color()})", f"random = np.random.default_rng({self.random.randint(0, 999)})")
        if self.chance(0.4):
            self.say(
                "points = random.uniform(-1, 1, (4, 3)).astype('f4')", "glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, points)"
            )
            self.say("glEnable(GL_MAP1_VERTEX_3)", "glMapGrid1f(9, 0, 1)")
            self.say(f"glEvalMesh1({self.pick(['GL_LINE', 'GL_POINT'])}, 0, 9)", "glDisable(GL_MAP1_VERTEX_3)")
        else:
            self.say(
                "grid = np.stack(np.meshgrid(np.linspace(-0.8, 0.8, 3), np.linspace(-0.7, 0.9, 3), indexing='ij'), -1)"
            )
            self.say("points = np.concatenate([grid, random.uniform(-0.6, 0.6, (3, 3, 1))], -1).astype('f4')")
            self.say("glMap2f(GL_MAP2_VERTEX_3, 0, 1, 9, 3, 0, 1, 3, 3, points)", "glEnable(GL_MAP2_VERTEX_3)")
            if self.lit:
                self.say("glEnable(GL_AUTO_NORMAL)")
            self.say("glMapGrid2f(5, 0, 1, 4, 0, 1)")
            self.say(f"glEvalMesh2({self.pick(['GL_LINE', 'GL_POINT'])}, 0, 5, 0, 4)", "glDisable(GL_MAP2_VERTEX_3)")
            self.say("glDisable(GL_AUTO_NORMAL)", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)")

    def pixels(self) -> None:
        """A rectangle of pixels, without the stages that Mesa leaves out."""
        self.quiet()
        self.say(f"glRasterPos3f({self.numbers(2, -0.8, 0.5)}, {self.number(-0.5, 0.5)})")
        kind = self.random.randrange(4)
        width, height = 4 * self.random.randint(1, 10), self.random.randint(3, 30)
        if self.chance(0.4):
            self.say(f"glWindowPos2i({self.random.randint(0, 90)}, {self.random.randint(0, 90)})")
            self.say(f"glPixelZoom({self.pick(['2', '1.5', '-1', '3'])}, {self.pick(['2', '1', '-2'])})")
        if kind == 0 and not self.exact and self.chance(0.5):
            self.say(
                f"glPixelTransferf(GL_RED_SCALE, {self.number(0.5, 1.5)})",
                f"glPixelTransferf(GL_BLUE_BIAS, {self.number(-0.3, 0.3)})",
            )
        if kind < 2:
            format, components = FORMATS[
                self.pick(["GL_RGB", "GL_RGBA", "GL_LUMINANCE", "GL_RGBA8", "GL_LUMINANCE_ALPHA"])
            ]
            data = f"texels({width}, {height}, {components})"
            self.say(f"glDrawPixels({width}, {height}, {format}, GL_UNSIGNED_BYTE, {data})")
        elif kind == 2 or self.blended or self.stenciled:
            self.say(
                f"glCopyPixels({self.random.randint(0, 60)}, {self.random.randint(0, 60)}, {width}, {height}, GL_COLOR)"
            )
        else:
            self.say(
                f"glColor4f({self.color()})", f"glRasterPos3f({self.numbers(2, -0.8, 0.5)}, {self.number(-0.5, 0.5)})"
            )
            self.say(f"glBitmap(32, 4, {self.random.randint(0, 4)}, 0, 8, 0, bytes([60, 66, 165, 129] * 4))")
        self.say("glPopAttrib()", *(["glEnable(GL_COLOR_SUM)"] if self.summed else []))

    def quiet(self) -> None:
        self.say(
            "glPushAttrib(GL_ALL_ATTRIB_BITS)", "glDisable(GL_FOG)", "glDisable(GL_COLOR_SUM)", "glDisable(GL_LIGHTING)"
        )
        self.say(
            *(f"glDisable({t})" for t in ("GL_TEXTURE_1D", "GL_TEXTURE_2D", "GL_TEXTURE_3D", "GL_TEXTURE_CUBE_MAP"))
        )
        for number in range(1, 4 if len(self.units) > 1 else 1):
            self.say(f"glActiveTexture(GL_TEXTURE{number})")
            self.say(*(f"glDisable({t})" for t in set(self.units)))
        if len(self.units) > 1:
            self.say("glActiveTexture(GL_TEXTURE0)")

    def move(self) -> None:
        self.transform()


EXACT_STATES = (
    Author.flat, Author.depth, Author.stencil, Author.scissor, Author.mask, Author.clip, Author.polygons, Author.points,
    Author.alpha, Author.logic, Author.blend, Author.move,
)  # fmt: skip
STATES = (
    Author.lighting, Author.lighting, Author.lighting, Author.texture, Author.texture, Author.fog, Author.sum,
    Author.flat, Author.blend, Author.depth, Author.stencil, Author.scissor, Author.mask, Author.clip, Author.polygons,
    Author.points, Author.move,
)  # fmt: skip
THINGS = (
    Author.primitive, Author.primitive, Author.primitive, Author.plane, Author.sphere, Author.sphere, Author.rectangle,
    Author.arrays, Author.arrays, Author.display_list, Author.display_list, Author.stack, Author.evaluator,
    Author.pixels, Author.move,
)  # fmt: skip
