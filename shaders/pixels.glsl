// glDrawPixels, glCopyPixels and glBitmap: a fragment takes its colour, depth or bit from a rectangle of pixels.

#if PIXELS != PIXELS_NONE
uniform sampler2D rectangle;

vec4 pixel()
{
    return texelFetch(rectangle, ivec2(gl_FragCoord.xy) - ivec2(rectangle_origin), 0);
}
#endif
