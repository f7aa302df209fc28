// For glsim.probe and glsim.terms: which primitive a fragment belongs to, where in it, and what its textures gave.

#if PROBE
layout(location = 1) out vec4 probe_place;      // the primitive's vertices are red, green and blue: their weights; coverage
layout(location = 2) out vec4 probe_primitive;  // number of the draw and of the primitive, 1 front or -1 back, fog distance
layout(location = 3) out vec4 probe_texels[4];

void probe(float covered)
{
    probe_place = vec4(front_color.rgb, covered);
    probe_primitive = vec4(rectangle_origin.z, float(gl_PrimitiveID), gl_FrontFacing ? 1.0 : -1.0,
        FOG != FOG_OFF ? fog_distance : 0.0);
    for (int unit = 0; unit < 4; unit++) {
#if TEXTURES
        probe_texels[unit] = texels[unit];
#else
        probe_texels[unit] = vec4(0.0);
#endif
    }
}
#endif
