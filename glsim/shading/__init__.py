"""The lecture's illumination equation in NumPy: float64, vectorised, term by term.

Vectors are arrays (..., 3), colours (..., 3) or (..., 4); everything broadcasts.
"""

from glsim.shading.terms import attenuation as attenuation
from glsim.shading.terms import blinn_torrance_specular as blinn_torrance_specular
from glsim.shading.terms import lambert as lambert
from glsim.shading.terms import normalize as normalize
from glsim.shading.terms import phong_specular as phong_specular
from glsim.shading.terms import reflection as reflection
from glsim.shading.terms import spotlight as spotlight
