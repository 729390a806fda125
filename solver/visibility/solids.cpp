#include "visibility/blockers.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace penumbra {

namespace {

constexpr double same_point = 1e-12;

/// Numbers corners so that coinciding ones get the same number.
std::vector<std::vector<int>> weld(const Scene &scene) {
    struct Corner {
        Vec3 x;
        std::size_t surface, index;
    };
    std::vector<Corner> corners;
    std::vector<std::vector<int>> number(scene.surfaces.size());
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        number[s].resize(scene.surfaces[s].corners.size());
        for (std::size_t i = 0; i < number[s].size(); ++i)
            corners.push_back({scene.surfaces[s].corners[i], s, i});
    }
    std::ranges::stable_sort(corners, {}, [](const Corner &c) { return c.x.x(); });
    int next = 0;
    std::vector<int> given(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        given[i] = -1;
        for (std::size_t j = i; j-- > 0 && corners[i].x.x() - corners[j].x.x() <= same_point;)
            if ((corners[i].x - corners[j].x).cwiseAbs().maxCoeff() <= same_point) {
                given[i] = given[j];
                break;
            }
        if (given[i] < 0)
            given[i] = next++;
        number[corners[i].surface][corners[i].index] = given[i];
    }
    return number;
}

} // namespace

std::vector<Solid> find_solids(const Scene &scene) {
    const auto number = weld(scene);
    const std::size_t n = scene.surfaces.size();
    // Faces by directed edge.
    std::map<std::pair<int, int>, std::vector<std::size_t>> faces;
    for (std::size_t s = 0; s < n; ++s)
        for (std::size_t i = 0; i < number[s].size(); ++i)
            faces[{number[s][i], number[s][(i + 1) % number[s].size()]}].push_back(s);

    std::vector<std::size_t> root(n);
    std::iota(root.begin(), root.end(), 0u);
    const auto find = [&](std::size_t s) {
        while (root[s] != s)
            s = root[s] = root[root[s]];
        return s;
    };
    std::vector<bool> open(n, false);
    for (const auto &[edge, on] : faces) {
        const auto reverse = faces.find({edge.second, edge.first});
        if (on.size() != 1 || reverse == faces.end() || reverse->second.size() != 1) {
            for (const std::size_t s : on)
                open[s] = true;
            continue;
        }
        root[find(on[0])] = find(reverse->second[0]);
    }
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t s = 0; s < n; ++s)
        groups[find(s)].push_back(s);

    std::vector<Solid> solids;
    for (const auto &[first, group] : groups) {
        const bool closed = std::ranges::none_of(group, [&](std::size_t s) { return open[s]; });
        const bool convex = closed && std::ranges::all_of(group, [&](std::size_t s) {
            return std::ranges::all_of(group, [&](std::size_t t) {
                return std::ranges::all_of(scene.surfaces[t].corners, [&](const Vec3 &x) {
                    return scene.surfaces[s].frame.height(x) <= 1e-9;
                });
            });
        });
        if (!convex)
            continue;
        Solid &solid = solids.emplace_back();
        for (const std::size_t s : group)
            solid.faces.push_back(SurfaceId(s));
    }
    return solids;
}

} // namespace penumbra
