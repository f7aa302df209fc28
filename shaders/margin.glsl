// OpenGL clips points and wide lines as if they had no extent, and then lets them reach beyond the viewport (OpenGL 1.5
// section 2.11).  So the driver is given a viewport that is larger than the program's by a margin on all sides, and
// what is drawn shrinks as much: it covers the same pixels as in the program's viewport.

const vec4 OUTSIDE = vec4(2.0, 2.0, 2.0, 1.0);  // a position beyond the clip volume: the primitive is not drawn

vec4 with_margin(vec4 C)    // C: in clip space
{
    C.xy *= viewport.zw / (viewport.zw + 2.0 * viewport_margin);
    return C;
}
