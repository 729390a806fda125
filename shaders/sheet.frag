uniform vec4 fill;

in float opacity;
out vec4 colour;

void main() { colour = vec4(fill.rgb, fill.a * opacity); }
