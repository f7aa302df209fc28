// The texture units.  Every one fills 256 bytes.

struct Unit {
    vec4 environment_color;     // glTexEnv(GL_TEXTURE_ENV_COLOR)
    float rgb_scale;            // glTexEnv(GL_RGB_SCALE)
    float alpha_scale;          // glTexEnv(GL_ALPHA_SCALE)
    float lod_bias;             // only for browsers, whose textures have no bias: GL_TEXTURE_LOD_BIAS
    float magnified_is_linear;  // only for browsers: 1 if GL_TEXTURE_MAG_FILTER is GL_LINEAR
    vec4 object_plane[4];       // glTexGen for s, t, r, q
    vec4 eye_plane[4];          // in eye space
    mat4 matrix;                // glMatrixMode(GL_TEXTURE); not for unit 0, whose matrix goes with the object
    vec4 border_color;          // only for browsers, whose textures have no border: GL_TEXTURE_BORDER_COLOR; if
                                // depths are compared: r is the border's, g GL_TEXTURE_COMPARE_FUNC
    vec4 border;                // xyz: 1 where a border lies in s, t, r; w: 1 if minification is linear in a level
};

layout(std140) uniform Texturing { Unit units[4]; };
