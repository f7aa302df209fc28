// Reasons to discard a fragment: the stipple pattern of polygons and the alpha test.

// glPolygonStipple: 32 x 32 pixels, repeated over the window; the leftmost is the highest bit
bool polygon_pattern(vec2 pixel)
{
    int row = int(pixel.y) & 31;
    uint bits = polygon_stipple[row / 4][row & 3];
    return ((bits >> (31 - (int(pixel.x) & 31))) & 1u) == 1u;
}

// glAlphaFunc: the reference value is compared with an 8-bit alpha
bool alpha_test(float alpha)
{
    float a = floor(alpha * 255.0 + 0.5), reference = floor(alpha_reference * 255.0 + 0.5);
    if (ALPHA_FUNC == GL_NEVER) return false;
    if (ALPHA_FUNC == GL_LESS) return a < reference;
    if (ALPHA_FUNC == GL_EQUAL) return a == reference;
    if (ALPHA_FUNC == GL_LEQUAL) return a <= reference;
    if (ALPHA_FUNC == GL_GREATER) return a > reference;
    if (ALPHA_FUNC == GL_NOTEQUAL) return a != reference;
    if (ALPHA_FUNC == GL_GEQUAL) return a >= reference;
    return true;
}
