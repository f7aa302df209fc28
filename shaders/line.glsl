// A wide line is a parallelogram: its ends are moved up and down if it is flatter than 45 degrees, else left and right.
// A: this end in clip space, B: the other end, side: -1 or 1.  (OpenGL 1.5 section 3.4.2)

vec2 on_screen(vec4 P, vec4 other)
{
    if (P.w <= 0.0) P = mix(P, other, (1e-4 - P.w) / (other.w - P.w));  // the visible part decides the direction
    return P.xy / P.w * viewport.zw;
}

vec4 widen(vec4 A, vec4 B, float side)
{
    vec2 direction = abs(on_screen(B, A) - on_screen(A, B));
    vec2 across = direction.x >= direction.y ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
    A.xy += side * line.x * across / viewport.zw * A.w;
    return A;
}
