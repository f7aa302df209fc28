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
#include "texgen.glsl"

in vec3 position;
in float position_w;        // only if HAS_W; else 1
in vec3 normal;
in vec4 color;              // not if OBJECT_COLOR: then all vertices have the colour of their object
in vec4 secondary_color;    // only if COLOR_SUM
in float fog_coord;         // only if FOG_COORDINATE
in vec4 texcoord0;          // only if that unit is in use
in vec4 texcoord1;
in vec4 texcoord2;
in vec4 texcoord3;
in float depth_offset;      // only if DEPTH_OFFSET: in window coordinates
in vec4 lit_position;       // only if LIT_ELSEWHERE: where the equation is evaluated, in object space
in uint object;             // only if MANY_OBJECTS: the row of transforms and materials that this vertex uses
in vec4 other_end;          // only if WIDE_LINES or LINE_STIPPLE: the line's other end, in object space
in vec2 line_corner;        // only then: -1 at the line's first end, 1 at the second; the same for both sides
in float line_begin;        // only if LINE_STIPPLE: pixels of the pattern before the line

SHADED out vec4 front_color;        // SHADED is flat or smooth: glShadeModel
SHADED out vec3 front_highlight;
SHADED out vec4 back_color;         // only with two-sided lighting
SHADED out vec3 back_highlight;

out vec3 eye_position;              // only if the equation runs per fragment
out vec3 eye_normal;
out vec4 vertex_color;
#if TEXTURES
out vec4 texture_coordinates[4];
#endif
out float fog_distance;             // only with fog
flat out vec4 line_ends;            // only if WIDE_LINES or LINE_STIPPLE: in pixels, of what clipping leaves of the line
flat out float line_pixels;         // only if LINE_STIPPLE: pixels of the pattern before the line
flat out float point_diameter;      // only if POINT_SMOOTH
flat out uint object_row;

const vec4 OUTSIDE = vec4(2.0, 2.0, 2.0, 1.0);    // of the clip volume: nothing is drawn

vec4 project(Transform transform, vec4 P)
{
    vec4 Q = transform.modelview_projection * P;
    if (WIDE_LINES || LINE_STIPPLE) {
        bool is_first = line_corner.x < 0.0;
        vec4 A = is_first ? P : other_end, B = is_first ? other_end : P;
        mat4 to_clip = transform.modelview_projection, to_eye = transform.modelview;
        if (!visible(to_clip * A, to_clip * B, to_eye * A, to_eye * B, line_ends)) return OUTSIDE;
        if (WIDE_LINES) Q = widen(Q, line_ends, line_corner);
    }
    if (DEPTH_OFFSET) Q.z += 2.0 * depth_offset * Q.w;
    if (POINTS) {
        if (any(greaterThan(abs(Q.xy), vec2(Q.w)))) return OUTSIDE;     // its middle is clipped
        if (!POINT_SMOOTH) Q.xy += vec2(2.002, 1.998) / 256.0 / viewport.zw * Q.w;      // between two pixels: up and to the right
    }
    if (POINTS || WIDE_LINES) Q.xy *= viewport.zw / (viewport.zw + 2.0 * line.w);       // the driver's viewport has a margin
    return Q;
}

// glPointSize and glPointParameter; d: distance from the eye, or nearly (section 3.3 allows |z|)
float point_size(float d)
{
    vec3 a = point_attenuation.xyz;
    float size = clamp(point.x * inversesqrt(a.x + a.y * d + a.z * d * d), point.y, point.z);
    return POINT_SMOOTH ? size : max(floor(size + 0.5), 1.0);
}

void main()
{
    object_row = MANY_OBJECTS ? object : 0u;
    Transform transform = transforms[object_row];
    Material material = materials[object_row];
    vec4 P = vec4(position, HAS_W ? position_w : 1.0);  // in object space
    vec4 E = transform.modelview * P;                   // in eye space
    gl_Position = project(transform, P);

    vec4 own_color = OBJECT_COLOR ? material.color : color;
    front_color = back_color = vertex_color = clamp(own_color, 0.0, 1.0);
    front_highlight = back_highlight = COLOR_SUM ? clamp(secondary_color.rgb, 0.0, 1.0) : vec3(0.0);
    if (LINE_STIPPLE) line_pixels = line_begin;

#if CLIPPING
    clip(E);
#endif
    if (POINTS) gl_PointSize = point_size(abs(E.z));
    if (POINT_SMOOTH) {
        point_diameter = gl_PointSize;
        gl_PointSize += 1.0;                            // half a pixel on all sides may be touched
    }
    if (FOG != FOG_OFF) fog_distance = FOG_COORDINATE ? fog_coord : abs(E.z);

    vec3 N = transform.normal * normal;
    if (NORMALIZE) N = normalize(N);
    else if (RESCALE_NORMAL) N *= inversesqrt(dot(transform.normal[2], transform.normal[2]));

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
    if (!LIGHTING) return;

    if (LIT_ELSEWHERE) E = transform.modelview * lit_position;
    eye_position = E.xyz / E.w;
    eye_normal = N;
    vertex_color = own_color;
    if (PER_FRAGMENT) return;

    shade(track(material.front, own_color, FRONT_TRACKS), N, eye_position, front_color, front_highlight);
    if (TWO_SIDE)
        shade(track(material.back, own_color, BACK_TRACKS), -N, eye_position, back_color, back_highlight);
}
