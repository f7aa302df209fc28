r"""A camera in OpenGL is a matrix, and a light stays where the modelview matrix puts it **when `glLight` is called**:

$$ \mathbf{v}_\mathrm{eye} = M\,\mathbf{v}, \qquad M = V R, \qquad \mathbf{l}_\mathrm{eye} = V\,\mathbf{l} $$

$V$ is the camera (world to eye), $R$ turns an object (object to world). Complete `place()`, so that

- the projection has an angle of view of 40 degrees, the aspect 1, and planes at 1 and 20;
- the eye is at (4, 3, 6) and looks at (0, 0.5, 0), with y up;
- the lamp `GL_LIGHT0` stands in the world at (2, 4, 3): a lamp, not a sun;
- the floor lies in the world as it is, and the teapot, and only the teapot, is turned by 30 degrees about the y axis.

The functions `floor()` and `teapot()` draw; leave them as they are.
"""

from collections.abc import Iterator

import numpy as np

from glsim.course.exercise import Definition, Drawn, Picture
from glsim.machine.frame import Draw, Frame

STARTER = '''\
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
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    floor()
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
'''

EYE, CENTER = np.array([4.0, 3.0, 6.0]), np.array([0.0, 0.5, 0.0])
LAMP = np.array([2.0, 4.0, 3.0, 1.0])
COUNT_FLOOR = 4


def look_at(eye, center, up=(0.0, 1.0, 0.0)):
    """gluLookAt's matrix, (4, 4), for columns v: M @ v."""
    back = (eye - center) / np.linalg.norm(eye - center)
    right = np.cross(up, back)
    right = right / np.linalg.norm(right)
    M = np.eye(4)
    M[:3, :3] = right, np.cross(back, right), back
    M[:3, 3] = -M[:3, :3] @ eye
    return M


def turn(degrees):
    """A turn about the y axis, (4, 4)."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    M = np.eye(4)
    M[[0, 0, 2, 2], [0, 2, 0, 2]] = c, s, -s, c
    return M


def perspective(angle, aspect, near, far):
    """gluPerspective's matrix, (4, 4)."""
    f = 1 / np.tan(np.radians(angle) / 2)
    a, b = (far + near) / (near - far), 2 * far * near / (near - far)
    return np.array([[f / aspect, 0, 0, 0], [0, f, 0, 0], [0, 0, a, b], [0, 0, -1, 0]])


V, R, P = look_at(EYE, CENTER), turn(30), perspective(40, 1, 1, 20)


def alike(a, b) -> bool:
    return bool(np.allclose(a, b, rtol=0, atol=2e-4))


def modelview(draw: Draw):
    return draw.matrices[0].get().T.astype(float)


def projection(draw: Draw):
    return draw.matrices[1].get().T.astype(float)


def floors(frame: Frame) -> Iterator[Draw]:
    return (draw for draw in frame.draws if draw.count == COUNT_FLOOR)


def pots(frame: Frame) -> Iterator[Draw]:
    return (draw for draw in frame.draws if draw.count > COUNT_FLOOR)


def everything(frame: Frame) -> str | None:
    if not any(floors(frame)):
        return "No floor is drawn: place() must call floor()."
    return (
        None if any(pots(frame)) else "No teapot is drawn: place() must call teapot()."
    )


def judge_projection(frame: Frame) -> str | None:
    for draw in frame.draws:
        given = projection(draw)
        if alike(given, P):
            continue
        if alike(given, np.eye(4)):
            return (
                "The projection matrix is still the identity: choose GL_PROJECTION with glMatrixMode, then set the"
                " perspective."
            )
        if alike(given, P @ V) or alike(given, V) or alike(given, V @ P):
            return (
                "The camera is in the projection matrix: the light does not know of it then. It belongs into the"
                " modelview matrix."
            )
        if alike(given, P @ P):
            return "The perspective is multiplied twice: begin with glLoadIdentity."
        if alike(given, perspective(np.degrees(40), 1, 1, 20)) or alike(
            given, perspective(np.radians(40), 1, 1, 20)
        ):
            return "gluPerspective takes the angle in degrees."
        if alike(given[[0, 1, 3]], P[[0, 1, 3]]):
            return "The planes are wrong: the near one is at 1, the far one at 20 from the eye."
        if alike(given[1:], P[1:]):
            return "The aspect is wrong: the window is as wide as high."
        return "The projection is not the one that is asked for: the order is angle of view, aspect, near, far."
    return everything(frame)


def judge_camera(frame: Frame) -> str | None:
    """The floor's modelview matrix is the camera alone."""
    for draw in floors(frame):
        given = modelview(draw)
        if alike(given, V):
            continue
        if alike(given, np.eye(4)):
            return (
                "The floor's modelview matrix is the identity: the eye sits at the origin. Is the camera set, with"
                " GL_MODELVIEW chosen, before the floor is drawn?"
            )
        if alike(given, V @ R) or alike(given, V @ turn(-30)):
            return "The floor is turned with the teapot: draw it before the turn, or restore the matrix."
        if alike(given, R @ V):
            return "The turn comes before the camera: it turns the whole world about the eye."
        if alike(given, P @ V):
            return "The perspective is in the modelview matrix: it belongs into GL_PROJECTION."
        if alike(given, look_at(CENTER, EYE)):
            return "Eye and centre are exchanged: gluLookAt takes first where the eye is, then what it looks at."
        if alike(given, V @ V):
            return "The camera is multiplied twice: begin with glLoadIdentity."
        if alike(given[:3, :3], V[:3, :3]):
            return "The direction of view is right, but the eye is not at (4, 3, 6)."
        if alike(given @ [*EYE, 1], (0, 0, 0, 1)) and alike(
            given[:3, :3] @ given[:3, :3].T, np.eye(3)
        ):
            return (
                "The eye is where it should be, but it looks elsewhere, or y is not up."
            )
        if alike(given, np.linalg.inv(V)):
            return "This is the inverse: it puts the camera into the world, but the world must come to the eye."
        return "The floor's modelview matrix is not that of a camera at (4, 3, 6) that looks at (0, 0.5, 0) with y up."
    return everything(frame)


def judge_turn(frame: Frame) -> str | None:
    for draw in pots(frame):
        given = modelview(draw)
        if alike(given, V @ R):
            continue
        if alike(given, V):
            return "The teapot is not turned: turn it after the camera was placed, before it is drawn."
        if alike(given, R @ V):
            return "The turn comes before the camera: it turns the whole world about the eye."
        if alike(given, V @ turn(-30)):
            return "The teapot is turned the other way."
        if alike(given, V @ turn(np.radians(30))):
            return "glRotate takes the angle in degrees."
        return "The teapot's modelview matrix must be camera times turn: first the camera, then 30 degrees about y."
    return everything(frame)


def judge_light(frame: Frame) -> str | None:
    for draw in (*pots(frame), *floors(frame)):
        lighting = draw.state.lighting
        if not lighting.enabled or not lighting.light_enabled[0]:
            return "The light is off: GL_LIGHTING and GL_LIGHT0 must be enabled."
        given = np.array(lighting.lights[0].position)
        if alike(given, V @ LAMP):
            continue
        if alike(given, (0, 0, 1, 0)):
            if draw.count == COUNT_FLOOR:
                return "The floor is drawn before the light has its place."
            return "GL_LIGHT0 has the position that it had at the beginning: it shines along the view."
        if alike(given[3], 0):
            return "The fourth number of the position is 0: that is a sun, a direction without a place."
        if alike(given, LAMP):
            return (
                "The light was placed before the camera: it is at (2, 4, 3) from the eye and moves with it, like a"
                " miner's lamp."
            )
        if alike(given, V @ R @ LAMP):
            return "The light was placed after the turn: it turns with the teapot."
        return "The light is not at (2, 4, 3) of the world: glLight multiplies the position by the modelview matrix of that moment."
    return everything(frame)


EXERCISE = Definition(
    title="Place the camera, then the light",
    lesson=1,
    starter=STARTER,
    program=True,
    parts=[
        Drawn("the projection", judge_projection),
        Drawn("the camera: where the floor is, seen from the eye", judge_camera, points=2),
        Drawn("the teapot, turned in the world", judge_turn),
        Drawn("the lamp in the world", judge_light, points=2),
        Picture("the picture", "01_camera_and_light.png",
                "All matrices are right, but the picture differs: are the colours, the background and the depth test those"
                " of the file you began with?"),
    ],
)  # fmt: skip
