// Which curves are shown, as saved states have it.
#pragma once

#include "render/look.h"

#include <nlohmann/json.hpp>

namespace penumbra {

/// {"kinds": ["VE", ...], "orders": [0, ...], "source": number or null, "shown": number or null}
nlohmann::ordered_json curves_json(const Look &look);

} // namespace penumbra
