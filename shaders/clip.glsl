// glClipPlane: parts with a negative distance from an enabled plane are clipped; wide lines are clipped in line.glsl

#if CLIPPING
#ifdef GL_ES                    // has no gl_ClipDistance: main.frag discards what is outside
out vec3 clip_distances[2];
#else
out float gl_ClipDistance[6];
#endif

void clip(vec4 P)   // P: in eye space
{
    for (int i = 0; i < 6; i++) {
        float d = CLIP_PLANE[i] && !WIDE_LINES ? dot(clip_planes[i], P) : 1.0;
#ifdef GL_ES
        clip_distances[i / 3][i % 3] = d;
#else
        gl_ClipDistance[i] = d;
#endif
    }
}
#endif
