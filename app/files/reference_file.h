// Solutions that references are made from, kept for the next time.
#pragma once

#include "measure/reference.h"

#include <filesystem>
#include <optional>
#include <string>

namespace penumbra {

/// Where the solution of this very scene (geometry and materials, whatever its file is called) is kept below `folder`.
std::filesystem::path reference_path(const std::filesystem::path &folder, const Scene &scene);

struct KeptSolution {
    double tolerance = 0; ///< that was asked for
    ConvergedSolution solution;
};

/// Elements of the parametric basis alone. Binary, of this machine's byte order; ends with a check sum.
std::string reference_bytes(const Scene &scene, const KeptSolution &kept);
/// Nothing where the bytes are not such a file, of another scene, or damaged.
std::optional<KeptSolution> read_reference(const Scene &scene, const std::string &bytes);

} // namespace penumbra
