// Where in a line a fragment is, and antialiasing: how much of a pixel is covered, in [0, 1]; it multiplies the
// fragment's alpha.

// glLineStipple: whether a pixel is drawn; bit 0 of the pattern comes first, each bit for `factor` pixels
bool line_pattern(float pixels)
{
    int bit = int(floor(pixels / line.y)) & 15;
    return ((uint(line.z) >> bit) & 1u) == 1u;
}

// Pixels from the line's first end: the coordinate in which it is longer, for a smooth line its length
float along_line(vec4 ends, vec2 pixel)
{
    vec2 way = ends.zw - ends.xy, from = pixel - ends.xy;
    if (SMOOTH_LINES) return way == vec2(0.0) ? from.x : dot(from, normalize(way));
    return abs(way.x) >= abs(way.y) ? from.x * sign(way.x) : from.y * sign(way.y);
}

float line_length(vec4 ends)
{
    vec2 way = abs(ends.zw - ends.xy);
    return SMOOTH_LINES ? length(way) : max(way.x, way.y);
}

// The number of a fragment, counted from the line's first end
float line_fragment(vec4 ends, vec2 pixel)
{
    float at = along_line(ends, pixel);
    return max(WIDE_LINES ? floor(at) : ceil(at - 0.5), 0.0);   // pieces of the area, or the pixels of a thin line
}

// What of a wide line clipping has cut off; 1/256 pixel is as exact as rasterization is
bool beyond_ends(vec4 ends, vec2 pixel)
{
    float at = along_line(ends, pixel);
    return at < -1.0 / 256.0 || at > line_length(ends) + 1.0 / 256.0;
}

// A rectangle around a line, of which the pattern draws some pieces
float line_coverage(vec4 ends, vec2 pixel, float begin)
{
    vec2 way = ends.zw - ends.xy, from = pixel - ends.xy;
    way = way == vec2(0.0) ? vec2(1.0, 0.0) : normalize(way);
    float along = dot(from, way), across = dot(from, vec2(-way.y, way.x)), half_length = 0.5 * line_length(ends);
    float covered = clamp(half_length + 0.5 - abs(along - half_length), 0.0, 1.0);
    if (LINE_STIPPLE) {     // the pixel reaches from low to high; between them a piece may end
        float low = max(along - 0.5, 0.0), high = min(along + 0.5, line_length(ends)), next = floor(low) + 1.0;
        covered = line_pattern(begin + floor(low)) ? max(min(high, next) - low, 0.0) : 0.0;
        if (high > next && line_pattern(begin + next)) covered += high - next;
    }
    return covered * clamp(0.5 * line.x + 0.5 - abs(across), 0.0, 1.0);
}

// A disc
float point_coverage(float diameter)
{
    float d = length(gl_PointCoord - 0.5) * (diameter + 1.0);    // pixels from the middle
    return clamp(0.5 * diameter + 0.5 - d, 0.0, 1.0);
}
