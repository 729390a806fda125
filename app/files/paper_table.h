// The table that stands beside the paper's figures 5 to 8.
#pragma once

#include "iteration/snapshot.h"

#include <memory>
#include <string>
#include <vector>

namespace penumbra {

using Solutions = std::vector<std::shared_ptr<const Snapshot>>;

/// Patches that Bouatouch & Pattanaik (1995, section 5) report.
int paper_patches(Strategy strategy);

/// A line for each solution; errors are relative (L2, of the reflected radiosity), empty when not known.
std::string paper_csv(const Solutions &solutions);
/// Their patches, coefficients, links' coefficients and seconds as bars, side by side.
std::string work_bars(const Solutions &solutions);
/// Both for reading.
std::string paper_text(const Solutions &solutions);

} // namespace penumbra
