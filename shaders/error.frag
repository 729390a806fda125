// How wrong the solution is, on its scale; the same as render/error_scale.cpp, which the legend uses.
in vec3 missed;           // B_h - B [W/m2]
flat in float patch_value; // not positive: not known

uniform int kind;   // as ErrorKind: 0 signed, 1 relative, 2 of the patch, 3 against the estimate
uniform float peak; // of B - E [W/m2]
uniform vec2 ends;  // of the scale; logarithms of these but for kind 0
uniform bool values; // write the value itself, into a float target

out vec4 colour;

void main() {
    float value = kind == 0 ? dot(missed, vec3(1.0 / 3.0)) : kind == 1 ? sqrt(dot(missed, missed) / 3.0) / peak : patch_value;
    if (values) {
        colour = vec4(value, value, value, 1.0);
        return;
    }
    if (kind >= 2 && value <= 0.0) {
        colour = vec4(0.5, 0.5, 0.5, 1.0);
        return;
    }
    float on_scale = kind == 0 ? value : log(max(value, 1e-30));
    float t = clamp((on_scale - ends.x) / (ends.y - ends.x), 0.0, 1.0);
    colour = vec4(kind == 0 || kind == 3 ? diverging(2.0 * t - 1.0) : cividis(t), 1.0);
}
