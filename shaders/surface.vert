uniform samplerBuffer vertices; // 2 texels: place in the plane | local coordinates, patch | value between corners

uniform bool lamps_alone; // what reflects is shown by another pass

flat out int patch_index;
flat out int surface_role;
out vec2 local;
out vec3 between;

void main() {
    vec4 place = texelFetch(vertices, 2 * gl_VertexID);
    vec4 value = texelFetch(vertices, 2 * gl_VertexID + 1);
    patch_index = int(value.x);
    between = value.yzw;
    local = place.zw;
    int surface = int(patch_texel(patch_index, 0).w);
    surface_role = role(surface);
    if (surface_role == blocker || !faces_eye(surface) || (lamps_alone && reflects(surface))) {
        gl_Position = nowhere;
        return;
    }
    vec4 seen = view * vec4(to_space(surface, place.xy), 1.0);
    seen.xyz *= push_back(surface);
    gl_Position = projection * seen;
}
