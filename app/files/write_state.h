// Saved states as readable JSON.
#pragma once

#include "files/saved_state.h"

#include <nlohmann/json.hpp>

namespace penumbra {

/// All fields but the notes. What read_state makes of it is the same state.
nlohmann::ordered_json state_json(const SavedState &state);
/// The same as text. Bytes of names that are no UTF-8 become replacement characters.
std::string state_text(const SavedState &state);

} // namespace penumbra
