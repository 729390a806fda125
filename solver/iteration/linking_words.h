// What was linked, and why, in words.
#pragma once

#include "iteration/split_event.h"
#include "scene/scene.h"

#include <string>

namespace penumbra {

/// "floor, element 12: linked to lamp, partly hidden, form factor 3.1 %, order 2 of 4; links of an element above it failed"
std::string linking_words(const Scene &scene, const Forest &forest, const LinkEvent &event);

} // namespace penumbra
