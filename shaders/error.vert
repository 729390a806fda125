uniform samplerBuffer vertices; // 2 texels: place in the plane | surface, patch's value | B_h - B

out vec3 missed;
flat out float patch_value;

void main() {
    vec4 place = texelFetch(vertices, 2 * gl_VertexID);
    vec4 value = texelFetch(vertices, 2 * gl_VertexID + 1);
    missed = value.rgb;
    patch_value = place.w;
    int surface = int(place.z);
    if (!faces_eye(surface)) {
        gl_Position = nowhere;
        return;
    }
    vec4 seen = view * vec4(to_space(surface, place.xy), 1.0);
    seen.xyz *= push_back(surface);
    gl_Position = projection * seen;
}
