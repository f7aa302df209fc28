// glColorMaterial: properties that track the current colour.  TRACKS: whether ambient, diffuse, specular, emission do.

Face track(Face face, vec4 color, bool[4] TRACKS)
{
    if (TRACKS[0]) face.k_a = color;
    if (TRACKS[1]) face.k_d = color;
    if (TRACKS[2]) face.k_s = color;
    if (TRACKS[3]) face.emission = color;
    return face;
}
