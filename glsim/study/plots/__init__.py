"""``glsim.plots``: the curves, lobes, matrices and ray diagrams of the lecture, drawn by matplotlib.

Each function returns a Plot: shown in Jupyter, written by ``save("name.svg")`` or ``save("name.png")``, with ``alt`` as
its description in words and ``figure`` for whoever wants to change it.  Needs ``pip install 'glsim[course]'``.
"""

from glsim.study.plots.curves import MEDIA as MEDIA
from glsim.study.plots.curves import attenuation as attenuation
from glsim.study.plots.curves import curves as curves
from glsim.study.plots.curves import fog as fog
from glsim.study.plots.curves import form_factor_angle as form_factor_angle
from glsim.study.plots.curves import form_factor_distance as form_factor_distance
from glsim.study.plots.curves import fresnel as fresnel
from glsim.study.plots.curves import highlights as highlights
from glsim.study.plots.curves import interpolation as interpolation
from glsim.study.plots.curves import lambert as lambert
from glsim.study.plots.curves import powers as powers
from glsim.study.plots.curves import residuals as residuals
from glsim.study.plots.curves import snell as snell
from glsim.study.plots.curves import spot as spot
from glsim.study.plots.diagrams import computing_r as computing_r
from glsim.study.plots.diagrams import cosine_law as cosine_law
from glsim.study.plots.diagrams import halfway as halfway
from glsim.study.plots.diagrams import nusselt as nusselt
from glsim.study.plots.diagrams import reflection as reflection
from glsim.study.plots.diagrams import refraction as refraction
from glsim.study.plots.lobes import blinn_term as blinn_term
from glsim.study.plots.lobes import lobes as lobes
from glsim.study.plots.lobes import phong_term as phong_term
from glsim.study.plots.matrices import matrix as matrix
from glsim.study.plots.matrices import system as system
from glsim.study.plots.matrices import system_of as system_of
from glsim.study.plots.style import Plot as Plot
