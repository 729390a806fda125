// Shares as people write them.
#pragma once

#include <string>

namespace penumbra {

/// "100 %", "4.5 %", "0.031 %": `share` (1 is the whole) to two significant digits, all digits before the point, without
/// an exponent down to 0.0001 %; "0 %", "inf %" and "nan %" for what they are.
std::string percent(double share);

} // namespace penumbra
