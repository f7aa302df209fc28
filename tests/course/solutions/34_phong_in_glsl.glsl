void phong_shading(Face face, vec3 normal, vec3 P, out vec4 color, out vec3 highlight)
{
    highlight = vec3(0.0);
    vec3 N = normalize(normal);
    vec3 L = normalize(lights[0].position.xyz - P);
    vec3 V = normalize(-P);
    vec3 H = normalize(L + V);
    vec3 I = face.emission.rgb + face.k_a.rgb * I_a_scene.rgb;
    if (dot(N, L) > 0.0) {
        I += face.k_d.rgb * lights[0].I_d.rgb * dot(N, L);
        I += face.k_s.rgb * lights[0].I_s.rgb * power(dot(N, H), face.n);
    }
    color = vec4(I, face.k_d.a);
}
