// What can go wrong, and how it is said.
#pragma once

#include <stdexcept>
#include <string>

namespace penumbra {

/// Input that cannot be used. what() is one line with file, line or object, value and remedy. Exit status 3.
struct BadInput : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file that cannot be written, or no display or GL. Exit status 5.
struct Unavailable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Thrown inside a step when its cancel flag is raised; the state before the step stays valid.
struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("cancelled") {}
};

} // namespace penumbra
