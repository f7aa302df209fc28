// Points: where they are drawn and how large they are (OpenGL 1.5 section 3.3).

#include "margin.glsl"

flat out float point_diameter;      // only if POINT_SMOOTH: in pixels

// Drivers round a place to 1/256 of a pixel.  A point whose middle lies between two pixels belongs to the upper right
// one, so it is moved by such a step; a pixel is 2 / viewport in normalized device coordinates, hence the 2.  A middle
// that lies half-way between two steps must be rounded to the right and down, as the fixed function does: so the step
// is a little longer than 2 to the right and a little shorter than 2 upwards.
const vec2 STEP = vec2(2.002, 1.998) / 256.0;   // divided by the viewport's size: in normalized device coordinates

// glPointSize and glPointParameter: the diameter in pixels.  d: distance from the eye; section 3.3 allows |z| for it.
float point_diameter_at(float d)
{
    vec3 a = point_attenuation;
    float size = point_size * inversesqrt(a.x + a.y * d + a.z * d * d);
    size = clamp(size, point_size_min, point_size_max);
    return POINT_SMOOTH ? size : max(floor(size + 0.5), 1.0);
}

// Sets the point's size and returns its place.  E: in eye space; C: in clip space
vec4 point_vertex(vec4 E, vec4 C)
{
    gl_PointSize = point_diameter_at(abs(E.z));
    if (POINT_SMOOTH) {
        point_diameter = gl_PointSize;
        gl_PointSize += 1.0;                                    // half a pixel on all sides may be touched
    }
    if (any(greaterThan(abs(C.xy), vec2(C.w)))) return OUTSIDE; // its middle is clipped
    if (!POINT_SMOOTH) C.xy += STEP / viewport.zw * C.w;
    return with_margin(C);
}
