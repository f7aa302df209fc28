// The texture units.  Every one fills 256 bytes.

struct Unit {
    vec4 environment_color;     // glTexEnv(GL_TEXTURE_ENV_COLOR)
    float rgb_scale;            // glTexEnv(GL_RGB_SCALE)
    float alpha_scale;          // glTexEnv(GL_ALPHA_SCALE)
    vec4 object_plane[4];       // glTexGen for s, t, r, q
    vec4 eye_plane[4];          // in eye space
    mat4 matrix;                // glMatrixMode(GL_TEXTURE); not for unit 0, whose matrix goes with the object
    vec4 unused[2];
};

layout(std140) uniform Texturing { Unit units[4]; };
