// The element's own polynomial, for each fragment.
uniform samplerBuffer coefficients;

flat in int patch_index;
flat in int surface_role;
in vec2 local;
in vec3 between;

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Inverse of the bilinear map, as in iteration/snapshot.cpp: one root for quads of any shape, triangles too.
vec2 parameters(vec2 b, vec2 c, vec2 d, vec2 h) {
    float q2 = -cross2(b, d), q1 = cross2(h, d) - cross2(b, c), q0 = cross2(h, c);
    float root = sqrt(max(0.0, q1 * q1 - 4.0 * q2 * q0));
    float over = q1 <= 0.0 ? root - q1 : -2.0 * q2;
    float u = over == 0.0 ? 0.5 : clamp((q1 <= 0.0 ? 2.0 * q0 : q1 + root) / over, 0.0, 1.0);
    vec2 across = c + u * d;
    float length2 = dot(across, across);
    return vec2(u, length2 == 0.0 ? 0.5 : clamp(dot(h - u * b, across) / length2, 0.0, 1.0));
}

// Legendre polynomials orthonormal on [0,1], degrees 0 to 3.
vec4 legendre(float x) {
    float t = 2.0 * x - 1.0;
    return vec4(1.0, 1.7320508 * t, 2.2360680 * (1.5 * t * t - 0.5), 2.6457513 * (2.5 * t * t - 1.5) * t);
}

// W/m2. shading as enum Shading: 0 the polynomial, 1 its mean, 2 between corner values.
vec3 radiosity(int shading) {
    if (shading == 1)
        return patch_texel(patch_index, 3).rgb;
    if (shading == 2 && patch_texel(patch_index, 3).w > 0.0)
        return between;
    vec4 middle = patch_texel(patch_index, 1), tail = patch_texel(patch_index, 2);
    vec2 b = middle.xy, c = tail.xy;
    vec2 p = parameters(b, c, middle.zw - c - b, local);
    if (shading == 2)
        return mix(mix(patch_texel(patch_index, 4).rgb, patch_texel(patch_index, 5).rgb, p.x),
                   mix(patch_texel(patch_index, 7).rgb, patch_texel(patch_index, 6).rgb, p.x), p.y);
    int order = int(tail.z), first = int(tail.w);
    vec4 lu = legendre(p.x), lv = legendre(p.y);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < order; ++i)
        for (int j = 0; j < order; ++j)
            sum += texelFetch(coefficients, first + i * order + j).rgb * (lu[i] * lv[j]);
    return sum;
}
