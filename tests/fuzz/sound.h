// What every reader promises for any bytes whatever: a sound scene, or one line that says what is wrong.
#pragma once

#include "scene/scene.h"

#include <functional>
#include <string>

namespace penumbra::fuzz {

/// Runs `read`; aborts with a word on standard error where it throws anything but a BadInput of one printable line, or
/// returns a scene that is not sound: coordinates finite and of unit size, areas positive, parts that tile their
/// outlines, material indices in range, reflectances in [0, 1), exitances finite and not negative.
void expect_sound(const std::function<Scene()> &read);

/// Runs `read`; aborts where it throws anything but a BadInput of one printable line.
void expect_refusal_in_one_line(const std::function<void()> &read);

/// Aborts with a word on standard error unless it holds; `where` tells what was read.
void expect(bool holds, const char *what, const std::string &where);
void expect_one_line(const std::string &message);

} // namespace penumbra::fuzz
