#include "render/corner_index.h"

#include <algorithm>
#include <cmath>

namespace penumbra {
namespace {

std::uint64_t cell_key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(y);
}

} // namespace

CornerIndex::CornerIndex(const Snapshot &snapshot, std::span<const int> patches) {
    Vec2 high = Vec2::Constant(-1e300);
    low_ = Vec2::Constant(1e300);
    for (const int i : patches)
        for (const Vec2 &p : snapshot.patches[static_cast<std::size_t>(i)].corners) {
            low_ = low_.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    if (patches.empty())
        low_ = high = Vec2::Zero();
    extent_ = high - low_;
    slack_ = std::max(1e-8 * extent_.norm(), 1e-300);
    for (const int i : patches) {
        std::vector<int> &ids = corners_.emplace_back();
        for (const Vec2 &p : snapshot.patches[static_cast<std::size_t>(i)].corners)
            ids.push_back(merge(p));
    }
    cells_.clear();
    sort_into_bins();
}

int CornerIndex::merge(const Vec2 &p) {
    const auto x = static_cast<std::int64_t>(std::floor((p.x() - low_.x()) / (2 * slack_)));
    const auto y = static_cast<std::int64_t>(std::floor((p.y() - low_.y()) / (2 * slack_)));
    for (std::int64_t dx = -1; dx <= 1; ++dx)
        for (std::int64_t dy = -1; dy <= 1; ++dy)
            if (const auto cell = cells_.find(cell_key(x + dx, y + dy)); cell != cells_.end())
                for (const int id : cell->second)
                    if ((point(id) - p).norm() <= slack_)
                        return id;
    points_.push_back(p);
    cells_[cell_key(x, y)].push_back(size() - 1);
    return size() - 1;
}

std::int64_t CornerIndex::bin(const Vec2 &p) const {
    const auto along = [&](double offset, double extent) {
        const double x = extent > 0 ? offset / extent * n_bins_ : 0;
        return std::clamp(static_cast<std::int64_t>(x), std::int64_t{0}, std::int64_t{n_bins_} - 1);
    };
    return along(p.y() - low_.y(), extent_.y()) * n_bins_ + along(p.x() - low_.x(), extent_.x());
}

void CornerIndex::sort_into_bins() {
    n_bins_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(size()) / 2)));
    bin_start_.assign(static_cast<std::size_t>(n_bins_) * static_cast<std::size_t>(n_bins_) + 1, 0);
    for (const Vec2 &p : points_)
        ++bin_start_[static_cast<std::size_t>(bin(p)) + 1];
    for (std::size_t i = 1; i < bin_start_.size(); ++i)
        bin_start_[i] += bin_start_[i - 1];
    binned_.resize(points_.size());
    std::vector<int> next = bin_start_;
    for (int id = 0; id < size(); ++id)
        binned_[static_cast<std::size_t>(next[static_cast<std::size_t>(bin(point(id)))]++)] = id;
}

std::vector<int> CornerIndex::between(int from, int to) const {
    const Vec2 a = point(from), way = point(to) - a;
    const double length = way.norm();
    std::vector<std::pair<double, int>> found;
    if (length <= slack_)
        return {};
    const Vec2 margin = Vec2::Constant(slack_);
    const std::int64_t low = bin(a.cwiseMin(point(to)) - margin), high = bin(a.cwiseMax(point(to)) + margin);
    for (std::int64_t y = low / n_bins_; y <= high / n_bins_; ++y)
        for (std::int64_t x = low % n_bins_; x <= high % n_bins_; ++x) {
            const auto cell = static_cast<std::size_t>(y * n_bins_ + x);
            for (int k = bin_start_[cell]; k < bin_start_[cell + 1]; ++k) {
                const int id = binned_[static_cast<std::size_t>(k)];
                const Vec2 offset = point(id) - a;
                const double t = offset.dot(way) / length;
                if (id != from && id != to && t > 0 && t < length && std::abs(cross(way, offset)) / length <= slack_)
                    found.emplace_back(t, id);
            }
        }
    std::sort(found.begin(), found.end());
    std::vector<int> ids;
    for (const auto &[t, id] : found)
        ids.push_back(id);
    return ids;
}

} // namespace penumbra
