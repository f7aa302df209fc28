// glFog: the blend factor f in [0, 1] at distance z from the eye: f C + (1 - f) C_fog (OpenGL 1.5 section 3.10)

float fog_factor(float z)
{
    float d = fog_density;
    float f = 1.0;
    if (FOG == FOG_LINEAR) f = (fog_end - z) / (fog_end - fog_start);
    if (FOG == FOG_EXP) f = exp(-d * z);
    if (FOG == FOG_EXP2) f = exp(-d * d * z * z);
    return clamp(f, 0.0, 1.0);
}
