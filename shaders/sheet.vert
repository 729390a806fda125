// Triangles in space, as they are; see critical_pass.
uniform samplerBuffer vertices; // position | opacity

out float opacity;

void main() {
    vec4 vertex = texelFetch(vertices, gl_VertexID);
    vec4 seen = view * vec4(vertex.xyz, 1.0);
    seen.xyz *= 1.0 - 3e-4;
    gl_Position = projection * seen;
    opacity = vertex.w;
}
