// Parallel loops whose results cannot depend on the number of threads: every index writes only its own slot.
#pragma once

#include <cstddef>
#include <functional>

namespace penumbra {

/// Number of threads that later loops use, of all callers; 0 means all cores. From any thread.
void set_threads(int n);
int threads();

/// Calls body(i) for every i in [0, n), each exactly once, in any order and on any thread. An exception thrown by a body
/// stops the loop as soon as possible and is rethrown here.
void parallel_for(std::size_t n, const std::function<void(std::size_t)> &body);

} // namespace penumbra
