#include "visibility/blockers.h"

#include "visibility/embree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace penumbra {

namespace {
constexpr double inflation = 1e-5; // of the unit scene; single precision loses about 1e-7
constexpr double touch = 1e-12;    // heights below this count as in the plane

struct Box {
    Vec3 low, high;
};

Box box_of(const Blocker &b) {
    Box box{b.corners[0], b.corners[0]};
    for (const Vec3 &c : b.corners) {
        box.low = box.low.cwiseMin(c);
        box.high = box.high.cwiseMax(c);
    }
    box.low.array() -= inflation;
    box.high.array() += inflation;
    return box;
}
} // namespace

struct Blockers::Tree {
    EmbreeDevice device;
    EmbreeScene scene;
    std::vector<int> indices; ///< of the blockers in it
    std::vector<Box> boxes;

    Tree(const std::vector<Blocker> &blockers, std::vector<int> in) : device(rtcNewDevice(nullptr)), indices(std::move(in)) {
        for (const int i : indices)
            boxes.push_back(box_of(blockers[static_cast<std::size_t>(i)]));
        scene.reset(rtcNewScene(device.get()));
        rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
        RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
        rtcSetGeometryUserData(geometry, this);
        rtcSetGeometryBoundsFunction(
            geometry,
            [](const RTCBoundsFunctionArguments *args) {
                const Box &box = static_cast<const Tree *>(args->geometryUserPtr)->boxes[args->primID];
                *args->bounds_o = {static_cast<float>(box.low.x()), static_cast<float>(box.low.y()), static_cast<float>(box.low.z()), 0,
                                   static_cast<float>(box.high.x()), static_cast<float>(box.high.y()), static_cast<float>(box.high.z()), 0};
            },
            nullptr);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene.get());
    }
};

Blockers::Blockers(const Scene &scene, std::span<const char> can_block) : solids_(find_solids(scene)), scene_(scene) {
    std::vector<int> near; ///< those that may ever be proposed
    std::vector<int> solid_of(scene.surfaces.size(), -1);
    for (std::size_t i = 0; i < solids_.size(); ++i)
        for (const SurfaceId f : solids_[i].faces)
            solid_of[f.at()] = static_cast<int>(i);
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        const Surface &surface = scene.surfaces[s];
        if (surface.back)
            continue; // its front blocks already
        for (const Polygon &part : surface.parts) {
            Blocker b{SurfaceId(s), {}, surface.frame, solid_of[s]};
            for (const Vec2 &p : part)
                b.corners.push_back(surface.frame.to_space(p));
            (can_block.empty() || can_block[s] ? near : left_out_).push_back(static_cast<int>(blockers_.size()));
            blockers_.push_back(std::move(b));
        }
    }
    tree_ = std::make_unique<Tree>(blockers_, std::move(near));
}

Blockers::~Blockers() = default;

std::vector<int> Blockers::near_box(const Vec3 &low, const Vec3 &high) const {
    struct Search {
        const Tree *tree;
        Vec3 low, high;
        std::vector<int> found;
    } search{tree_.get(), low, high, {}};
    const Vec3 centre = (low + high) / 2;
    RTCPointQuery query;
    query.x = static_cast<float>(centre.x());
    query.y = static_cast<float>(centre.y());
    query.z = static_cast<float>(centre.z());
    query.time = 0;
    query.radius = static_cast<float>((high - low).norm() / 2 + inflation);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(
        tree_->scene.get(), &query, &context,
        [](RTCPointQueryFunctionArguments *args) {
            Search &s = *static_cast<Search *>(args->userPtr);
            const Box &box = s.tree->boxes[args->primID];
            if ((box.low.array() <= s.high.array()).all() && (box.high.array() >= s.low.array()).all())
                s.found.push_back(s.tree->indices[args->primID]);
            return false;
        },
        &search);
    std::ranges::sort(search.found);
    return search.found;
}

bool Blockers::edge_on(int blocker, SurfaceId seen_from) const {
    return std::ranges::all_of(scene_.surface(seen_from).corners,
                               [&](const Vec3 &x) { return std::abs((*this)[blocker].frame.height(x)) <= touch; });
}

int Blockers::n_left_out_near(const Vec3 &low, const Vec3 &high, SurfaceId receiver, SurfaceId source) const {
    return static_cast<int>(std::ranges::count_if(left_out_, [&](int i) {
        const Box box = box_of((*this)[i]);
        const SurfaceId s = (*this)[i].surface;
        return !edge_on(i, receiver) && s != source && (box.low.array() <= high.array()).all() && (box.high.array() >= low.array()).all();
    }));
}

bool Blockers::outside(int solid, std::span<const Vec3> points) const {
    return std::ranges::any_of(solids_[static_cast<std::size_t>(solid)].faces, [&](SurfaceId f) {
        const PlaneFrame &frame = scene_.surface(f).frame;
        return std::ranges::all_of(points, [&](const Vec3 &x) { return frame.height(x) >= -touch; });
    });
}

} // namespace penumbra
