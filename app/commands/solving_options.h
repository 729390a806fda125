// The options of all commands that solve; see CONTRACT's "Commands" in the README.
#pragma once

#include "commands/interrupt.h"
#include "core/options.h"
#include "core/vec.h"
#include "scene/move_object.h"

#include <CLI/App.hpp>
#include <CLI/Validators.hpp>

#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct Scene;

struct SolvingOptions {
    std::string scene; ///< a file or a bundled scene's name
    std::vector<ObjectMove> moves; ///< of objects, from where the file has them
    std::string up; ///< empty: the format's own
    Options options;
    Limits limits;
    std::string probe, probe_output;  ///< empty: none

    std::optional<Vec3> up_vector() const;
};

struct CommonOptions {
    std::string output;
    bool quiet = false, verbose = false;
};

/// Of numbers that are finite and above 0.
CLI::Validator positive();

/// -o, -q, -v; `output` is what -o names, for the help.
void add_common_options(CLI::App &parser, CommonOptions &common, const std::string &output);

/// --up and --move.
void add_up_option(CLI::App &parser, SolvingOptions &solving);

/// The positional SCENE, --up and --move.
void add_scene_options(CLI::App &parser, SolvingOptions &solving);

/// --strategy, --cut, --basis, --order, --threshold, --max-depth, --max-iterations, --threads, --memory-limit,
/// --time-limit, --effect and so on.
void add_solving_options(CLI::App &parser, SolvingOptions &solving);

/// --probe and --probe-output, each of which needs the other.
void add_probe_options(CLI::App &parser, SolvingOptions &solving);

/// Opens the scene and says its notes unless quiet.
Scene open_scene(const SolvingOptions &solving, const CommonOptions &common);

} // namespace penumbra
