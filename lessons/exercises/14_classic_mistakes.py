r"""This program should show a house with a red roof before a blue ball, lit from the upper right. It has five mistakes that
everybody makes once. None is in the shapes, the camera or the order of drawing, and nothing has to be computed anew:

- what is nearer covers what is farther away, and not what is drawn later;
- the colours of `glColor` are those of the material, ambient and diffuse;
- the lamp `GL_LIGHT0` stands in the world at (4, 5, 6);
- each face of the roof has its own normal, that of `NORMALS`;
- where the light comes in at the same angle it is as bright on a stretched surface as on all others:

$$ I = I_L\, k_d\, (\mathbf{N} \cdot \mathbf{L}), \qquad |\mathbf{N}| = 1 $$

Mend `draw_world()`, `roof()` and the lines at the end. Each part of the check is one mistake.
"""

from collections.abc import Iterator

import numpy as np

from glsim.course.exercise import Definition, Drawn, Picture
from glsim.machine import constants as gl
from glsim.machine.frame import Clear, Draw, Frame
from glsim.machine.stage import vertex_stage

STARTER = '''\
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
        glVertex3fv(CORNERS[k])
        glVertex3fv(CORNERS[(k + 1) % 4])
        glVertex3fv(TOP)
        glNormal3fv(NORMALS[k])
    glEnd()


def draw_world():
    glLoadIdentity()
    glLightfv(GL_LIGHT0, GL_POSITION, [4, 5, 6, 1])
    gluLookAt(3, 2, 8, 0, 0.5, 0, 0, 1, 0)

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
glMatrixMode(GL_PROJECTION)
gluPerspective(40, 1, 1, 20)
glMatrixMode(GL_MODELVIEW)
glutDisplayFunc(display)
glutMainLoop()
'''

LAMP = np.array([4.0, 5.0, 6.0, 1.0])
COLORS = {
    "house": (0.9, 0.8, 0.5),
    "roof": (0.7, 0.2, 0.1),
    "ball": (0.2, 0.4, 0.8),
}
NEARER = (gl.GL_LESS, gl.GL_LEQUAL)


def camera():
    """gluLookAt(3, 2, 8, 0, 0.5, 0, 0, 1, 0), (4, 4)."""
    eye = np.array([3.0, 2.0, 8.0])
    back = (eye - (0, 0.5, 0)) / np.linalg.norm(eye - (0, 0.5, 0))
    right = np.cross((0, 1, 0), back)
    right = right / np.linalg.norm(right)
    M = np.eye(4)
    M[:3, :3] = right, np.cross(back, right), back
    M[:3, 3] = -M[:3, :3] @ eye
    return M


V = camera()


def alike(a, b) -> bool:
    return bool(np.allclose(a, b, rtol=0, atol=1e-3))


def chosen(draw: Draw):
    """The numbers of a Draw's vertices in its block."""
    if draw.indices is not None:
        return draw.first + draw.indices
    return np.arange(draw.first, draw.first + draw.count)


def name(draw: Draw) -> str:
    if draw.mode == gl.GL_TRIANGLES and draw.count <= 12:
        return "roof"
    return "house" if draw.count <= 36 else "ball"


def objects(frame: Frame) -> Iterator[tuple[str, Draw]]:
    return ((name(draw), draw) for draw in frame.draws if draw.count)


def incomplete(frame: Frame) -> str | None:
    drawn = {which for which, _ in objects(frame)}
    missing = [which for which in COLORS if which not in drawn]
    return f"The {missing[0]} is not drawn." if missing else None


def judge_depth(frame: Frame) -> str | None:
    cleared = False
    for packet in frame.packets:
        if isinstance(packet, Clear):
            cleared = cleared or bool(packet.mask & gl.GL_DEPTH_BUFFER_BIT)
        elif isinstance(packet, Draw):
            depth = packet.state.depth
            if not depth.test:
                asked = any(moment.state.depth.test for moment in frame.history)
                if asked:
                    return "The depth test is on, but not for everything, or the window has no depth buffer: look at glutInitDisplayMode."
                return "The ball covers the house because it is drawn later: nothing compares depths."
            if depth.func not in NEARER:
                return "The depth test keeps what is farther away: look at glDepthFunc."
            if not depth.mask:
                return "Depths are compared, but not written: look at glDepthMask."
            if not cleared:
                return "The depth buffer is not cleared: it keeps depths of the last picture."
    return incomplete(frame)


def colors(draw: Draw):
    """The ambient and the diffuse reflectance at a Draw's vertices, rows of three numbers."""
    lighting, numbers = draw.state.lighting, chosen(draw)
    faces = [material.front for material in draw.materials_at(numbers)]
    given = {
        "ambient": np.array([face.ambient[:3] for face in faces]),
        "diffuse": np.array([face.diffuse[:3] for face in faces]),
    }
    if lighting.color_material and lighting.color_material_face != gl.GL_BACK:
        current = draw.block.rows[numbers, 6:9]
        if draw.color is not None:
            current = np.broadcast_to(draw.color[:3], current.shape)
        for which, modes in (
            ("ambient", (gl.GL_AMBIENT, gl.GL_AMBIENT_AND_DIFFUSE)),
            ("diffuse", (gl.GL_DIFFUSE, gl.GL_AMBIENT_AND_DIFFUSE)),
        ):
            if lighting.color_material_mode in modes:
                given[which] = current
    return given["ambient"], given["diffuse"]


def judge_colors(frame: Frame) -> str | None:
    for which, draw in objects(frame):
        if not draw.state.lighting.enabled:
            return "Lighting is off: the colours are there, but no light and no shade. A lit surface has a material."
        ambient, diffuse = colors(draw)
        if not alike(diffuse, COLORS[which]):
            if alike(diffuse, 0.8):
                return f"The {which} is grey: under GL_LIGHTING the material counts, and glColor does not change it."
            return f"The {which} has not the diffuse colour that glColor gives it."
        if not alike(ambient, COLORS[which]):
            return f"The diffuse colour of the {which} is right, but its ambient one is not glColor's: its shadow side has another colour."
    return incomplete(frame)


def judge_light(frame: Frame) -> str | None:
    for _, draw in objects(frame):
        lighting = draw.state.lighting
        if not lighting.enabled or not lighting.light_enabled[0]:
            return "GL_LIGHTING and GL_LIGHT0 must be enabled."
        position = lighting.lights[0].position
        if alike(position, LAMP):
            return (
                "The lamp moves with the camera: it got its place while the modelview matrix was still the identity,"
                " so (4, 5, 6) counts from the eye."
            )
        if alike(position[3], 0):
            return "The light is a direction, not a lamp: its fourth number is 0."
        if not alike(position, V @ LAMP):
            return "The lamp is not at (4, 5, 6) of the world: which matrix was there when it got its place?"
    return incomplete(frame)


def judge_normals(frame: Frame) -> str | None:
    rows = [
        draw.block.rows[chosen(draw)]
        for which, draw in objects(frame)
        if which == "roof"
    ]
    if not rows:
        return "The roof is not drawn."
    faces = (
        np.concatenate([r[: len(r) // 3 * 3] for r in rows])
        .astype(float)
        .reshape(-1, 3, 10)
    )
    corners, normals = faces[:, :, :3], faces[:, :, 3:6]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    across = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    normals = normals / np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-9)
    if len(faces) != 4:
        return "The roof has four triangles."
    cosines = (normals * across[:, None]).sum(axis=2)
    if (cosines > 0.999).all():
        return None
    if (cosines < -0.999).all():
        return "The roof's normals point inside."
    if alike(cosines[1:], (across[:-1] * across[1:]).sum(axis=1)[:, None]):
        return (
            "Each face of the roof has the normal of the face before it: a vertex takes the normal that is current"
            " when glVertex is called."
        )
    if alike(normals, normals[0, 0]):
        return "All faces of the roof have the same normal."
    if (cosines[:, 2] > 0.999).all():
        return "Only the last vertex of each face has the face's normal: the normal comes too late for the others."
    return "The corners of a face of the roof have not its normal."


def judge_lengths(frame: Frame) -> str | None:
    for which, draw in objects(frame):
        length = np.linalg.norm(
            vertex_stage(draw, np.unique(chosen(draw)), 0, colors=False).normal, axis=1
        )
        if alike(length, 1):
            continue
        if draw.state.transform.rescale_normal:
            return "GL_RESCALE_NORMAL helps where all axes are scaled alike; the house is stretched by 2, 1.5 and 2."
        return (
            f"The normals of the {which} are {length.min():.2f} to {length.max():.2f} long where the light is computed:"
            " glScale changes them too, and N·L is no cosine any more."
        )
    return incomplete(frame)


EXERCISE = Definition(
    title="Mend the classic mistakes",
    lesson=17,
    starter=STARTER,
    program=True,
    parts=[
        Drawn("what is nearer covers", judge_depth),
        Drawn("the colours of the materials", judge_colors),
        Drawn("the lamp stands in the world", judge_light),
        Drawn("each face of the roof has its normal", judge_normals),
        Drawn("all normals have the length 1", judge_lengths),
        Picture("the picture", "14_classic_mistakes.png",
                "The five mistakes are mended, but the picture differs: shapes, places, camera and colours are those of the"
                " file you began with."),
    ],
)  # fmt: skip
