// A fragment of a smooth point, which is a disc: how much of its pixel the disc covers (OpenGL 1.5 section 3.3).

flat in float point_diameter;   // in pixels; the square that is drawn is one pixel larger

float point_coverage(float diameter)
{
    float d = length(gl_PointCoord - 0.5) * (diameter + 1.0);    // pixels from the middle
    return clamp(0.5 * diameter + 0.5 - d, 0.0, 1.0);
}
