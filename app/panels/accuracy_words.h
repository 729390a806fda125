// Where a solution stands with the accuracy asked for, in a sentence.
#pragma once

#include "iteration/snapshot.h"

#include <string>

namespace penumbra {

/// "The 1 % asked for is reached." and so on; empty where no tolerance was asked for.
std::string accuracy_words(const Snapshot &snapshot);

} // namespace penumbra
