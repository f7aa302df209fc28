# %% [markdown]
# # 7. Lambert's law
#
# Why is a chalk sphere bright where it faces the lamp and dark towards its edge? Not because the edge reflects less:
# because it receives less. A beam that falls at an angle is spread over more surface.

# %% [markdown]
# ## Predict
#
# Three squares of the same chalk lie under the same lamp, far away, straight above. The first lies flat, the second is
# tilted by 60°, the third by 75°. How bright is the second, compared with the first?
#
# - two thirds, because 60° of 90° are two thirds
# - half
# - as bright: it is the same material and the same lamp

# %% Chalk tilted by 0°, 60° and 75° against the light
import glsim
from glsim.gl import *

screen = glsim.offscreen(720, 240)
glClearColor(0.1, 0.11, 0.14, 1)
glClear(GL_COLOR_BUFFER_BIT)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.9, 0.9, 0.85, 1])  # k_d
glLightfv(GL_LIGHT0, GL_POSITION, [0, 0, 1, 0])  # w = 0: far away, at the eye

for column, angle in enumerate((0, 60, 75)):
    glViewport(240 * column, 0, 240, 240)
    glLoadIdentity()
    glRotatef(angle, 1, 0, 0)
    glNormal3f(0, 0, 1)
    glRectf(-0.8, -0.8, 0.8, 0.8)
screen

# %% [markdown]
# ## What you should see
#
# The second square is half as bright, the third a quarter: $\cos 60° = 0.5$ and $\cos 75° \approx 0.26$. And each is
# uniformly bright: the light is so far away that its direction is the same everywhere, and a flat square has one normal.
#
# ## The formula
#
# $$ I = I_L\, k_d \cos\theta = I_L\, k_d\, (\mathbf{N} \cdot \mathbf{L}) $$
#
# $I_L$ is the light's intensity, $k_d \in [0, 1]$ the share of the light that the surface reflects diffusely, $\theta$
# the angle between the unit normal $\mathbf{N}$ and the unit vector $\mathbf{L}$ towards the light. With unit vectors the
# cosine is a dot product. In the shader that drew the squares it is one line, and in NumPy it is another:

# %%
glsim.source("shaders/light.glsl", "color += strength * face.k_d.rgb")

# %%
glsim.source("shading/terms.py", "def lambert", lines=3)

# %% [markdown]
# ## The proof
#
# Why the cosine, and no other curve? Because of a right-angled triangle.

# %% A beam of one width lights a longer footprint the flatter it falls
glsim.plots.cosine_law()

# %% [markdown]
# A beam has the width $w$ and carries some power per metre of depth. Where it falls straight, it lights a strip of width
# $w$. Where it falls at the angle $\theta$, the strip on the surface is the hypotenuse of a triangle in which $w$ is the
# side next to $\theta$:
#
# $$ \cos\theta = \frac{w}{w'} \quad\Rightarrow\quad w' = \frac{w}{\cos\theta} $$
#
# The same power on $1/\cos\theta$ times the area: each square metre gets $\cos\theta$ of what it got before. At 60° the
# strip is twice as wide, so the light is half. That is the whole proof.
#
# The material plays no part in it: the cosine is about light that *arrives*. Lambert's second assumption is about the
# light that *leaves*: it looks equally bright from everywhere.

# %% Lambert's law as a curve, clamped where the light is behind the surface
glsim.plots.lambert()

# %% [markdown]
# ## On a ball
#
# A ball has every normal, so it shows the whole curve at once: bright where $N$ points along $L$, black from 90° on.

# %% N and L at one point of a ball, with the angle between them
from glsim.glut import glutSolidSphere


def ball():
    glClearColor(0.1, 0.11, 0.14, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    for capability in (GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0):
        glEnable(capability)
    glShadeModel(GL_PHONG_WIN)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [0.9, 0.9, 0.85, 1])
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(-1, 1, -1, 1, -1, 1)  # else z would grow away from the eye
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 1.2, 0])
    glutSolidSphere(0.8, 60, 60)


glsim.show(
    ball,
    still=glsim.vectors(ball, 300, 170),
    point=(300, 170),
    controls="lights.position, lights.diffuse, materials.diffuse",
)

# %% [markdown]
# ## Try this
#
# 1. Set the light's direction to `[0, 1, 1, 0]`. Which square is the brightest now?
# 2. Set `glNormal3f(0, 0, 1)` to `glNormal3f(0, 0, 2)`. The picture changes. Should it?
# 3. Move `w` of the position from 0 to 1. Why is a square no longer uniform, or why does it stay so?

# %% [markdown]
# ## Questions
#
# At which angle has a surface lost 1 % of its brightness?
#
# <details><summary>Answer</summary>
#
# At $\arccos 0.99 \approx 8.1°$. The cosine is flat at its top: small errors of a normal hardly show there, and show most
# where $\theta$ is near 90°.
#
# </details>
#
# > **The slide says** "reflected intensity depends only on the direction of the light source". It depends on the
# > direction *relative to the normal*, and on nothing else: not on the eye.
#
# ## Exercise
#
# Exercise 3 (lesson 7): write `lambert(N, L)`.
