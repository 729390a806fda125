// Who may include whom: solver folders only those that stand before them, solver nothing of the app or of a window,
// panels nothing of gl/. A control with planted includes must fail.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <optional>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 12> order{"core",      "geometry",      "scene",     "visibility",
                                                 "basis",     "hierarchy",     "discontinuity", "transport",
                                                 "effects",   "measure",       "iteration", "study"};
constexpr std::array<std::string_view, 10> of_a_window{"GL/",    "GLES",  "EGL/",   "epoxy/", "GLFW/",
                                                       "glm/",   "imgui", "backends/imgui", "app/", "KHR/"};
constexpr std::array<std::string_view, 9> app_folders{"commands", "window", "gl",   "render", "panels",
                                                      "plot",     "files",  "capture", "app_state"};

/// Path from the top level, and text.
using Sources = std::map<std::string, std::string>;

std::vector<std::string> includes_of(const std::string &text) {
    std::vector<std::string> found;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t hash = line.find_first_not_of(" \t");
        if (hash == line.npos || line[hash] != '#' || line.find("include") == line.npos)
            continue;
        const std::size_t open = line.find_first_of("\"<"), close = line.find_last_of("\">");
        if (open != line.npos && close > open)
            found.push_back(line.substr(open + 1, close - open - 1));
    }
    return found;
}

std::optional<std::size_t> rank(std::string_view folder) {
    const auto found = std::ranges::find(order, folder);
    return found == order.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - order.begin()));
}

std::string_view first_folder(std::string_view path) { return path.substr(0, path.find('/')); }

bool starts_with_any(std::string_view include, const auto &prefixes) {
    return std::ranges::any_of(prefixes, [&](std::string_view prefix) { return include.starts_with(prefix); });
}

std::string trouble_in_solver(const std::string &folder, const std::string &include) {
    const auto own = rank(folder);
    if (!own)
        return "is in no folder of the solver's list";
    if (starts_with_any(include, of_a_window))
        return "includes " + include;
    const std::string_view other = first_folder(include);
    if (include.find('/') != include.npos && std::ranges::find(app_folders, other) != app_folders.end())
        return "includes " + include + " of the app";
    if (const auto rank_of_other = rank(other); rank_of_other && *rank_of_other > *own)
        return "includes " + include + ", which stands later in the list";
    return "";
}

std::vector<std::string> violations(const Sources &sources) {
    std::vector<std::string> found;
    for (const auto &[path, text] : sources)
        for (const std::string &include : includes_of(text)) {
            std::string trouble;
            if (path.starts_with("solver/"))
                trouble = trouble_in_solver(std::string(first_folder(path.substr(7))), include);
            else if (path.starts_with("app/panels/") &&
                     (include.starts_with("gl/") || include.starts_with("epoxy/") || include.starts_with("GL/")))
                trouble = "is a panel and includes " + include;
            if (!trouble.empty())
                found.push_back(path + " " + trouble);
        }
    return found;
}

Sources sources_below(const std::string &top) {
    Sources sources;
    for (const auto &entry : fs::recursive_directory_iterator(fs::path(PENUMBRA_SOURCE_DIR) / top)) {
        const std::string kind = entry.path().extension().string();
        if (kind != ".h" && kind != ".cpp" && kind != ".inl")
            continue;
        std::stringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        sources[fs::relative(entry.path(), PENUMBRA_SOURCE_DIR).string()] = text.str();
    }
    return sources;
}

TEST(Includes, SolverFoldersIncludeOnlyEarlierOnes) {
    const Sources sources = sources_below("solver");
    EXPECT_GE(sources.size(), 20U) << "the folder was not found";
    EXPECT_THAT(violations(sources), testing::IsEmpty());
}

TEST(Includes, PanelsIncludeNothingOfGl) { EXPECT_THAT(violations(sources_below("app")), testing::IsEmpty()); }

TEST(Includes, EachPlantedOneIsFound) {
    const Sources planted{
        {"solver/core/a.h", "#include \"scene/scene.h\"\n"},
        {"solver/geometry/b.cpp", "  #  include <GLFW/glfw3.h>\n"},
        {"solver/scene/c.cpp", "#include <glm/vec3.hpp>\n"},
        {"solver/scene/d.cpp", "#include \"app/app_state.h\"\n"},
        {"solver/iteration/e.cpp", "#include <imgui.h>\n"},
        {"solver/iteration/f.cpp", "#include \"render/camera.h\"\n"},
        {"solver/elsewhere/g.cpp", "#include <vector>\n"},
        {"app/panels/h.cpp", "#include \"gl/program.h\"\n"},
    };
    EXPECT_EQ(violations(planted).size(), planted.size());
    EXPECT_THAT(violations({{"solver/study/x.cpp", "#include \"core/vec.h\"\n#include <vector>\n"},
                            {"app/render/y.cpp", "#include \"gl/program.h\"\n"}}),
                testing::IsEmpty());
}

TEST(Comments, NoMachinePathsInTheSources) {
    for (const char *top : {"solver", "app", "tests"})
        for (const auto &[path, text] : sources_below(top))
            EXPECT_EQ(text.find(std::string("/home") + "/"), text.npos) << path;
}

} // namespace
