// What the program runs on, for tables of times.
#pragma once

#include <string>
#include <string_view>

namespace penumbra {

/// The processor's name as the system tells it; empty where it does not.
std::string cpu_model();
/// Out of the text of /proc/cpuinfo: the first "model name", else the first "Model" (ARM boards); blanks run together.
std::string cpu_model_in(std::string_view cpuinfo);
/// Cores that threads can run on at once, hyper-threads counted one by one; at least 1.
int n_cores();

} // namespace penumbra
