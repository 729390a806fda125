// Links are coloured by kind, in the scene and wherever they are told of.
#pragma once

#include <glm/glm.hpp>

namespace penumbra {

/// Of SnapshotLink::kind, sRGB.
inline glm::vec3 link_colour(int kind) {
    constexpr float table[3][3] = {{0.35f, 0.70f, 0.90f}, {0.95f, 0.90f, 0.25f}, {0.85f, 0.40f, 0.65f}};
    const float *c = table[kind == 0 || kind == 1 ? kind : 2];
    return {c[0], c[1], c[2]};
}

/// "clear", "near or touching", "partly hidden".
inline const char *link_kind_words(int kind) {
    return kind == 0 ? "clear" : kind == 1 ? "near or touching" : "partly hidden";
}

} // namespace penumbra
