#include "discontinuity/hidden_pairs.h"

#include "discontinuity/source_view.h"

#include <algorithm>
#include <functional>

namespace penumbra {

std::vector<Eigen::AlignedBox3d> boxes_of(const Scene &scene) {
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const Surface &surface : scene.surfaces) {
        Eigen::AlignedBox3d &box = boxes.emplace_back();
        for (const Vec3 &c : surface.corners)
            box.extend(c);
    }
    return boxes;
}

HiddenPairs::HiddenPairs(const Scene &scene) : scene_(scene), boxes_(boxes_of(scene)), last_(scene.surfaces.size()) {
    for (int s = 0; s < scene.n_surfaces(); ++s)
        large_first_.emplace_back(s);
    std::ranges::stable_sort(large_first_, std::greater<>(), [&](SurfaceId s) { return scene.surface(s).area; });
}

bool HiddenPairs::hidden(SurfaceId source, SurfaceId receiver) const {
    const Eigen::AlignedBox3d both = boxes_[source.at()].merged(boxes_[receiver.at()]);
    const auto hides_all = [&](SurfaceId s) {
        return s != source && s != receiver && both.intersects(boxes_[s.at()]) &&
               hides(scene_.surface(s), scene_.surface(receiver), scene_.surface(source));
    };
    if (const SurfaceId last(last_[source.at()].load(std::memory_order_relaxed)); hides_all(last))
        return true;
    const auto found = std::ranges::find_if(large_first_, hides_all);
    if (found == large_first_.end())
        return false;
    last_[source.at()].store(found->index, std::memory_order_relaxed);
    return true;
}

} // namespace penumbra
