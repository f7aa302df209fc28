# %% [markdown]
# # 3. Object appearance and light transport
#
# You do not see a ball. You see the light that a lamp sent to the ball, that the ball did not swallow, and that happened
# to leave in the direction of your eye. Everything about appearance is in this journey, and it has three stations.

# %% [markdown]
# ## Predict
#
# A white, a grey and a black ball lie under the same lamp. The black one reflects 4 % of the light. Where does the rest
# go?
#
# - it is not there: black objects get less light
# - it goes through the ball
# - the ball swallows it, and gets warm

# %% The same light on surfaces that reflect 90 %, 40 % and 4 % of it
import glsim
from glsim.gl import *
from glsim.glut import glutSolidSphere

screen = glsim.offscreen(840, 280, samples=4)
glClearColor(0.22, 0.24, 0.28, 1)
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glShadeModel(GL_PHONG_WIN)
glLightModelfv(GL_LIGHT_MODEL_AMBIENT, [0, 0, 0, 1])
glLightfv(GL_LIGHT0, GL_POSITION, [-1, 1, 1.5, 0])
glMatrixMode(GL_PROJECTION)
glOrtho(-1, 1, -1, 1, -1, 1)
glMatrixMode(GL_MODELVIEW)
for column, share in enumerate((0.9, 0.4, 0.04)):
    glViewport(280 * column, 0, 280, 280)
    glMaterialfv(GL_FRONT, GL_DIFFUSE, [share, share, share, 1])
    glutSolidSphere(0.8, 64, 48)
screen

# %% [markdown]
# ## What you should see
#
# The same shape, the same shading, from dark to light: only the factor is another. On impact a part of the light is
# **reflected**, the rest is **absorbed** and becomes heat. The black ball is the warm one. (That both balls show the
# same shading tells that the reflectance is a factor, and nothing but a factor.)

# %% [markdown]
# ## The formula
#
# For an opaque surface the light that arrives is split in two, and nothing is lost:
#
# $$ \text{arriving} = \text{reflected} + \text{absorbed}, \qquad \text{reflected} = \rho \cdot \text{arriving}, \quad \rho \in [0, 1] $$
#
# The **reflectance** $\rho$ is a number per colour: a red apple reflects red and absorbs green and blue. In the local
# illumination model it appears as $k_d$ and $k_s$. *How* the reflected part is distributed over the directions decides
# about the **finish**: matte, glossy, mirror.

# %%
glsim.source("shaders/light.glsl", "color += strength * face.k_d.rgb")

# %% One shape, three finishes: matte, glossy, metallic. Light, shape and eye are the same
finishes = {"material": ["white-rubber", "pearl", "silver"]}
glsim.compare(
    "teapot", modes="phong", sweep=finishes, columns="material", size=300,
    samples=4, differences="off",
)  # fmt: skip

# %% [markdown]
# The journey of the light, station by station:
#
# 1. it is **emitted** by a light source;
# 2. it **interacts** with surfaces: reflected in part, absorbed in part, perhaps several times;
# 3. what arrives at the **camera** is the picture.
#
# A *local* model follows it over one surface only: lamp, surface, eye. A *global* one follows it from surface to
# surface. Here is what the difference looks like:

# %% The same room by a local model, and with light that bounces from wall to wall
glsim.compare("cornell", modes=["gouraud", "radiosity"], size=400, patches=300)

# %% [markdown]
# ## Try this
#
# 1. Give the balls $k_d = (0.9, 0.1, 0.05)$. Which light do they absorb?
# 2. Set a reflectance of 1.5. OpenGL accepts it; which law is broken?
# 3. Move the light behind the balls, `[0, 0, -1, 0]`. What arrives at the camera?
#
# ## Questions
#
# White paper in the shade is darker than black paper in the sun, if you measure. Why do we still see it as white?
#
# <details><summary>Answer</summary>
#
# The eye, or rather the brain, estimates the light and divides by it: it judges the *reflectance*, not the light that
# arrives. A renderer has to compute the light; the judging is left to whoever looks at the picture.
#
# </details>
#
# ## Exercise
#
# Exercise 2: reproduce a picture, in three styles.
