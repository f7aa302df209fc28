// glTexEnv: how a texel changes the fragment's colour (OpenGL 1.5, table 3.22).
// C: colour of the fragment, T: the texel.  An alpha texture has no colour, a luminance or RGB texture no alpha.

uniform sampler2D texture0;

vec4 texel(vec4 coordinates)
{
    vec2 st = coordinates.st / coordinates.q;
    if (TEXTURE_IS_1D) st.t = 0.5;
    if (CLAMP_S) st.s = clamp(st.s, 0.0, 1.0);     // GL_CLAMP: half of the border shows
    if (CLAMP_T) st.t = clamp(st.t, 0.0, 1.0);
    return texture(texture0, st);
}

vec4 textured(vec4 C, vec4 T)
{
    vec4 result = C;
    if (TEXENV == GL_REPLACE) {
        if (TEXTURE_HAS_COLOR) result.rgb = T.rgb;
        if (TEXTURE_HAS_ALPHA) result.a = T.a;
    }
    if (TEXENV == GL_MODULATE) {
        if (TEXTURE_HAS_COLOR) result.rgb = C.rgb * T.rgb;
        if (TEXTURE_HAS_ALPHA) result.a = C.a * T.a;
    }
    if (TEXENV == GL_DECAL && TEXTURE_HAS_COLOR)
        result.rgb = TEXTURE_HAS_ALPHA ? mix(C.rgb, T.rgb, T.a) : T.rgb;
    if (TEXENV == GL_BLEND) {
        if (TEXTURE_HAS_COLOR) result.rgb = mix(C.rgb, texenv_color.rgb, T.rgb);
        if (TEXTURE_HAS_ALPHA) result.a = TEXTURE_IS_INTENSITY ? mix(C.a, texenv_color.a, T.a) : C.a * T.a;
    }
    if (TEXENV == GL_ADD) {
        if (TEXTURE_HAS_COLOR) result.rgb = C.rgb + T.rgb;
        if (TEXTURE_HAS_ALPHA) result.a = TEXTURE_IS_INTENSITY ? C.a + T.a : C.a * T.a;
    }
    return clamp(result, 0.0, 1.0);
}
