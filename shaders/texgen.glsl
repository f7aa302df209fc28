// glTexGen: texture coordinates made from the vertex (OpenGL 1.5, section 2.11.4).
// P: in object space, E: in eye space, N: the normal in eye space.

#include "unit.glsl"

#if TEXTURES

in vec4 texcoord0;              // glMultiTexCoord; only of units in use
in vec4 texcoord1;
in vec4 texcoord2;
in vec4 texcoord3;

out vec4 texture_coordinates[4];

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

// Each unit's coordinates: given or generated, and multiplied by the texture matrix
void texture_vertex(Transform transform, vec4 P, vec4 E, vec3 N)
{
#if TEXTURE_0
    texture_coordinates[0] = transform.texture * generate(0, texcoord0, P, E, N);
#endif
#if TEXTURE_1
    texture_coordinates[1] = units[1].matrix * generate(1, texcoord1, P, E, N);
#endif
#if TEXTURE_2
    texture_coordinates[2] = units[2].matrix * generate(2, texcoord2, P, E, N);
#endif
#if TEXTURE_3
    texture_coordinates[3] = units[3].matrix * generate(3, texcoord3, P, E, N);
#endif
}

#endif
