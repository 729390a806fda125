// Numbers as the panels print them.
#pragma once

#include "core/vec.h"

#include <cstdint>
#include <string>

namespace penumbra {

/// 1776 as "1 776" (thin spaces), 1234567 as "1.23 M".
std::string count_words(std::int64_t n);
/// Three significant digits.
std::string number_words(double x);
/// The same with digits enough for what is to be compared, and powers of ten as people write them: "3.8·10⁻⁵".
std::string power_words(double x, int digits = 3);
/// Red, green and blue, or the one number that they all are.
std::string rgb_words(const Rgb &c);
/// "12 ms", "1.24 s", "3 min 20 s".
std::string seconds_words(double s);
/// "740 KiB", "12 MiB", "1.3 GiB".
std::string memory_words(double bytes);
/// "iteration 2, gather"; "start".
std::string position_words(int position);
/// "Refine", "Gather", "Push and pull": what leads to the position.
std::string phase_verb(int position);

} // namespace penumbra
