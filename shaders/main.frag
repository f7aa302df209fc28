// A fragment's colour.  Phong shading evaluates the illumination equation here, for every fragment, with the normal
// that is interpolated between the vertices and normalized again.

#include "state.glsl"
#include "material.glsl"
#include "light.glsl"
#include "raster.glsl"
#include "texture.glsl"
#include "pixels.glsl"
#include "fog.glsl"
#include "tests.glsl"
#include "line_fragment.glsl"
#include "point_fragment.glsl"

SHADED in vec4 front_color;
SHADED in vec3 front_highlight;
SHADED in vec4 back_color;
SHADED in vec3 back_highlight;

in vec3 eye_position;
in vec3 eye_normal;
in vec4 vertex_color;
in float fog_distance;
flat in uint object_row;

#if CLIPPING && defined(GL_ES)
in vec3 clip_distances[2];          // see clip.glsl
#endif

layout(location = 0) out vec4 fragment_color;

float covered = 1.0;    // how much of the pixel a smooth line or point covers; it multiplies the fragment's alpha

// Phong shading.  normal: what is interpolated between the unit normals of the vertices, and shorter than they are
void phong_shading(Face face, vec3 normal, vec3 P, out vec4 color, out vec3 highlight)
{
    vec3 N = normalize(normal);
    shade(face, N, P, color, highlight);
}

void main()
{
#if CLIPPING && defined(GL_ES)
    if (any(lessThan(min(clip_distances[0], clip_distances[1]), vec3(0.0)))) discard;
#endif
    if ((WIDE_LINES || LINE_STIPPLE) && !SMOOTH_LINES && line_leaves_out(gl_FragCoord.xy)) discard;
    if (POLYGON_STIPPLE && !polygon_pattern(gl_FragCoord.xy)) discard;

    // lighting: what the vertices computed, or for Phong shading the equation itself
    bool back = TWO_SIDE && AREAS && !gl_FrontFacing;
    vec4 color = back ? back_color : front_color;
    vec3 highlight = back ? back_highlight : front_highlight;
    if (LIGHTING && PER_FRAGMENT) {
        Material material = materials[object_row];
        Face face = track(material.front, vertex_color, FRONT_TRACKS);
        if (back) face = track(material.back, vertex_color, BACK_TRACKS);
        phong_shading(face, back ? -eye_normal : eye_normal, eye_position, color, highlight);
    }

#if PIXELS == PIXELS_COLOR
    color = pixel();
#elif PIXELS == PIXELS_DEPTH
    gl_FragDepth = pixel().r;
#elif PIXELS == PIXELS_BITMAP
    if (pixel().r == 0.0) discard;
#endif
#if TEXTURES
    color = textured(color, texture_coordinates);
#endif
    if (SEPARATE_SPECULAR || COLOR_SUM) color.rgb = min(color.rgb + highlight, 1.0);
    if (FOG != FOG_OFF) color.rgb = mix(fog_color.rgb, color.rgb, fog_factor(fog_distance));
    if (SMOOTH_LINES || POINT_SMOOTH) {
        if (SMOOTH_LINES) covered = line_coverage(line_ends, gl_FragCoord.xy, LINE_STIPPLE ? line_pixels : 0.0);
        else covered = point_coverage(point_diameter);
        if (covered == 0.0) discard;
        color.a *= covered;
    }
    if (ALPHA_FUNC != GL_ALWAYS && !alpha_test(color.a)) discard;
    fragment_color = color;
}
