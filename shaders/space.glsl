// From surfaces' planes to the screen. Space is the scene's, centred and scaled to unit size.
uniform samplerBuffer surfaces; // 4 texels: origin | rank, u | role, v | 1 where it reflects, normal
uniform mat4 view, projection;
uniform vec3 eye;

// As SurfaceRole.
const int reflector = 0, emitter = 1, blocker = 2;

int role(int surface) { return int(texelFetch(surfaces, 4 * surface + 1).w); }

bool reflects(int surface) { return texelFetch(surfaces, 4 * surface + 2).w > 0.0; }

vec3 to_space(int surface, vec2 p) {
    return texelFetch(surfaces, 4 * surface).xyz + p.x * texelFetch(surfaces, 4 * surface + 1).xyz +
           p.y * texelFetch(surfaces, 4 * surface + 2).xyz;
}

bool faces_eye(int surface) {
    return dot(eye - texelFetch(surfaces, 4 * surface).xyz, texelFetch(surfaces, 4 * surface + 3).xyz) > 0.0;
}

// Of two surfaces in one plane the covered one has the higher rank and is pushed back by it, along the ray to the eye:
// nothing moves on the screen.
float push_back(int surface) { return 1.0 + 3e-3 * texelFetch(surfaces, 4 * surface).w; }

const vec4 nowhere = vec4(2.0, 2.0, 2.0, 1.0); // outside the clip volume
