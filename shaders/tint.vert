// What is seen through: blockers, backs of surfaces; and the dark parts under covers.
uniform samplerBuffer vertices; // plane coordinates | surface | style

flat out int style;

void main() {
    vec4 vertex = texelFetch(vertices, gl_VertexID);
    vec4 seen = view * vec4(to_space(int(vertex.z), vertex.xy), 1.0);
    seen.xyz *= push_back(int(vertex.z)) - 1e-4;
    gl_Position = projection * seen;
    style = int(vertex.w);
}
