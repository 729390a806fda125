// Nine points of Crameri's vik (2018); the same as render/diverging.cpp, which the legend uses.
const vec3 vik[9] = vec3[9](vec3(0, 18, 97), vec3(3, 62, 125), vec3(30, 111, 157), vec3(133, 181, 205),
                            vec3(236, 229, 224), vec3(221, 177, 149), vec3(194, 107, 59), vec3(139, 39, 6),
                            vec3(89, 0, 7));

vec3 diverging(float t) {
    float at = clamp(4.0 * (t + 1.0), 0.0, 8.0), low = min(floor(at), 7.0);
    int i = int(low);
    return mix(vik[i], vik[i + 1], at - low) / 255.0;
}
