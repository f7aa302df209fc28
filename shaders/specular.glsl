// The highlight: cos^n of an angle, in [0, 1].  N, L and V are unit vectors.

float power(float cosine, float n)
{
    return n == 0.0 ? 1.0 : pow(max(cosine, 0.0), n);
}

// Phong: (R.V)^n, where R is L mirrored at N
float phong(vec3 N, vec3 L, vec3 V, float n)
{
    vec3 S = dot(N, L) * N - L;
    vec3 R = dot(N, L) * N + S;     // R = (N.L) N + S
    return power(dot(R, V), n);
}

// Blinn-Torrance: (N.H)^n, where H is halfway between L and V.  This is OpenGL's.
float blinn_torrance(vec3 N, vec3 L, vec3 V, float n)
{
    vec3 H = normalize(L + V);
    return power(dot(N, H), n);
}

float specular(vec3 N, vec3 L, vec3 V, float n)
{
    return LOBE_IS_PHONG ? phong(N, L, V, n) : blinn_torrance(N, L, V, n);
}
