// Probe files: points with normals in, radiosity out.
#pragma once

#include "core/vec.h"
#include "iteration/snapshot.h"

#include <filesystem>
#include <string>
#include <vector>

namespace penumbra {

struct Probe {
    std::string row; ///< as it stands in the file
    Vec3 point, normal; ///< the scene's own frame; normal of unit length
};

/// CSV with the header `x,y,z,nx,ny,nz`. Throws BadInput, with file and line.
std::vector<Probe> read_probes(const std::filesystem::path &file);

/// The same rows in the same order with `r,g,b` added; `nan` where no surface is within 1e-6 of `size`, the scene's.
std::string probe_csv(const std::vector<Probe> &probes, const Snapshot &snapshot, double size);

} // namespace penumbra
