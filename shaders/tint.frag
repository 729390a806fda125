const int max_styles = 4;
uniform vec4 fills[max_styles];
uniform vec4 hatches[max_styles];
uniform float hatch_period; // pixels
uniform vec2 origin;        // of the framebuffer in the pane [pixels]

flat in int style;
out vec4 colour;

void main() {
    vec2 place = gl_FragCoord.xy + origin;
    float phase = fract((place.x + place.y) / hatch_period);
    float edge = 1.0 / hatch_period; // a pixel's softness
    float on_line = smoothstep(0.0, edge, phase) * (1.0 - smoothstep(0.18, 0.18 + edge, phase));
    vec4 hatch = hatches[style];
    colour = mix(fills[style], vec4(hatch.rgb, max(hatch.a, fills[style].a)), on_line * hatch.a);
}
