// Segments of constant width on the screen: each a quad of two triangles.
uniform samplerBuffer segments; // 2 texels: from | style + 64 * (surface + 1), to | length before `from` on its polyline
uniform vec4 strokes[16]; // width and dash period [pixels], part of the period that is drawn, extra width
uniform vec2 viewport;    // pixels
uniform float near, lift; // distance of the near plane; part of the way by which lines are lifted off to the eye

flat out int style;
flat out float half_width;
noperspective out float across; // pixels from the middle
out float along;                // length from the polyline's start, scene units

void main() {
    vec4 from = texelFetch(segments, 2 * (gl_VertexID / 6)), to = texelFetch(segments, 2 * (gl_VertexID / 6) + 1);
    int tag = int(from.w), surface = tag / 64 - 1;
    style = tag % 64;
    half_width = 0.5 * (strokes[style].x + strokes[style].w);
    across = along = 0.0;
    gl_Position = nowhere;
    if (strokes[style].x <= 0.0 || (surface >= 0 && role(surface) != blocker && !faces_eye(surface)))
        return;
    vec3 a = (view * vec4(from.xyz, 1.0)).xyz, b = (view * vec4(to.xyz, 1.0)).xyz;
    float s = to.w, t = to.w + distance(a, b);
    if (a.z > -near && b.z > -near)
        return;
    if (a.z > -near) { // cut at the near plane: a point behind the eye has no place on the screen
        float k = (-near - a.z) / (b.z - a.z);
        a = mix(a, b, k);
        s = mix(s, t, k);
    } else if (b.z > -near) {
        float k = (-near - b.z) / (a.z - b.z);
        b = mix(b, a, k);
        t = mix(t, s, k);
    }
    float away = (surface >= 0 ? push_back(surface) : 1.0) - lift; // lines of a covered surface stay below the cover
    vec4 clip_a = projection * vec4(a * away, 1.0), clip_b = projection * vec4(b * away, 1.0);
    vec2 way = (clip_b.xy / clip_b.w - clip_a.xy / clip_a.w) * 0.5 * viewport;
    float pixels = length(way);
    vec2 ahead = pixels > 0.0 ? way / pixels : vec2(1.0, 0.0);
    int corner = gl_VertexID % 6;
    bool at_end = corner == 1 || corner == 2 || corner == 4;
    float side = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
    float reach = half_width + 1.0;
    vec2 offset = side * reach * vec2(-ahead.y, ahead.x) + (at_end ? 0.5 : -0.5) * ahead;
    vec4 clip = at_end ? clip_b : clip_a;
    clip.xy += offset * 2.0 / viewport * clip.w;
    gl_Position = clip;
    across = side * reach;
    along = at_end ? t : s;
}
