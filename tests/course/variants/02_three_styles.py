HEAD = """from glsim.gl import *
from glsim.glu import *
from glsim.glut import *

PAPER = (0.95, 0.95, 0.9)
INK = (0.1, 0.1, 0.4)
CLAY = (0.8, 0.5, 0.2)


def torus():
    glLoadIdentity()
    gluLookAt(0, 3, 5, 0, 0, 0, 0, 1, 0)
    glRotatef(20, 1, 0, 0)
    glutSolidTorus(0.5, 1.2, 10, 18)


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
"""
END = """    glutSwapBuffers()


glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(384, 128)
glutCreateWindow("Three styles")
glClearColor(*PAPER, 1)
glMatrixMode(GL_PROJECTION)
gluPerspective(35, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
"""
RIGHT = {
    "depth alone, attributes on a stack": HEAD
    + """    glEnable(GL_DEPTH_TEST)
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glViewport(0, 0, 128, 128)
    glColor3fv(INK)
    glPolygonMode(GL_FRONT, GL_LINE)
    glPolygonMode(GL_BACK, GL_LINE)
    glDisable(GL_DEPTH_TEST)
    torus()
    glPopAttrib()
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glViewport(128, 0, 128, 128)
    glColorMask(False, False, False, False)
    glPolygonOffset(1.0, 1.0)
    glEnable(GL_POLYGON_OFFSET_FILL)
    torus()
    glColorMask(True, True, True, True)
    glDisable(GL_POLYGON_OFFSET_FILL)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glColor3f(0.1, 0.1, 0.4)
    torus()
    glPopAttrib()
    glViewport(256, 0, 128, 128)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glEnable(GL_COLOR_MATERIAL)
    glColor3fv(CLAY)
    torus()
"""
    + END,
    "from right to left": HEAD
    + """    glEnable(GL_DEPTH_TEST)
    glViewport(256, 0, 128, 128)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, CLAY + (1,))
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, CLAY + (1,))
    torus()
    glDisable(GL_LIGHTING)
    glPolygonOffset(1, 1)
    for x, faces in ((0, False), (128, True)):
        glViewport(x, 0, 128, 128)
        if faces:
            glEnable(GL_POLYGON_OFFSET_FILL)
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
            glColor3f(*PAPER)
            torus()
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
        glColor3f(*INK)
        torus()
"""
    + END,
}

LINE = "    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)\n"
FILL = "    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)\n"
FACES = "    glColor3fv(PAPER)\n    torus()\n"
OFFSET = "    glEnable(GL_POLYGON_OFFSET_FILL)\n"
WRONG = {
    "left filled": ([("128)\n" + LINE, "128)\n")], "edges alone"),
    "fronts alone": ([("128)\n" + LINE, "128)\n    glPolygonMode(GL_FRONT, GL_LINE)\n")], "takes the side first"),
    "left culled": ([("    glViewport(0, 0", "    glEnable(GL_CULL_FACE)\n    glViewport(0, 0")], "shows all edges"),
    "lines in paper": (
        [
            (
                "    glColor3fv(INK)\n    torus()\n\n    glViewport(128",
                "    glColor3fv(CLAY)\n    torus()\n\n    glViewport(128",
            )
        ],
        "colour INK",
    ),
    "thick": ([("    glViewport(0, 0", "    glLineWidth(2)\n    glViewport(0, 0")], "one pixel wide"),
    "no faces": ([(FACES, "")], "Nothing hides"),
    "culling": ([(FACES, "    glEnable(GL_CULL_FACE)\n")], "hides parts of itself"),
    "no depth test": ([("    glEnable(GL_DEPTH_TEST)\n", "")], "nothing decides"),
    "no offset": ([(OFFSET, "")], "fight for the pixels"),
    "offset for lines": ([(OFFSET, "    glEnable(GL_POLYGON_OFFSET_LINE)\n")], "fight for the pixels"),
    "offset to the eye": ([("glPolygonOffset(1, 1)", "glPolygonOffset(-1, -1)")], "to the eye"),
    "large offset": ([("glPolygonOffset(1, 1)", "glPolygonOffset(10, 10)")], "factor 1 and units 1"),
    "faces in clay": ([(FACES, FACES.replace("PAPER", "CLAY"))], "look like the paper"),
    "no depth written": (
        [(FACES, "    glDepthMask(GL_FALSE)\n" + FACES + "    glDepthMask(GL_TRUE)\n")],
        "write their depth",
    ),
    "right as lines": ([("256, 0, 128, 128)\n" + FILL, "256, 0, 128, 128)\n")], "keeps its value"),
    "no light": ([("    glEnable(GL_LIGHTING)\n", "")], "silhouette"),
    "no lamp": ([("    glEnable(GL_LIGHT0)\n", "")], "no lamp"),
    "grey": ([("    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [*CLAY, 1])\n", "    glColor3fv(CLAY)\n")], "grey"),
    "diffuse alone": ([("GL_AMBIENT_AND_DIFFUSE", "GL_DIFFUSE")], "must be CLAY"),
    "viewport": (
        [("glViewport(256, 0, 128, 128)", "glViewport(256, 0, 384, 128)")],
        "Nothing is drawn in the viewport on the right",
    ),
    "another torus": ([("(0.5, 1.2, 10, 18)", "(0.5, 1.2, 12, 18)")], "the picture differs"),
}
