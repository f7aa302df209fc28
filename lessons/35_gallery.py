# %% [markdown]
# # 35. Gallery: factory and museum
#
# Everything comes together: rooms with lamps of real size, light that bounces until it is absorbed, and at the end
# nothing but coloured triangles, which the oldest OpenGL draws as fast as it can count.

# %% [markdown]
# ## Predict
#
# The radiosity of a hall takes seconds to solve. You now walk through the hall: the camera moves, the lamps and the
# walls stay. How much of the work must be done again for each picture?
#
# - all of it: each camera sees other light
# - the last gathering, at the vertices that are seen
# - nothing: only the triangles are drawn again

# %% One solution of the factory, two cameras
import numpy as np

import glsim
from glsim import radiosity
from glsim.gl import *
from glsim.glu import gluLookAt, gluPerspective
from glsim.pictures import tiles

hall = radiosity.solve("factory", patches=700)
tiles("", [[(f"camera {k}", np.asarray(hall.picture(460, k))) for k in (0, 1)]], 460)

# %% [markdown]
# ## What you should see
#
# Two cameras, one light. Diffuse surfaces look equally bright from everywhere, so the radiosity at a vertex is the
# same number for every camera: the solution is *view-independent*, an **object space** algorithm. Only the drawing is
# done again. (Ray tracing is the other way round: it computes what this one camera sees.)

# %% [markdown]
# ## The formula
#
# At each vertex the light of all patches is gathered once more, and the result becomes a colour:
#
# $$ B(x) = \rho \sum_j F_{xj} B_j, \qquad \mathrm{colour} = \left( \min(B / B_\mathrm{white},\, 1) \right)^{1/\gamma} $$
#
# $F_{xj}$ is the form factor from the point $x$ to patch $j$, $\rho$ the reflectance at $x$, $B_\mathrm{white}$ the
# radiosity that is shown as white, and $\gamma = 2.2$ undoes the screen's own curve. Storing that colour at the vertex
# is called **baking**; Gouraud's interpolation does the rest.

# %%
glsim.source("radiosity/view.py", "0, mesh.vertices.astype(np.float32)", lines=3)

# %% The baked hall, drawn by a program of OpenGL 1.1 that knows nothing of radiosity
hall.save("factory.npz")
baked = np.load("factory.npz")
colors = np.clip(baked["vertex_B"] / hall.shown_white, 0, 1) ** (1 / 2.2)

screen = glsim.offscreen(600, 450, samples=4)
glMatrixMode(GL_PROJECTION)
gluPerspective(60, 600 / 450, 0.1, 100)
glMatrixMode(GL_MODELVIEW)
view = hall.view(1)
gluLookAt(*view.eye, *view.target, 0, 1, 0)
glEnable(GL_DEPTH_TEST)
glEnable(GL_CULL_FACE)
glBegin(GL_TRIANGLES)
for vertex in baked["vertex_triangles"].ravel():
    glColor3fv(colors[vertex])
    glVertex3fv(baked["vertices"][vertex])
glEnd()
screen

# %% The museum: direct illumination and radiosity. Swap the pictures and watch the ceiling, the columns and the paintings
museum = radiosity.solve("museum", patches=600)
museum.beside_direct(440)

# %% [markdown]
# Daylight falls through deep shafts on the floor alone, and direct illumination leaves everything else black. The floor
# lights walls and ceiling from below, the walls light the paintings, and the red room tints what is near its door. The
# gilt column shows it all at once: each of its faces that looks down is lit by the floor.
#
# What radiosity does not do: mirrors and highlights (they depend on the eye), transparency, and moving lamps without a
# new solution. A ray tracer does these, and has trouble with exactly what is easy here.
#
# ## Try this
#
# 1. In the program multiply `colors` by `[1, 0.8, 0.6]`: evening. Which part of the pipeline did you change?
# 2. Replace `glBegin(GL_TRIANGLES)` by `glShadeModel(GL_FLAT)` and the same call: what was Gouraud's part?
# 3. `hall.save("factory.glb")` and open it in any viewer of glTF models.
#
# ## Questions
#
# A visitor opens a door and new light falls in. What must be computed again?
#
# <details><summary>Answer</summary>
#
# All of $B$, for light goes everywhere; but not all form factors: only those of pairs between which the door stood or
# stands now. And since light is linear, the light of the new opening can be solved by itself and added.
#
# </details>
#
# ## Exercise
#
# Exercise 31 (lesson 35): vertex colours from patches.
