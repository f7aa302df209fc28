float blinn_torrance(vec3 N, vec3 L, vec3 V, float n)
{
    vec3 H = normalize(L + V);
    return power(dot(N, H), n);
}
