from glsim.gl import *
from glsim.glu import *
from glsim.glut import *

CORNERS = [(-1.2, 0, 1.2), (1.2, 0, 1.2), (1.2, 0, -1.2), (-1.2, 0, -1.2)]
TOP = (0, 1.2, 0)
S = 0.5**0.5
NORMALS = [(0, S, S), (S, S, 0), (0, S, -S), (-S, S, 0)]


def roof():
    """Four triangles."""
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

    glColor3f(0.9, 0.8, 0.5)  # the house
    glPushMatrix()
    glScalef(2, 1.5, 2)
    glutSolidCube(1)
    glPopMatrix()

    glColor3f(0.7, 0.2, 0.1)
    glPushMatrix()
    glTranslatef(0, 0.75, 0)
    roof()
    glPopMatrix()

    glColor3f(0.2, 0.4, 0.8)  # the ball, behind the house
    glPushMatrix()
    glTranslatef(-1.5, 0.5, -3)
    glutSolidSphere(1.5, 40, 40)
    glPopMatrix()


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    draw_world()
    glutSwapBuffers()


glutInit()
glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(256, 256)
glutCreateWindow("A house")
glClearColor(0.6, 0.7, 0.8, 1)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glEnable(GL_DEPTH_TEST)
glEnable(GL_NORMALIZE)
glEnable(GL_COLOR_MATERIAL)
glMatrixMode(GL_PROJECTION)
gluPerspective(40, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
