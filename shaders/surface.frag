uniform int shading;
uniform bool values; // write radiosity itself, into a float target

out vec4 colour;

void main() {
    vec3 b = radiosity(shading);
    colour = vec4(values ? b : surface_role == emitter ? true_colour(b) : shown(b), 1.0);
}
