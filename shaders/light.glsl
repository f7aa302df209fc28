// The illumination equation: OpenGL 1.5 section 2.14.1, the lecture's sum over all lights
//
//     I = emission + k_a I_a,scene
//         + sum of  attenuation * spot * ( k_a I_a,light + k_d I_d (N.L) + k_s I_s (N.H)^n )
//
// There are two ambient intensities: I_a,scene is the glow that is everywhere, the I_a of the lecture; I_a,light is
// what each light adds to it.  N: unit normal, P: the point, both in eye space.  The highlight is returned apart,
// because it may be added after texturing (GL_SEPARATE_SPECULAR_COLOR).

#include "specular.glsl"

// How much weaker the light is at distance d: 1 / (k_0 + k_1 d + k_2 d^2)
float attenuation(Light light, float d)
{
    return 1.0 / (light.constant_attenuation + light.linear_attenuation * d + light.quadratic_attenuation * d * d);
}

// The spotlight factor: inside the cone cos^exponent of the angle between the axis and -L, outside the cone 0
float spotlight(Light light, vec3 L)
{
    float cosine = dot(-L, light.spot_direction);
    if (cosine < light.cos_spot_cutoff) return 0.0;
    return power(cosine, light.spot_exponent);
}

void illuminate(Face face, vec3 N, vec3 P, out vec3 color, out vec3 highlight)
{
    vec3 V = LOCAL_VIEWER ? normalize(-P) : vec3(0.0, 0.0, 1.0);    // towards the eye
    color = face.emission.rgb + face.k_a.rgb * I_a_scene.rgb;
    highlight = vec3(0.0);

    for (int i = 0; i < LIGHTS; i++) {
        Light light = lights[LIGHT_NUMBER[i]];
        vec3 L = light.position.xyz;                                // towards the light
        float strength = 1.0;
        if (LIGHT_IS_POSITIONAL[i]) {
            L -= P;
            float d = length(L);
            L = d > 0.0 ? L / d : vec3(0.0);
            if (LIGHT_IS_ATTENUATED[i]) strength = attenuation(light, d);
        }
        if (LIGHT_IS_SPOT[i]) strength *= spotlight(light, L);

        float side = FLIP_NORMAL && dot(N, L) < 0.0 ? -1.0 : 1.0;   // FLIP_NORMAL: where N.L < 0, N becomes -N
        float N_L = side * dot(N, L);
        color += strength * face.k_a.rgb * light.I_a.rgb;           // I_a,light
        if (N_L > 0.0) {                                            // else the light is behind the surface
            color += strength * face.k_d.rgb * light.I_d.rgb * N_L;
            highlight += strength * face.k_s.rgb * light.I_s.rgb * specular(side * N, L, V, face.n);
        }
    }
}

// The colour and the highlight of one side of the surface, clamped to [0, 1]: a screen cannot show more than 1
void shade(Face face, vec3 N, vec3 P, out vec4 color, out vec3 highlight)
{
    illuminate(face, N, P, color.rgb, highlight);
    if (!SEPARATE_SPECULAR) {
        color.rgb += highlight;
        highlight = vec3(0.0);
    }
    color = clamp(vec4(color.rgb, face.k_d.a), 0.0, 1.0);
    highlight = clamp(highlight, 0.0, 1.0);
}
