#include "files/curve_arrangement.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <map>

namespace penumbra {

namespace {

double size_of_scene(const Snapshot &snapshot) {
    Eigen::AlignedBox3d box;
    for (const SnapshotSurface &s : snapshot.surfaces)
        for (const Vec2 &p : s.outline)
            box.extend(s.origin + p.x() * s.u + p.y() * s.v);
    return box.diagonal().norm();
}

} // namespace

std::vector<ReceiverCurves> arrange_receivers(const Snapshot &snapshot) {
    std::map<std::int32_t, ReceiverCurves> by_receiver;
    for (std::size_t c = 0; c < snapshot.curves->size(); ++c) {
        const SnapshotCurve &curve = (*snapshot.curves)[c];
        const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(curve.receiver)];
        ReceiverCurves &found = by_receiver[curve.receiver];
        found.receiver = curve.receiver;
        found.curves.push_back(c);
        std::vector<Vec2> &line = found.lines.emplace_back();
        for (const Vec3 &x : curve.points)
            line.emplace_back((x - surface.origin).dot(surface.u), (x - surface.origin).dot(surface.v));
    }
    const double snap = 1e-9 * size_of_scene(snapshot);
    std::vector<ReceiverCurves> all;
    for (auto &[receiver, curves] : by_receiver) {
        curves.arrangement = arrange(snapshot.surfaces[static_cast<std::size_t>(receiver)].outline, curves.lines, snap);
        all.push_back(std::move(curves));
    }
    return all;
}

std::pair<std::string, std::string> arrangement_json(const Snapshot &snapshot, const ReceiverCurves &curves) {
    const SnapshotSurface &surface = snapshot.surfaces[static_cast<std::size_t>(curves.receiver)];
    using Json = nlohmann::ordered_json;
    Json vertices = Json::array(), edges = Json::array(), faces = Json::array();
    for (const Vec2 &p : curves.arrangement.vertices) {
        const Vec3 x = surface.origin + p.x() * surface.u + p.y() * surface.v;
        vertices.push_back({x.x(), x.y(), x.z()});
    }
    for (const ArrangementEdge &e : curves.arrangement.edges) {
        Json of = Json::array();
        for (const int line : e.lines)
            of.push_back(curves.curves[static_cast<std::size_t>(line)]);
        edges.push_back({{"from", e.from},
                         {"to", e.to},
                         {"left", e.left},
                         {"right", e.right},
                         {"border", e.border},
                         {"curves", std::move(of)}});
    }
    for (const ArrangementFace &f : curves.arrangement.faces)
        faces.push_back({{"area", f.area}, {"outline", f.outline}, {"holes", f.holes}});
    const Json json{{"scene", snapshot.scene},         {"receiver", curves.receiver}, {"name", surface.name},
                    {"vertices", std::move(vertices)}, {"edges", std::move(edges)},   {"faces", std::move(faces)}};
    return {fmt::format("receiver-{}.json", curves.receiver),
            json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"};
}

} // namespace penumbra
