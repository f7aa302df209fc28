// glFog: how much of the fragment's colour is left at distance z from the eye, in [0, 1]

float fog_factor(float z)
{
    float d = fog.x;
    float f = 1.0;
    if (FOG == FOG_LINEAR) f = (fog.z - z) / (fog.z - fog.y);   // (end - z) / (end - start)
    if (FOG == FOG_EXP) f = exp(-d * z);
    if (FOG == FOG_EXP2) f = exp(-d * d * z * z);
    return clamp(f, 0.0, 1.0);
}
