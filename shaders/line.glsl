// Lines that are wide, smooth or stippled.  First a line is clipped, then it gets its width (OpenGL 1.5 sections 2.11
// and 3.4.2).  The quad of a wide line reaches from end to end of the whole line, so that colours are interpolated as
// ever; fragments beyond the part that clipping leaves are discarded.

// The part of a line that is inside, as numbers in [0, 1] from its first end to its second; x > y if nothing is.
// a, b: distances of the ends from a plane; what has a negative distance is outside.
void cut(inout vec2 part, float a, float b)
{
    if (a < 0.0 && b < 0.0) part.y = -1.0;
    else if (a < 0.0) part.x = max(part.x, a / (a - b));
    else if (b < 0.0) part.y = min(part.y, a / (a - b));
}

vec2 on_screen(vec4 P)  // clip space -> pixels
{
    return viewport.xy + (0.5 * P.xy / P.w + 0.5) * viewport.zw;
}

// Whether something is left of the line from A to B, in clip space, and both ends of that in pixels.
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
// P: one end in clip space; ends: see visible; corner: x is -1 at the line's first end and 1 at the second, y the side
vec4 widen(vec4 P, vec4 ends, vec2 corner)
{
    vec2 way = ends.zw - ends.xy, moved;
    if (SMOOTH_LINES) {
        way = way == vec2(0.0) ? vec2(1.0, 0.0) : normalize(way);
        moved = 0.5 * corner.x * way + corner.y * (0.5 * line.x + 0.5) * vec2(-way.y, way.x);
    }
    else moved = 0.5 * corner.y * line.x * (abs(way.x) >= abs(way.y) ? vec2(0.0, 1.0) : vec2(1.0, 0.0));
    P.xy += moved * 2.0 / viewport.zw * P.w;
    return P;
}
