// A wide line is a parallelogram: its ends are moved up and down if it is flatter than 45 degrees, else left and right.
// A: this end in clip space, B: the other end, side: -1 or 1.  (OpenGL 1.5 section 3.4.2)

vec2 on_screen(vec4 P, vec4 other)
{
    if (P.w <= 0.0) P = mix(P, other, (1e-4 - P.w) / (other.w - P.w));  // the visible part decides the direction
    return P.xy / P.w * viewport.zw;
}

// A smooth line is a rectangle, half a pixel larger on all sides, whose fragments are weighted by how much of them is
// inside (section 3.4.4).  place: pixels from the middle along and across; half_size: half of its length and width.
vec4 widen_smoothly(vec4 A, vec4 B, float side, out vec2 place, out vec2 half_size)
{
    vec2 outward = 0.5 * (on_screen(A, B) - on_screen(B, A));
    half_size = 0.5 * vec2(length(outward), line.x);
    outward = half_size.x > 0.0 ? normalize(outward) : vec2(1.0, 0.0);
    float end = outward.x > 0.0 || (outward.x == 0.0 && outward.y > 0.0) ? 1.0 : -1.0;
    vec2 across = end * vec2(-outward.y, outward.x);                        // the same at both ends
    place = vec2(end, side) * (half_size + 0.5);
    A.xy += (0.5 * outward + place.y * across) * 2.0 / viewport.zw * A.w;
    return A;
}

vec4 widen(vec4 A, vec4 B, float side)
{
    vec2 direction = abs(on_screen(B, A) - on_screen(A, B));
    vec2 across = direction.x >= direction.y ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    A.xy += side * line.x * across / viewport.zw * A.w;
    return A;
}
