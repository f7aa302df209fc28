"""Writes random programs that OpenGL decides: each statement is valid, and what it draws is specified.

A program is a list of statements in Python.  ``AVOIDED`` names what is left out, and why.
"""

from __future__ import annotations

from collections.abc import Callable

from tests.oracle.states import EXACT_STATES, FORMATS, MATERIAL, STATES, States

# What no program does -> why the two pictures may differ there.
AVOIDED = {
    "rectangles, quads and polygons with lighting or sphere maps": "how they are cut is not specified",
    "several blended layers, factors of the source but the usual two": "each rounds to 8 bits again",
    "GL_DOT3_RGB, GL_RGB_SCALE": "they make up to four units of one unit of rounding",
    "mipmaps in perspective and with sphere maps": "the level of detail is not specified exactly",
    "the same triangle twice": "its depth may differ in the last bit from another corner on",
    "pixel zooms whose edges meet pixel centres": "Mesa draws those on the left edge as the column before",
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
    "surfaces in the same plane": "the last bit decides which is in front",
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

SIMPLE = (
    "GL_POINTS",
    "GL_LINES",
    "GL_LINE_STRIP",
    "GL_LINE_LOOP",
    "GL_TRIANGLES",
    "GL_TRIANGLE_STRIP",
    "GL_TRIANGLE_FAN",
)


class Author(States):
    """Writes the program of a seed: the same one each time."""

    def program(self) -> list[str]:
        self.camera()
        features = STATES if not self.exact else EXACT_STATES
        for feature in self.random.sample(features, self.random.randint(1, 6)):
            feature(self)
        for _ in range(1 if self.blended else self.random.randint(1, 4)):
            self.random.choice(THINGS)(self)
        return self.lines

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
        slices, stacks = self.random.randint(3, 12), self.random.randint(2, 8)
        self.say(f"ball({slices}, {stacks}, {self.number(0.3, 0.9)}, mode=GL_TRIANGLES)")
        self.say("glPopMatrix()")
        self.join(first)

    def rectangle(self) -> None:
        if self.lit or self.curved:
            return self.sphere()
        first = len(self.lines)
        self.say(f"glColor4f({self.color()})", "glPushMatrix()", f"glTranslatef(0, 0, {self.number(-0.5, 0.5)})")
        self.say(f"glRect{self.pick(['f', 'd'])}({self.numbers(2, -1, 0)}, {self.numbers(2, 0, 1)})")
        self.say("glPopMatrix()")
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
            indices = f"random.permutation({count}).astype('{letters}')"
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
        modes = ["GL_COMPILE", "GL_COMPILE", *([] if self.blended else ["GL_COMPILE_AND_EXECUTE"])]
        self.say(f"glNewList({number}, {self.pick(modes)})")
        self.random.choice([Author.primitive, Author.sphere, Author.rectangle, Author.plane, Author.stack])(self)
        if number > 1 and not self.blended and self.chance(0.4):
            self.say(f"glCallList({number - 1})")
        self.say("glEndList()", f"glColor4f({self.color()})", f"glNormal3f({self.numbers(2, -0.5, 0.5)}, 1)")
        self.in_list = False
        for _ in range(1 if self.blended else self.random.randint(1, 2)):
            first = len(self.lines)
            self.say("glPushMatrix()")
            self.say(f"glTranslatef(0, 0, {self.number(-0.4, 0.4)})")
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
            self.say(f"glPixelZoom({self.pick(['2', '1.37', '-1', '3'])}, {self.pick(['2', '1', '-2'])})")
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


THINGS = (
    Author.primitive, Author.primitive, Author.primitive, Author.plane, Author.sphere, Author.sphere, Author.rectangle,
    Author.arrays, Author.arrays, Author.display_list, Author.display_list, Author.stack, Author.evaluator,
    Author.pixels, Author.transform,
)  # fmt: skip
