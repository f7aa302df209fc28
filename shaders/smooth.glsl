// Antialiasing: how much of a pixel is covered, in [0, 1]; it multiplies the fragment's alpha.

// A rectangle around a line; place: pixels from its middle along and across
float line_coverage(vec2 place, vec2 half_size)
{
    vec2 inside = clamp(half_size + 0.5 - abs(place), 0.0, 1.0);
    return inside.x * inside.y;
}

// A disc
float point_coverage(float diameter)
{
    float d = length(gl_PointCoord - 0.5) * (diameter + 1.0);    // pixels from the middle
    return clamp(0.5 * diameter + 0.5 - d, 0.0, 1.0);
}
