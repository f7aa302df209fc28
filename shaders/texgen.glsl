// glTexGen: texture coordinates made from the vertex (OpenGL 1.5, section 2.11.4).
// P: in object space, E: in eye space, N: the normal in eye space.

#include "unit.glsl"

#if TEXTURES

vec4 generate(int unit, vec4 given, vec4 P, vec4 E, vec3 N)
{
    vec4 result = given;
    vec3 u = normalize(E.xyz / E.w);            // from the eye to the vertex
    vec3 R = reflect(u, N);                     // u - 2 N (N.u)
    float m = 2.0 * length(R + vec3(0.0, 0.0, 1.0));
    for (int k = 0; k < 4; k++) {               // s, t, r, q
        int mode = TEXGEN[4 * unit + k];
        if (mode == GL_OBJECT_LINEAR) result[k] = dot(units[unit].object_plane[k], P);
        if (mode == GL_EYE_LINEAR) result[k] = dot(units[unit].eye_plane[k], E);
        if (mode == GL_SPHERE_MAP) result[k] = R[k] / m + 0.5;
        if (mode == GL_REFLECTION_MAP) result[k] = R[k];
        if (mode == GL_NORMAL_MAP) result[k] = N[k];
    }
    return result;
}

#endif
