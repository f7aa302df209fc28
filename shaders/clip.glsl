// glClipPlane: parts with a negative distance from an enabled plane are clipped; wide lines are clipped in line.glsl

#if CLIPPING
out float gl_ClipDistance[6];

void clip(vec4 P)   // P: in eye space
{
    for (int i = 0; i < 6; i++)
        gl_ClipDistance[i] = CLIP_PLANE[i] && !WIDE_LINES ? dot(clip_planes[i], P) : 1.0;
}
#endif
