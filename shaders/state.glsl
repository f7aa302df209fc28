// State in uniform blocks.  A Transform or a Material fills 256 bytes, so that a block can begin at any of them.

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
    vec4 I_a;           // I_a,light: ambient intensity, what this light adds to the scene's ambient glow
    vec4 I_d;           // diffuse intensity
    vec4 I_s;           // specular intensity
    vec3 spot_direction;            // unit vector, in which the spot shines
    float spot_exponent;
    float constant_attenuation;     // k_0, k_1 and k_2 of 1 / (k_0 + k_1 d + k_2 d^2)
    float linear_attenuation;
    float quadratic_attenuation;
    float cos_spot_cutoff;          // cosine of the angle between the spot's axis and the edge of its cone
};

layout(std140) uniform Transforms { Transform transforms[OBJECTS]; };
layout(std140) uniform Materials { Material materials[OBJECTS]; };
layout(std140) uniform Lights {
    Light lights[8];
    vec4 I_a_scene;     // I_a,scene: the ambient glow, glLightModel(GL_LIGHT_MODEL_AMBIENT)
};
