// A fragment's colour.  Phong shading evaluates the illumination equation here, at every pixel, with the normal that
// was interpolated between the vertices and made unit length again.

#include "state.glsl"
#include "material.glsl"
#include "light.glsl"

SHADED in vec4 front_color;
SHADED in vec3 front_highlight;
SHADED in vec4 back_color;
SHADED in vec3 back_highlight;

in vec3 eye_position;
in vec3 eye_normal;
in vec4 vertex_color;
flat in uint object_row;

out vec4 fragment_color;

void main()
{
    bool back = TWO_SIDE && !gl_FrontFacing;
    vec4 color = back ? back_color : front_color;
    vec3 highlight = back ? back_highlight : front_highlight;

    if (LIGHTING && PER_FRAGMENT) {
        Material material = materials[object_row];
        vec3 N = normalize(eye_normal);
        if (back) shade(track(material.back, vertex_color, BACK_TRACKS), -N, eye_position, color, highlight);
        else shade(track(material.front, vertex_color, FRONT_TRACKS), N, eye_position, color, highlight);
    }

    if (SEPARATE_SPECULAR) color.rgb = min(color.rgb + highlight, 1.0);
    fragment_color = color;
}
