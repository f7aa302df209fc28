// glTexEnv: how the texel of each unit changes the fragment's colour (OpenGL 1.5, tables 3.22 to 3.25).
// C: colour of the fragment, T: the texel.  An alpha texture has no colour, a luminance or RGB texture no alpha.

#include "unit.glsl"

#if TEXTURE_0
uniform SAMPLER_0 texture0;
#endif
#if TEXTURE_1
uniform SAMPLER_1 texture1;
#endif
#if TEXTURE_2
uniform SAMPLER_2 texture2;
#endif
#if TEXTURE_3
uniform SAMPLER_3 texture3;
#endif

#if TEXTURES

in vec4 texture_coordinates[4];

vec4 texels[4];         // what each unit reads
vec4 primary_color;     // the fragment's colour before texturing

// GL_CLAMP clamps s to [0, 1].  GL_LINEAR then mixes half of the border colour into the edge; GL_NEAREST must give the
// last texel at s = 1 (section 3.8.8), so the upper limit is the largest number below 1.  The mipmap level follows from
// the coordinate before clamping: hence textureGrad.
float wrapped(float s, int unit, int axis)
{
    return CLAMP[3 * unit + axis] ? clamp(s, 0.0, 0.99999994) : s;
}

// A depth is shown as GL_DEPTH_TEXTURE_MODE says
vec4 as_depth(float depth, int unit)
{
    if (!TEXTURE_HAS_COLOR[unit]) return vec4(0.0, 0.0, 0.0, depth);
    return vec4(vec3(depth), TEXTURE_IS_INTENSITY[unit] ? depth : 1.0);
}

#ifdef GL_ES
// What OpenGL ES lacks: a bias of the level, borders, cube maps whose faces know nothing of each other.

float level_scale(int unit)     // by which the bias makes derivatives larger
{
    return exp2(units[unit].lod_bias);
}

// How much of the filtered texel is inside of the texture along one axis; the rest is border.  s: the coordinate;
// change: of s from pixel to pixel; size: of the texture, in texels
float inside_along(float s, float change, float size, int unit, int axis)
{
    if (units[unit].border[axis] == 0.0) return 1.0;
    vec2 distance = vec2(s, 1.0 - s) * size;                // from both ends, in texels
    bool linear = (change * size > 1.0 ? units[unit].border.w : units[unit].magnified_is_linear) == 1.0;
    if (linear) return min(clamp(distance.x + 0.5, 0.0, 1.0), clamp(distance.y + 0.5, 0.0, 1.0));
    return float(distance.x >= 0.0 && distance.y > 0.0);
}

// The comparison with a border's depth.  border: the depth and GL_TEXTURE_COMPARE_FUNC
float passes(float r, vec4 border)
{
    int how = int(border.g);
    bool less = r < border.r, equal = r == border.r;
    return float(how == GL_ALWAYS || (how == GL_LESS && less) || (how == GL_LEQUAL && (less || equal)) ||
        (how == GL_EQUAL && equal) || (how == GL_GEQUAL && !less) || (how == GL_GREATER && !less && !equal) ||
        (how == GL_NOTEQUAL && !equal));
}

float inside(vec3 str, vec3 dx, vec3 dy, vec3 size, int unit)
{
    float covered = 1.0, change = 0.0;
    for (int axis = 0; axis < 3; axis++) change = max(change, max(abs(dx[axis]), abs(dy[axis])) * size[axis]);
    for (int axis = 0; axis < 3; axis++) covered *= inside_along(str[axis], change / size[axis], size[axis], unit, axis);
    return covered;
}
#endif

vec4 texel(sampler2D image, int unit, vec4 coordinates)
{
    vec2 st = coordinates.st / coordinates.q;
    if (TEXTURE_IS_1D[unit]) st.t = 0.5;
    vec2 clamped = vec2(wrapped(st.s, unit, 0), wrapped(st.t, unit, 1));
#ifdef GL_ES
    vec2 dx = level_scale(unit) * dFdx(st), dy = level_scale(unit) * dFdy(st);
    float covered = inside(vec3(clamped, 0.5), vec3(dx, 0.0), vec3(dy, 0.0), vec3(textureSize(image, 0), 1), unit);
    vec4 T = mix(units[unit].border_color, textureGrad(image, clamped, dx, dy), covered);
#else
    vec4 T = CLAMPS[unit] ? textureGrad(image, clamped, dFdx(st), dFdy(st)) : texture(image, st);
#endif
    return TEXTURE_IS_DEPTH[unit] ? as_depth(T.r, unit) : T;
}

// GL_TEXTURE_COMPARE_MODE: 1 where r passes the comparison with the depth in the texture
vec4 texel(sampler2DShadow image, int unit, vec4 coordinates)
{
    vec3 str = coordinates.stp / coordinates.q;
    if (TEXTURE_IS_1D[unit]) str.t = 0.5;
    vec3 clamped = vec3(wrapped(str.s, unit, 0), wrapped(str.t, unit, 1), clamp(str.p, 0.0, 1.0));
#ifdef GL_ES
    vec2 dx = level_scale(unit) * dFdx(str.st), dy = level_scale(unit) * dFdy(str.st);
    float covered = inside(vec3(clamped.st, 0.5), vec3(dx, 0.0), vec3(dy, 0.0), vec3(textureSize(image, 0), 1), unit);
    float passed = mix(passes(clamped.p, units[unit].border_color), textureGrad(image, clamped, dx, dy), covered);
#else
    float passed = CLAMPS[unit] ? textureGrad(image, clamped, dFdx(str.st), dFdy(str.st)) : texture(image, clamped);
#endif
    return as_depth(passed, unit);
}

vec4 texel(sampler3D image, int unit, vec4 coordinates)
{
    vec3 str = coordinates.stp / coordinates.q;
    vec3 clamped = vec3(wrapped(str.s, unit, 0), wrapped(str.t, unit, 1), wrapped(str.p, unit, 2));
#ifdef GL_ES
    vec3 dx = level_scale(unit) * dFdx(str), dy = level_scale(unit) * dFdy(str);
    float covered = inside(clamped, dx, dy, vec3(textureSize(image, 0)), unit);
    return mix(units[unit].border_color, textureGrad(image, clamped, dx, dy), covered);
#else
    return CLAMPS[unit] ? textureGrad(image, clamped, dFdx(str), dFdy(str)) : texture(image, str);
#endif
}

vec4 texel(samplerCube image, int unit, vec4 coordinates)
{
#ifdef GL_ES
    vec3 str = coordinates.stp, size = abs(str);
    float largest = max(size.x, max(size.y, size.z)), edge = 1.0 - 1.0 / float(textureSize(image, 0).x);
    vec3 held = clamp(str / largest, -edge, edge);          // not beyond the middle of a face's last texel
    for (int axis = 0; axis < 3; axis++) if (size[axis] == largest) held[axis] = sign(str[axis]);
    float scale = level_scale(unit) / largest;
    return textureGrad(image, held, scale * dFdx(str), scale * dFdy(str));
#else
    return texture(image, coordinates.stp);
#endif
}

// ---------------------------------------------------------------- GL_COMBINE

// Where an argument comes from
vec4 source(int which, int unit, vec4 previous)
{
    if (which == GL_TEXTURE) return texels[unit];
    if (which == GL_CONSTANT) return units[unit].environment_color;
    if (which == GL_PRIMARY_COLOR) return primary_color;
    if (which == GL_PREVIOUS) return previous;
    return texels[which - GL_TEXTURE0];
}

vec3 argument_rgb(int number, int unit, vec4 previous)
{
    vec4 value = source(SOURCE_RGB[3 * unit + number], unit, previous);
    int operand = OPERAND_RGB[3 * unit + number];
    if (operand == GL_SRC_COLOR) return value.rgb;
    if (operand == GL_ONE_MINUS_SRC_COLOR) return 1.0 - value.rgb;
    if (operand == GL_SRC_ALPHA) return value.aaa;
    return 1.0 - value.aaa;
}

float argument_alpha(int number, int unit, vec4 previous)
{
    float value = source(SOURCE_ALPHA[3 * unit + number], unit, previous).a;
    return OPERAND_ALPHA[3 * unit + number] == GL_SRC_ALPHA ? value : 1.0 - value;
}

// The GL_COMBINE function of three arguments: RGB colours, or alpha as a vector of three equal numbers
vec3 combined(int how, vec3 a0, vec3 a1, vec3 a2)
{
    if (how == GL_REPLACE) return a0;
    if (how == GL_MODULATE) return a0 * a1;
    if (how == GL_ADD) return a0 + a1;
    if (how == GL_ADD_SIGNED) return a0 + a1 - 0.5;
    if (how == GL_INTERPOLATE) return a0 * a2 + a1 * (1.0 - a2);
    if (how == GL_SUBTRACT) return a0 - a1;
    return vec3(4.0 * dot(a0 - 0.5, a1 - 0.5));         // GL_DOT3_RGB and GL_DOT3_RGBA
}

vec4 combine(int unit, vec4 C)
{
    vec3 rgb = combined(COMBINE_RGB[unit],
        argument_rgb(0, unit, C), argument_rgb(1, unit, C), argument_rgb(2, unit, C));
    float alpha = combined(COMBINE_ALPHA[unit], vec3(argument_alpha(0, unit, C)),
        vec3(argument_alpha(1, unit, C)), vec3(argument_alpha(2, unit, C))).x;
    if (COMBINE_RGB[unit] == GL_DOT3_RGBA) return vec4(rgb, rgb.r) * units[unit].rgb_scale;
    return vec4(rgb * units[unit].rgb_scale, alpha * units[unit].alpha_scale);
}

// ---------------------------------------------------------------- all environments

vec4 environment(int unit, vec4 C)
{
    vec4 T = texels[unit], C_c = units[unit].environment_color, result = C;
    bool has_color = TEXTURE_HAS_COLOR[unit], has_alpha = TEXTURE_HAS_ALPHA[unit];
    if (TEXENV[unit] == GL_REPLACE) {
        if (has_color) result.rgb = T.rgb;
        if (has_alpha) result.a = T.a;
    }
    if (TEXENV[unit] == GL_MODULATE) {
        if (has_color) result.rgb = C.rgb * T.rgb;
        if (has_alpha) result.a = C.a * T.a;
    }
    if (TEXENV[unit] == GL_DECAL && has_color)
        result.rgb = has_alpha ? mix(C.rgb, T.rgb, T.a) : T.rgb;
    if (TEXENV[unit] == GL_BLEND) {
        if (has_color) result.rgb = mix(C.rgb, C_c.rgb, T.rgb);
        if (has_alpha) result.a = TEXTURE_IS_INTENSITY[unit] ? mix(C.a, C_c.a, T.a) : C.a * T.a;
    }
    if (TEXENV[unit] == GL_ADD) {
        if (has_color) result.rgb = C.rgb + T.rgb;
        if (has_alpha) result.a = TEXTURE_IS_INTENSITY[unit] ? C.a + T.a : C.a * T.a;
    }
    if (TEXENV[unit] == GL_COMBINE) result = combine(unit, C);
    return clamp(result, 0.0, 1.0);
}

// The fragment's colour after all units, one after the other
vec4 textured(vec4 color, vec4 coordinates[4])
{
    primary_color = color;
#if TEXTURE_0
    texels[0] = texel(texture0, 0, coordinates[0]);
#endif
#if TEXTURE_1
    texels[1] = texel(texture1, 1, coordinates[1]);
#endif
#if TEXTURE_2
    texels[2] = texel(texture2, 2, coordinates[2]);
#endif
#if TEXTURE_3
    texels[3] = texel(texture3, 3, coordinates[3]);
#endif
#if TEXTURE_0
    color = environment(0, color);
#endif
#if TEXTURE_1
    color = environment(1, color);
#endif
#if TEXTURE_2
    color = environment(2, color);
#endif
#if TEXTURE_3
    color = environment(3, color);
#endif
    return color;
}

#endif
