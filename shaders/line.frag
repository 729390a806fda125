uniform vec4 colours[16];
uniform vec4 strokes[16];
uniform float pixel; // scene units to a pixel at the middle of the picture, for dashes

flat in int style;
flat in float half_width;
noperspective in float across;
in float along;
out vec4 colour;

void main() {
    colour = colours[style];
    colour.a *= clamp(half_width + 0.5 - abs(across), 0.0, 1.0) * min(1.0, 2.0 * half_width);
    float period = strokes[style].y * pixel;
    if (period > 0.0) {
        float phase = fract(along / period), soft = fwidth(along) / period;
        colour.a *= smoothstep(0.0, soft, phase) * (1.0 - smoothstep(strokes[style].z, strokes[style].z + soft, phase));
    }
    if (colour.a <= 0.0)
        discard;
}
