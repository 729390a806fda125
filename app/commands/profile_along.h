// A profile for the command line: the line, the truth and the panes' solutions along it, and the files they go to.
#pragma once

#include "iteration/profile.h"
#include "plot/profile_sheet.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace penumbra {

/// BadInput, naming `field`, where no reflecting surface holds both points to within a thousandth of the scene's size.
ProfileLine find_line(const Snapshot &snapshot, const Vec3 &from, const Vec3 &to, double size,
                      const std::string &field);

/// For a plot of ordinary width.
ProfileData profile_along(const ProfileLine &line, const std::vector<std::shared_ptr<const Snapshot>> &solutions,
                          const Truth &truth, const Cancel *cancel);

/// Beside `picture` (NAME.png): NAME-profile.png, NAME-profile.svg and NAME-profile.csv. Needs a current GL context.
void write_profile(const std::filesystem::path &picture, const ProfileLine &line, const ProfileData &data, Theme theme);

} // namespace penumbra
