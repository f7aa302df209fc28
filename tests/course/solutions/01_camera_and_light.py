from glsim.gl import *
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


def place():
    """Places the camera, the light, and then draws what stands in the world."""
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(4, 3, 6, 0, 0.5, 0, 0, 1, 0)
    glLightfv(GL_LIGHT0, GL_POSITION, [2, 4, 3, 1])
    floor()
    glRotatef(30, 0, 1, 0)
    teapot()


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    place()
    glutSwapBuffers()


glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(256, 256)
glutCreateWindow("Camera and light")
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glutDisplayFunc(display)
glutMainLoop()
