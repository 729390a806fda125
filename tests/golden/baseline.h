// Pictures that somebody looked at. A missing one is a failure. To make or renew one: PENUMBRA_WRITE_BASELINES=1 writes it,
// and the test fails all the same, so that it cannot stay on.
#pragma once

#include "capture.h"

#include <filesystem>
#include <string>

namespace penumbra {

/// SSIM from which on two pictures are the same.
inline constexpr double alike = 0.999;

std::filesystem::path baseline(const std::string &name);
/// A test's expectation; where it fails, the picture is written beside the test program.
void expect_golden(const std::string &name, const Image &drawn);

} // namespace penumbra
