// How a glTF reader comes by what its file names.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace penumbra {

/// Bytes of the buffer file of that (decoded, relative) name, or nothing when there is none in the scene's folder.
using OpenBuffer = std::function<std::optional<std::string>(const std::string &name)>;

} // namespace penumbra
