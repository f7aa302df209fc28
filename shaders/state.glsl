// What the program's calls have set, as the GPU sees it.  Every row fills 256 bytes, so that any row can begin a block.

struct Transform {
    mat4 modelview_projection;  // object space -> clip space: glMatrixMode(GL_PROJECTION) times GL_MODELVIEW
    mat4 modelview;             // object space -> eye space
    mat3 normal;                // inverse transpose of modelview: takes normals to eye space
    mat4 texture;               // glMatrixMode(GL_TEXTURE)
    vec4 unused;
};

// One side of a surface: glMaterial
struct Face {
    vec4 k_a;       // ambient reflectance
    vec4 k_d;       // diffuse reflectance; its alpha is the alpha of the result
    vec4 k_s;       // specular reflectance
    vec4 emission;
    float n;        // shininess, the exponent of the highlight
};

struct Material {
    Face front;
    Face back;
    vec4 color;     // the current colour, for vertices that have none of their own
    vec4 unused[5];
};

// glLight; all vectors in eye space
struct Light {
    vec4 position;      // xyz: where the light is, or for a directional light the unit vector towards it
    vec4 I_a;           // ambient, diffuse and specular intensity
    vec4 I_d;
    vec4 I_s;
    vec4 spot;          // xyz: unit direction in which the spot shines; w: its exponent
    vec4 attenuation;   // x, y, z: constant, linear, quadratic; w: cosine of the spot's cutoff angle
};

layout(std140) uniform Transforms { Transform transforms[OBJECTS]; };
layout(std140) uniform Materials { Material materials[OBJECTS]; };
layout(std140) uniform Lights {
    Light lights[8];
    vec4 scene_ambient;  // the ambient glow I_a: glLightModel(GL_LIGHT_MODEL_AMBIENT)
};
