// A fragment of a line: where in the line it is, whether the stipple pattern draws it, and how much of its pixel a
// smooth line covers (OpenGL 1.5 sections 3.4.2 and 3.4.4).  ends: both ends of the line in pixels, see line.glsl.

flat in vec4 line_ends;         // only if WIDE_LINES or LINE_STIPPLE
flat in float line_pixels;      // only if LINE_STIPPLE: pixels of the pattern before the line

// glLineStipple: whether a pixel is drawn; bit 0 of the pattern comes first, each bit for `factor` pixels
bool line_pattern(float pixels)
{
    int bit = int(floor(pixels / line_stipple_factor)) & 15;
    return ((line_stipple_pattern >> bit) & 1u) == 1u;
}

// Distance in pixels from the line's first end: along x or y, the line's major axis; for a smooth line along the line
float along_line(vec4 ends, vec2 pixel)
{
    vec2 direction = ends.zw - ends.xy, from = pixel - ends.xy;
    if (SMOOTH_LINES) return direction == vec2(0.0) ? from.x : dot(from, normalize(direction));
    return abs(direction.x) >= abs(direction.y) ? from.x * sign(direction.x) : from.y * sign(direction.y);
}

// The whole line's length, measured in the same way
float line_length(vec4 ends)
{
    vec2 size = abs(ends.zw - ends.xy);
    return SMOOTH_LINES ? length(size) : max(size.x, size.y);
}

// The number of a fragment, counted from the line's first end
float fragment_number(vec4 ends, vec2 pixel)
{
    float at = along_line(ends, pixel);
    return max(WIDE_LINES ? floor(at) : ceil(at - 0.5), 0.0);   // wide: unit steps along it; thin: pixel centres
}

// Whether clipping has cut a fragment of a wide line off; 1/256 pixel is as exact as rasterization is
bool beyond_ends(vec4 ends, vec2 pixel)
{
    float at = along_line(ends, pixel);
    return at < -1.0 / 256.0 || at > line_length(ends) + 1.0 / 256.0;
}

// Whether to discard the fragment at this pixel: clipping has cut it off, or the stipple pattern leaves it out
bool line_leaves_out(vec2 pixel)
{
    if (WIDE_LINES && beyond_ends(line_ends, pixel)) return true;
    return LINE_STIPPLE && !line_pattern(line_pixels + fragment_number(line_ends, pixel));
}

// A smooth line is a rectangle, of which the pattern draws some pieces: how much of the pixel it covers, in [0, 1]
float line_coverage(vec4 ends, vec2 pixel, float begin)
{
    vec2 direction = ends.zw - ends.xy, from = pixel - ends.xy;
    direction = direction == vec2(0.0) ? vec2(1.0, 0.0) : normalize(direction);
    float along = dot(from, direction), across = dot(from, vec2(-direction.y, direction.x));
    float half_length = 0.5 * line_length(ends);
    float covered = clamp(half_length + 0.5 - abs(along - half_length), 0.0, 1.0);
    if (LINE_STIPPLE) {     // the pixel reaches from low to high; between them a piece may end
        float low = max(along - 0.5, 0.0), high = min(along + 0.5, line_length(ends)), next = floor(low) + 1.0;
        covered = line_pattern(begin + floor(low)) ? max(min(high, next) - low, 0.0) : 0.0;
        if (high > next && line_pattern(begin + next)) covered += high - next;
    }
    return covered * clamp(0.5 * line_width + 0.5 - abs(across), 0.0, 1.0);
}
