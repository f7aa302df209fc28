// A vertex's way from object space to the screen.
//
// Flat and Gouraud shading evaluate the illumination equation here; Phong shading passes what the equation needs on
// to main.frag.  Constants in CAPITALS stand in front of this text: they are the part of the state that chooses code.

#include "state.glsl"
#include "material.glsl"
#include "light.glsl"
#include "raster.glsl"
#include "clip.glsl"
#include "line.glsl"
#include "point.glsl"
#include "texgen.glsl"

in vec3 position;
in float position_w;        // only if HAS_W; else 1
in vec3 normal;
in vec4 color;              // not if OBJECT_COLOR: then all vertices have the colour of their object
in vec4 secondary_color;    // only if COLOR_SUM
in float fog_coord;         // only if FOG_COORDINATE
in float depth_offset;      // only if DEPTH_OFFSET: in window coordinates
in vec4 lit_position;       // only if LIT_ELSEWHERE: where the equation is evaluated, in object space
in uint object;             // only if MANY_OBJECTS: the row of transforms and materials that this vertex uses

SHADED out vec4 front_color;        // flat or smooth: glShadeModel
SHADED out vec3 front_highlight;
SHADED out vec4 back_color;         // only with two-sided lighting
SHADED out vec3 back_highlight;

out vec3 eye_position;              // only if the equation runs per fragment
out vec3 eye_normal;
out vec4 vertex_color;
out float fog_distance;             // only with fog
flat out uint object_row;

void main()
{
    object_row = MANY_OBJECTS ? object : 0u;
    Transform transform = transforms[object_row];
    Material material = materials[object_row];

    // transform
    vec4 P = vec4(position, HAS_W ? position_w : 1.0);          // in object space
    vec4 E = transform.modelview * P;                           // in eye space
    vec4 C = transform.modelview_projection * P;                // in clip space
    if (DEPTH_OFFSET) C.z += 2.0 * depth_offset * C.w;
    if (WIDE_LINES || LINE_STIPPLE) C = line_vertex(transform, P, C);
    if (POINTS) C = point_vertex(E, C);
    float w = AFFINE ? C.w : 1.0;                               // divided by w here, all is equally far from the eye,
    gl_Position = C / w;                                        // and values are interpolated linearly on the screen
#if CLIPPING
    clip(E / w);
#endif
    if (FOG != FOG_OFF) fog_distance = FOG_COORDINATE ? fog_coord : abs(E.z);

    vec3 N = transform.normal * normal;                         // in eye space
    if (NORMALIZE) N = normalize(N);
    else if (RESCALE_NORMAL) N *= inversesqrt(dot(transform.normal[2], transform.normal[2]));
#if TEXTURES
    texture_vertex(transform, P, E, N);
#endif

    // colour
    vec4 own_color = OBJECT_COLOR ? material.color : color;
    front_color = back_color = vertex_color = clamp(own_color, 0.0, 1.0);
    front_highlight = back_highlight = COLOR_SUM ? clamp(secondary_color.rgb, 0.0, 1.0) : vec3(0.0);
    if (!LIGHTING) return;

    // lighting
    if (LIT_ELSEWHERE) E = transform.modelview * lit_position;
    eye_position = E.xyz / E.w;
    eye_normal = N;
    vertex_color = own_color;
    if (PER_FRAGMENT) return;                                   // Phong shading: main.frag goes on

    shade(track(material.front, own_color, FRONT_TRACKS), N, eye_position, front_color, front_highlight);
    if (TWO_SIDE)
        shade(track(material.back, own_color, BACK_TRACKS), -N, eye_position, back_color, back_highlight);
}
