flat out int patch_index;
flat out int surface_role;
out vec2 local;

const int corner_of[6] = int[](0, 1, 2, 0, 2, 3);

void main() {
    patch_index = gl_VertexID / 6;
    int corner = corner_of[gl_VertexID % 6];
    vec4 head = patch_texel(patch_index, 0), middle = patch_texel(patch_index, 1);
    int surface = int(head.w);
    surface_role = role(surface);
    local = corner == 0 ? vec2(0.0) : corner == 1 ? middle.xy : corner == 2 ? middle.zw : patch_texel(patch_index, 2).xy;
    if (surface_role == blocker || !faces_eye(surface)) {
        gl_Position = nowhere;
        return;
    }
    vec4 seen = view * vec4(to_space(surface, head.xy + head.z * local), 1.0);
    seen.xyz *= push_back(surface);
    gl_Position = projection * seen;
}
