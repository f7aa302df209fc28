// State that rasterization, clipping, fog and the per-fragment operations read.

layout(std140) uniform Raster {
    vec4 fog_color;                 // glFog
    float fog_density;
    float fog_start;
    float fog_end;
    float alpha_reference;          // glAlphaFunc
    vec4 clip_planes[6];            // glClipPlane, in eye space
    float point_size;               // glPointSize
    float point_size_min;           // glPointParameter
    float point_size_max;
    float point_fade_threshold;     // not used: it would fade points under multisampling
    vec3 point_attenuation;         // a, b, c of 1 / sqrt(a + b d + c d^2)
    vec4 viewport;                  // glViewport: x, y, width, height in pixels
    float line_width;               // glLineWidth, in pixels
    float line_stipple_factor;      // glLineStipple
    uint line_stipple_pattern;      // its lowest 16 bits
    float viewport_margin;          // pixels, see margin.glsl
    uvec4 polygon_stipple[8];       // glPolygonStipple: 32 rows, bottom first
    vec2 rectangle_origin;          // lower left pixel of a pixel rectangle
    float probe_number;             // number of the draw, for probe.frag
};
