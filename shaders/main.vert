// A vertex's way from object space to the screen.
//
// Flat and Gouraud shading evaluate the illumination equation here; Phong shading passes what the equation needs on
// to main.frag.  Constants in CAPITALS stand in front of this text: they are the part of the state that chooses code.

#include "state.glsl"
#include "material.glsl"
#include "light.glsl"

in vec3 position;
in float position_w;    // only if HAS_W; else 1
in vec3 normal;
in vec4 color;
uniform vec2 point_shift;   // only if POINTS: 1/256 of a pixel, in normalized device coordinates
in uint object;         // only if MANY_OBJECTS: the row of transforms and materials that this vertex uses

SHADED out vec4 front_color;        // SHADED is flat or smooth: glShadeModel
SHADED out vec3 front_highlight;
SHADED out vec4 back_color;         // only with two-sided lighting
SHADED out vec3 back_highlight;

out vec3 eye_position;              // only if the equation runs per fragment
out vec3 eye_normal;
out vec4 vertex_color;
flat out uint object_row;

void main()
{
    object_row = MANY_OBJECTS ? object : 0u;
    Transform transform = transforms[object_row];
    vec4 P = vec4(position, HAS_W ? position_w : 1.0);
    gl_Position = transform.modelview_projection * P;
    if (POINTS) gl_Position.xy += point_shift * gl_Position.w;  // between two pixels: up and to the right

    front_color = back_color = vertex_color = clamp(color, 0.0, 1.0);
    front_highlight = back_highlight = vec3(0.0);
    if (!LIGHTING) return;

    P = transform.modelview * P;
    vec3 N = transform.normal * normal;
    if (NORMALIZE) N = normalize(N);
    else if (RESCALE_NORMAL) N *= inversesqrt(dot(transform.normal[2], transform.normal[2]));

    eye_position = P.xyz / P.w;
    eye_normal = N;
    vertex_color = color;
    if (PER_FRAGMENT) return;

    Material material = materials[object_row];
    shade(track(material.front, color, FRONT_TRACKS), N, eye_position, front_color, front_highlight);
    if (TWO_SIDE)
        shade(track(material.back, color, BACK_TRACKS), -N, eye_position, back_color, back_highlight);
}
