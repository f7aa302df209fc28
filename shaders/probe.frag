// For glsim.probe and glsim.terms, in place of main.frag: the same fragment, which also tells which primitive it
// belongs to, where in the primitive it is, and what its textures gave.  Students need not read this file.

#define main draw_fragment
#include "main.frag"
#undef main

layout(location = 1) out vec4 probe_place;     // rgb: weights of the three vertices; a: coverage of the pixel
layout(location = 2) out vec4 probe_primitive; // number of the draw, of the primitive; 1 front, -1 back; fog distance
layout(location = 3) out vec4 probe_texels[4];

void main()
{
    draw_fragment();
    probe_place = vec4(front_color.rgb, covered);
    probe_primitive = vec4(probe_number, float(gl_PrimitiveID), gl_FrontFacing ? 1.0 : -1.0,
        FOG != FOG_OFF ? fog_distance : 0.0);
    for (int unit = 0; unit < 4; unit++) {
#if TEXTURES
        probe_texels[unit] = texels[unit];
#else
        probe_texels[unit] = vec4(0.0);
#endif
    }
}
