// What every reader promises for any bytes whatever: a sound scene, or one line that says what is wrong.
#pragma once

#include "scene/scene.h"

#include <functional>

namespace penumbra::fuzz {

/// Runs `read`; aborts with a word on standard error where it throws anything but a BadInput of one printable line, or
/// returns a scene that is not sound: coordinates finite and of unit size, areas positive, parts that tile their
/// outlines, material indices in range, reflectances in [0, 1), exitances finite and not negative.
void expect_sound(const std::function<Scene()> &read);

} // namespace penumbra::fuzz
