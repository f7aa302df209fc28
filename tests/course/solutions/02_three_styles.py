from glsim.gl import *
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
    glViewport(0, 0, 128, 128)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glColor3fv(INK)
    torus()

    glViewport(128, 0, 128, 128)
    glEnable(GL_DEPTH_TEST)
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
    glEnable(GL_POLYGON_OFFSET_FILL)
    glPolygonOffset(1, 1)
    glColor3fv(PAPER)
    torus()
    glDisable(GL_POLYGON_OFFSET_FILL)
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)
    glColor3fv(INK)
    torus()

    glViewport(256, 0, 128, 128)
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, [*CLAY, 1])
    torus()
    glutSwapBuffers()


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
