// Lines that are wide, smooth or stippled.  First a line is clipped, then it gets its width (OpenGL 1.5 sections 2.11
// and 3.4.2).  The quad of a wide line reaches from end to end of the whole line, so that colours are interpolated as
// ever; line_fragment.glsl discards the fragments beyond the part that clipping leaves.

#include "margin.glsl"

in vec4 other_end;              // the line's other end, in object space
in vec2 line_corner;            // x: -1 at the line's first end, 1 at the second; y: -1 and 1 on its two sides
in float line_begin;            // only if LINE_STIPPLE: pixels of the pattern before the line

flat out vec4 line_ends;        // both ends of what clipping leaves of the line, in pixels: xy the first, zw the second
flat out float line_pixels;     // only if LINE_STIPPLE: pixels of the pattern before the line

// The part of a line that is inside, as numbers in [0, 1] from its first end to its second; x > y if nothing is.
// a, b: distances of the ends from a plane; what has a negative distance is outside.
void cut(inout vec2 part, float a, float b)
{
    if (a < 0.0 && b < 0.0) part.y = -1.0;
    else if (a < 0.0) part.x = max(part.x, a / (a - b));
    else if (b < 0.0) part.y = min(part.y, a / (a - b));
}

vec2 on_screen(vec4 C)          // clip space -> pixels
{
    return viewport.xy + (0.5 * C.xy / C.w + 0.5) * viewport.zw;
}

// Whether clipping leaves something of the line from A to B, in clip space, and both ends of that in pixels.
// A_eye and B_eye: in eye space
bool visible(vec4 A, vec4 B, vec4 A_eye, vec4 B_eye, out vec4 ends)
{
    vec2 part = vec2(0.0, 1.0);
    for (int axis = 0; axis < 3; axis++) {
        cut(part, A.w + A[axis], B.w + B[axis]);
        cut(part, A.w - A[axis], B.w - B[axis]);
    }
#if CLIPPING
    for (int i = 0; i < 6; i++)
        if (CLIP_PLANE[i]) cut(part, dot(clip_planes[i], A_eye), dot(clip_planes[i], B_eye));
#endif
    ends.xy = on_screen(part.x > 0.0 ? mix(A, B, part.x) : A);
    ends.zw = on_screen(part.y < 1.0 ? mix(A, B, part.y) : B);
    return part.x <= part.y;
}

// A wide line is a parallelogram: its ends are moved up and down if it is flatter than 45 degrees, else left and right.
// A smooth line is a rectangle, half a pixel larger on all sides (section 3.4.4).
// C: one end in clip space; ends: see visible; corner: see line_corner
vec4 widen(vec4 C, vec4 ends, vec2 corner)
{
    vec2 direction = ends.zw - ends.xy, moved;
    if (SMOOTH_LINES) {
        direction = direction == vec2(0.0) ? vec2(1.0, 0.0) : normalize(direction);
        vec2 across = vec2(-direction.y, direction.x);
        moved = 0.5 * corner.x * direction + corner.y * (0.5 * line_width + 0.5) * across;
    }
    else {
        bool is_flat = abs(direction.x) >= abs(direction.y);
        moved = 0.5 * corner.y * line_width * (is_flat ? vec2(0.0, 1.0) : vec2(1.0, 0.0));
    }
    C.xy += moved * 2.0 / viewport.zw * C.w;
    return C;
}

// Where this vertex of a line is drawn.  P: in object space; C: in clip space
vec4 line_vertex(Transform transform, vec4 P, vec4 C)
{
    if (LINE_STIPPLE) line_pixels = line_begin;
    bool is_first = line_corner.x < 0.0;
    vec4 A = is_first ? P : other_end, B = is_first ? other_end : P;
    mat4 to_clip = transform.modelview_projection, to_eye = transform.modelview;
    if (!visible(to_clip * A, to_clip * B, to_eye * A, to_eye * B, line_ends)) return OUTSIDE;
    return WIDE_LINES ? with_margin(widen(C, line_ends, line_corner)) : C;
}
