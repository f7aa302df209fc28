// Numbers for rasterization and for what happens to a fragment afterwards.

layout(std140) uniform Raster {
    vec4 fog_color;             // glFog
    vec4 fog;                   // density, start, end; w: reference value of glAlphaFunc
    vec4 clip_planes[6];        // glClipPlane, in eye space
    vec4 point;                 // glPointSize, smallest and largest size, fade threshold
    vec4 point_attenuation;     // a, b, c of 1 / sqrt(a + b d + c d^2)
    vec4 viewport;              // x, y, width, height in pixels
    vec4 line;                  // glLineWidth; glLineStipple's factor and pattern; w: see glsim.render.lines.margin
    uvec4 polygon_stipple[8];   // 32 rows, bottom first
    vec4 rectangle_origin;      // x, y: lower left pixel of a pixel rectangle; z: number of the draw, for a probe
};
