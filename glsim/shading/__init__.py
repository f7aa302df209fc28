"""The lecture's illumination equation in NumPy: float64, vectorised, term by term.

Vectors are arrays (..., 3), colours (..., 3) or (..., 4), scalars (..., 1); everything broadcasts.

    terms     the factors: Lambert's cosine, R and H, the two highlights, attenuation, spotlight, Snell, Fresnel
    equation  their sum over lights, as OpenGL evaluates it: illuminate
    brdf      reflectance distribution functions, for the lecture's advanced concepts
"""

from glsim.shading.brdf import BRDF as BRDF
from glsim.shading.brdf import BlinnPhong as BlinnPhong
from glsim.shading.brdf import CookTorrance as CookTorrance
from glsim.shading.brdf import Lambertian as Lambertian
from glsim.shading.brdf import NormalizedPhong as NormalizedPhong
from glsim.shading.brdf import Phong as Phong
from glsim.shading.equation import Contribution as Contribution
from glsim.shading.equation import Illumination as Illumination
from glsim.shading.equation import Surface as Surface
from glsim.shading.equation import illuminate as illuminate
from glsim.shading.terms import ambient as ambient
from glsim.shading.terms import attenuation as attenuation
from glsim.shading.terms import blinn_torrance_specular as blinn_torrance_specular
from glsim.shading.terms import clamp as clamp
from glsim.shading.terms import diffuse as diffuse
from glsim.shading.terms import dot as dot
from glsim.shading.terms import fresnel as fresnel
from glsim.shading.terms import fresnel_schlick as fresnel_schlick
from glsim.shading.terms import halfway as halfway
from glsim.shading.terms import lambert as lambert
from glsim.shading.terms import normalize as normalize
from glsim.shading.terms import phong_specular as phong_specular
from glsim.shading.terms import power as power
from glsim.shading.terms import reflection as reflection
from glsim.shading.terms import refraction as refraction
from glsim.shading.terms import spotlight as spotlight
from glsim.shading.terms import towards_light as towards_light
