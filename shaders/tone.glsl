// From radiosity to the screen; the same as render/tone.cpp, which the legend uses.
uniform vec2 range; // radiosities shown darkest and brightest
uniform float gain; // of the exposure
uniform bool false_colour;

// Straight up to the shoulder, then bending towards 1: what is lit keeps its proportions, lamps do not tear.
float tone(float x) {
    const float shoulder = 0.8;
    return x < shoulder ? max(x, 0.0) : 1.0 - (1.0 - shoulder) * exp((shoulder - x) / (1.0 - shoulder));
}

float srgb(float x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055; }

// Cividis (Nunez, Anderton & Renslow 2018), as a polynomial.
vec3 cividis(float t) {
    t = clamp(t, 0.0, 1.0);
    return clamp(vec3(-4.54 - t * (35.34 - t * (2381.73 - t * (6402.7 - t * (7024.72 - t * 2710.57)))),
                      32.49 + t * (170.73 + t * (52.82 - t * (131.46 - t * (176.58 - t * 67.37)))),
                      81.24 + t * (442.36 - t * (2482.43 - t * (6167.24 - t * (6614.94 - t * 2475.67))))) / 255.0,
                 0.0, 1.0);
}

vec3 true_colour(vec3 radiosity) {
    vec3 x = gain * (radiosity - range.x) / (range.y - range.x);
    return vec3(srgb(tone(x.r)), srgb(tone(x.g)), srgb(tone(x.b)));
}

vec3 shown(vec3 radiosity) {
    if (!false_colour)
        return true_colour(radiosity);
    return cividis(gain * (dot(radiosity, vec3(1.0 / 3.0)) - range.x) / (range.y - range.x));
}
