HEAD = """from glsim.gl import *
from glsim.glu import *
from glsim.glut import *


def floor():
    glNormal3f(0, 1, 0)
    glBegin(GL_QUADS)
    for x, z in ((-3, 3), (3, 3), (3, -3), (-3, -3)):
        glVertex3f(x, -0.75, z)
    glEnd()


def teapot():
    glutSolidTeapot(1)

"""
RIGHT = {
    "with a stack, the floor last": HEAD
    + """
def reshape(width, height):
    glViewport(0, 0, width, height)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, width / height, 1, 20)
    glMatrixMode(GL_MODELVIEW)


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    gluLookAt(4.0, 3.0, 6.0, 0.0, 0.5, 0.0, 0.0, 1.0, 0.0)
    glPushMatrix()
    glTranslatef(2, 4, 3)
    glLightfv(GL_LIGHT0, GL_POSITION, (0, 0, 0, 1))
    glPopMatrix()
    glPushMatrix()
    glRotated(30, 0, 2, 0)
    teapot()
    glPopMatrix()
    floor()
    glFlush()


glutInit(["program"])
glutInitDisplayMode(GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(256, 256)
glutCreateWindow(b"Camera and light")
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glutReshapeFunc(reshape)
glutDisplayFunc(display)
glutMainLoop()
""",
    "matrices by hand, without a window": "import math\nimport numpy as np\nimport glsim\n"
    + HEAD
    + """
screen = glsim.offscreen(256, 256)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glMatrixMode(GL_PROJECTION)
top = math.tan(math.radians(20))
glFrustum(-top, top, -top, top, 1, 20)
glMatrixMode(GL_MODELVIEW)
eye = np.array([4.0, 3.0, 6.0])
z = eye - (0, 0.5, 0)
z /= np.linalg.norm(z)
x = np.cross((0, 1, 0), z)
x /= np.linalg.norm(x)
y = np.cross(z, x)
M = np.eye(4)
M[:3, 0], M[:3, 1], M[:3, 2] = x, y, z
M[3, :3] = -eye @ M[:3, :3]
glLoadMatrixd(M)
glLight(GL_LIGHT0, GL_POSITION, [2, 4, 3, 1])
glRotatef(30, 0, 1, 0)
teapot()
glLoadMatrixd(M)
floor()
""",
}

CAMERA = "    gluLookAt(4, 3, 6, 0, 0.5, 0, 0, 1, 0)\n"
LIGHT = "    glLightfv(GL_LIGHT0, GL_POSITION, [2, 4, 3, 1])\n"
LENS = "    gluPerspective(40, 1, 1, 20)\n"
TURN = "    glRotatef(30, 0, 1, 0)\n"
DRAWN = "    floor()\n" + TURN + "    teapot()\n"
WRONG = {
    "light before camera": ([(CAMERA + LIGHT, LIGHT + CAMERA)], "miner's lamp"),
    "camera in projection": ([(LENS, LENS + CAMERA), (CAMERA + LIGHT, LIGHT)], "camera is in the projection matrix"),
    "light after the turn": ([(LIGHT, ""), (TURN, TURN + LIGHT)], "it turns with the teapot"),
    "light after the floor": ([(LIGHT + "    floor()\n", "    floor()\n" + LIGHT)], "before the light has its place"),
    "sun": ([("[2, 4, 3, 1]", "[2, 4, 3, 0]")], "that is a sun"),
    "light forgotten": ([(LIGHT, "")], "at the beginning"),
    "turn before camera": ([(CAMERA, TURN + CAMERA), (DRAWN, "    floor()\n    teapot()\n")], "world about the eye"),
    "floor turned": ([(DRAWN, TURN + "    floor()\n    teapot()\n")], "turned with the teapot"),
    "not turned": ([(TURN, "")], "not turned"),
    "radians": ([("glRotatef(30,", "glRotatef(0.5235988,")], "in degrees"),
    "eye and centre": ([("(4, 3, 6, 0, 0.5, 0,", "(0, 0.5, 0, 4, 3, 6,")], "exchanged"),
    "eye elsewhere": ([("(4, 3, 6, 0, 0.5, 0,", "(4, 6, 3, 0, 0.5, 0,")], "not that of a camera"),
    "looks elsewhere": ([("(4, 3, 6, 0, 0.5, 0,", "(4, 3, 6, 0, 0, 0,")], "looks elsewhere"),
    "planes": ([("40, 1, 1, 20", "40, 1, 0.1, 100")], "planes are wrong"),
    "no teapot": ([("    teapot()\n", "")], "No teapot"),
    "red": ([("    floor()\n    glR", "    glMaterialfv(GL_FRONT, GL_DIFFUSE, [1, 0, 0, 1])\n    floor()\n    glR")],
            "the picture differs"),
}  # fmt: skip
