HEAD = """from glsim.gl import *
from glsim.glu import *
from glsim.glut import *

CORNERS = [(-1.2, 0, 1.2), (1.2, 0, 1.2), (1.2, 0, -1.2), (-1.2, 0, -1.2)]
TOP = (0, 1.2, 0)
S = 0.5**0.5
NORMALS = [(0, S, S), (S, S, 0), (0, S, -S), (-S, S, 0)]
"""
END = """
glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(256, 256)
glutCreateWindow("A house")
glClearColor(0.6, 0.7, 0.8, 1)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glMatrixMode(GL_PROJECTION)
gluPerspective(40, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
"""
RIGHT = {
    "materials, a display list, one glBegin a face": HEAD
    + """
def material(r, g, b):
    glMaterialfv(GL_FRONT, GL_AMBIENT, [r, g, b, 1])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [r, g, b, 1])


def roof():
    for k, normal in enumerate(NORMALS):
        glBegin(GL_TRIANGLES)
        for corner in (CORNERS[k], CORNERS[(k + 1) % 4], TOP):
            glNormal(normal)
            glVertex(corner)
        glEnd()


def display():
    glEnable(GL_DEPTH_TEST)
    glDepthFunc(GL_LEQUAL)
    glEnable(GL_NORMALIZE)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    gluLookAt(3, 2, 8, 0, 0.5, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [4, 5, 6, 1])
    glNewList(1, GL_COMPILE)
    material(0.9, 0.8, 0.5)
    glPushMatrix()
    glScalef(2, 1.5, 2)
    glutSolidCube(1)
    glPopMatrix()
    glEndList()
    glCallList(1)
    material(0.7, 0.2, 0.1)
    glPushMatrix()
    glTranslatef(0, 0.75, 0)
    roof()
    glPopMatrix()
    material(0.2, 0.4, 0.8)
    glTranslatef(-1.5, 0.5, -3)
    glutSolidSphere(1.5, 40, 40)
    glutSwapBuffers()

"""
    + END,
    "switched on where it is needed": HEAD
    + """
def roof():
    glBegin(GL_TRIANGLES)
    for k in range(4):
        glNormal3fv(NORMALS[k])
        glVertex3fv(CORNERS[k])
        glVertex3fv(CORNERS[(k + 1) % 4])
        glVertex3fv(TOP)
    glEnd()


def draw_world():
    glLoadIdentity()
    gluLookAt(3, 2, 8, 0, 0.5, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [4, 5, 6, 1])
    glColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE)
    glEnable(GL_COLOR_MATERIAL)
    glEnable(GL_DEPTH_TEST)
    glColor3f(0.2, 0.4, 0.8)
    glPushMatrix()
    glTranslatef(-1.5, 0.5, -3)
    glutSolidSphere(1.5, 40, 40)
    glPopMatrix()
    glColor3f(0.9, 0.8, 0.5)
    glEnable(GL_NORMALIZE)
    glPushMatrix()
    glScalef(2, 1.5, 2)
    glutSolidCube(1)
    glPopMatrix()
    glDisable(GL_NORMALIZE)
    glColor3f(0.7, 0.2, 0.1)
    glPushMatrix()
    glTranslatef(0, 0.75, 0)
    roof()
    glPopMatrix()


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    draw_world()
    glutSwapBuffers()

"""
    + END,
}

LIGHT = "    glLightfv(GL_LIGHT0, GL_POSITION, [4, 5, 6, 1])\n"
CAMERA = "    gluLookAt(3, 2, 8, 0, 0.5, 0, 0, 1, 0)\n"
NORMAL = "        glNormal3fv(NORMALS[k])\n"
TOP = "        glVertex3fv(TOP)\n"
DEPTH, UNIT, COLOR = "glEnable(GL_DEPTH_TEST)\n", "glEnable(GL_NORMALIZE)\n", "glEnable(GL_COLOR_MATERIAL)\n"
WRONG = {
    "no depth test": ([(DEPTH, "")], "nothing compares depths"),
    "no depth buffer": ([("GLUT_DOUBLE | GLUT_DEPTH", "GLUT_DOUBLE")], "no depth buffer"),
    "depth not cleared": ([("GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT", "GL_COLOR_BUFFER_BIT")], "not cleared"),
    "farther": ([(DEPTH, DEPTH + "glDepthFunc(GL_GREATER)\n")], "farther away"),
    "depth not written": ([(DEPTH, DEPTH + "glDepthMask(GL_FALSE)\n")], "not written"),
    "no colour material": ([(COLOR, "")], "is grey"),
    "diffuse alone": ([(COLOR, "glColorMaterial(GL_FRONT, GL_DIFFUSE)\n" + COLOR)], "ambient one is not"),
    "back faces": ([(COLOR, "glColorMaterial(GL_BACK, GL_AMBIENT_AND_DIFFUSE)\n" + COLOR)], "is grey"),
    "lighting off": ([("glEnable(GL_LIGHTING)\n", "")], "Lighting is off"),
    "lamp before camera": ([(CAMERA + LIGHT, LIGHT + CAMERA)], "moves with the camera"),
    "lamp far away": ([("[4, 5, 6, 1]", "[4, 5, 6, 0]")], "a direction, not a lamp"),
    "lamp after a scale": ([(LIGHT, ""), ("    glScalef(2, 1.5, 2)\n", "    glScalef(2, 1.5, 2)\n" + LIGHT)],
                           "which matrix was there"),
    "normal after its vertices": ([(NORMAL, ""), (TOP, TOP + NORMAL)], "normal of the face before it"),
    "normal before the last vertex": ([(NORMAL, ""), (TOP, NORMAL + TOP)], "comes too late"),
    "normals inside": ([(NORMAL, "        glNormal3f(*[-x for x in NORMALS[k]])\n")], "point inside"),
    "one normal": ([(NORMAL, ""), ("glBegin(GL_TRIANGLES)\n", "glBegin(GL_TRIANGLES)\n    glNormal3fv(NORMALS[0])\n")],
                   "the same normal"),
    "no normalize": ([(UNIT, "")], "N·L is no cosine"),
    "rescale": ([(UNIT, "glEnable(GL_RESCALE_NORMAL)\n")], "scaled alike"),
    "no ball": ([("    glutSolidSphere(1.5, 40, 40)\n", "")], "ball is not drawn"),
    "another ball": ([("(-1.5, 0.5, -3)", "(1.5, 0.5, -3)")], "the picture differs"),
}  # fmt: skip
