#include "iteration/take_snapshot.h"

#include "iteration/critical_surface.h"
#include "iteration/linking_words.h"
#include "iteration/quadratic.h"

#include <atomic>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace penumbra {

namespace {

std::atomic<std::uint64_t> versions{0};

SnapshotSurface surface_of(const Scene &scene, SurfaceId id) {
    const Surface &s = scene.surface(id);
    const double size = scene.own.size;
    SnapshotSurface out{scene.own.to_own(s.frame.origin), s.frame.u, s.frame.v, s.frame.normal, {}, {},
                        scene.reflectance(id), scene.exitance(id), s.name};
    for (const Vec2 &p : s.outline)
        out.outline.push_back(size * p);
    for (const Polygon &cover : s.covers)
        for (auto &polygon = out.covers.emplace_back(); const Vec2 &p : cover)
            polygon.push_back(size * p);
    return out;
}

/// Distance of a drawn curve from the true one, as a fraction of its receiver's size.
constexpr double polyline_accuracy = 1e-6;

double receiver_size(const Scene &scene, SurfaceId receiver) { return 2 * radius(scene.surface(receiver).outline); }

std::vector<Vec2> corners_of(const Element &e, double size) {
    std::vector<Vec2> corners;
    for (const Vec2 &p : e.basis.outline())
        corners.push_back(size * p);
    return corners;
}

void add_shape(const Element &e, double size, SnapshotPatch &patch) {
    const BilinearQuad quad = e.basis.product_quad();
    for (std::size_t c = 0; c < 4; ++c)
        patch.quad[c] = size * quad.corners[c];
    patch.corners = corners_of(e, size);
    // A quad that is a triangle has a side without length.
    for (std::size_t k = 0; k < e.sides.size(); ++k)
        if (e.basis.planar() || quad.corners[k] != quad.corners[(k + 1) % 4])
            patch.sides.push_back(e.sides[k]);
}

/// Parents stand before their children; the place of an element is that of the split its parent has made.
std::vector<SnapshotPlace> add_splits(const Forest &forest, double size, Snapshot &out) {
    std::vector<SnapshotPlace> places(forest.elements.size());
    for (std::size_t i = 0; i < forest.elements.size(); ++i) {
        const Element &e = forest.elements[i];
        if (e.leaf())
            continue;
        SnapshotSplit split{e.surface.index, e.split, corners_of(e, size), {}, places[i]};
        for (int c = 0; c < e.n_children; ++c) {
            const auto child = static_cast<std::size_t>(e.first_child.index + c);
            split.pieces.push_back({corners_of(forest.elements[child], size), forest.elements[child].filters});
            places[child] = {static_cast<std::int32_t>(out.splits.size()), c};
        }
        out.splits.push_back(std::move(split));
    }
    return places;
}

/// By element: the mean over its area of the square that the fits of its own links and of those of the elements above
/// it miss, reflected, the channels together; negative where nothing was tested.
std::vector<double> missed_squares(const Scene &scene, const State &state) {
    std::vector<double> missed(state.forest.elements.size(), -1);
    for (std::size_t i = 0; i < missed.size(); ++i) { // parents stand before their children
        const Element &e = state.forest.elements[i];
        if (e.parent.valid())
            missed[i] = missed[e.parent.at()];
        for (const auto &interaction : state.interactions[i])
            if (!interaction->weak)
                missed[i] = std::max(missed[i], 0.0) + (scene.reflectance(e.surface).square() *
                                                        interaction->mean_square_misfit(state.forest, state.radiosity))
                                                           .sum();
    }
    return missed;
}

/// A leaf's polynomial, at the end of the coefficients.
void add_polynomial(const Element &leaf, const Coefficients &radiosity, SnapshotPatch &patch,
                    std::vector<Rgb> &coefficients) {
    patch.order = leaf.basis.order();
    patch.first = static_cast<std::int32_t>(coefficients.size());
    const Eigen::MatrixX3d products =
        leaf.basis.product_coefficients(radiosity.middleRows(leaf.first, leaf.basis.n_functions()));
    for (const auto &row : products.rowwise())
        coefficients.push_back(row.transpose().array());
}

Vec3 centre(const Scene &scene, const Element &element) {
    return scene.own.to_own(scene.surface(element.surface).frame.to_space(element.basis.centre()));
}

void add_links(const Scene &scene, const Forest &forest, ElementId receiver, const Interaction &interaction, int linking,
               std::vector<SnapshotLink> &links) {
    for (const Link &link : interaction.links)
        links.push_back({centre(scene, forest[receiver]), centre(scene, forest[link.source]), link_kind(interaction.kind), linking});
}

SnapshotPatch patch_of(const Scene &scene, const State &state, const Element &e, const SnapshotPlace &place,
                       std::vector<Rgb> &coefficients) {
    SnapshotPatch patch;
    patch.surface = e.surface.index;
    add_polynomial(e, state.radiosity, patch, coefficients);
    add_shape(e, scene.own.size, patch);
    patch.depth = static_cast<float>(e.depth());
    patch.fresh = e.born > 0 && e.born == state.counters.iteration;
    patch.at_limit = e.at_limit;
    patch.place = place;
    return patch;
}

/// By element: the split of the last refinement that made it, or -1.
std::vector<int> makers(const State &state) {
    std::vector<int> made_by(state.forest.elements.size(), -1);
    if (!state.events)
        return made_by;
    for (std::size_t k = 0; k < state.events->splits.size(); ++k)
        made_by[state.events->splits[k].element.at()] = static_cast<int>(k);
    for (std::size_t i = 0; i < made_by.size(); ++i) // parents stand before their children
        if (const ElementId parent = state.forest.elements[i].parent; parent.valid() && made_by[i] < 0)
            made_by[i] = made_by[parent.at()];
    for (const SplitEvent &event : state.events->splits)
        made_by[event.element.at()] = -1;
    return made_by;
}

void add_events(const Scene &scene, const State &state, const std::vector<SnapshotPlace> &places,
                const std::vector<int> &made_by, Snapshot &out) {
    if (!state.events)
        return;
    auto events = std::make_shared<std::vector<SnapshotEvent>>();
    for (const SplitEvent &event : state.events->splits) {
        const Element &e = state.forest[event.element];
        SnapshotEvent &drawn = events->emplace_back();
        drawn.element = patch_of(scene, state, e, places[event.element.at()], out.coefficients);
        drawn.split = places[e.first_child.at()].split;
        drawn.cut = event.cut;
        drawn.curve = event.curve ? event.curve->index : -1;
        drawn.source = event.source.index;
        drawn.misfit = event.misfit;
        drawn.threshold = event.threshold;
        drawn.n_coefficients = e.basis.n_functions();
        for (const auto &interaction : event.handed_down)
            add_links(scene, state.forest, event.element, *interaction, -1, drawn.links);
        drawn.sentence = event.sentence;
    }
    for (std::size_t i = 0; i < made_by.size(); ++i)
        if (made_by[i] >= 0 && state.forest.elements[i].leaf())
            ++(*events)[static_cast<std::size_t>(made_by[i])].n_pieces;
    out.events = std::move(events);
}

void add_linkings(const Scene &scene, const State &state, Snapshot &out) {
    if (!state.events)
        return;
    auto linkings = std::make_shared<std::vector<SnapshotLinking>>();
    for (const LinkEvent &event : state.events->links) {
        const Element &receiver = state.forest[event.made->receiver];
        SnapshotLinking &drawn = linkings->emplace_back();
        for (const Vec2 &p : receiver.basis.outline())
            drawn.receiver.push_back(scene.own.to_own(scene.surface(receiver.surface).frame.to_space(p)));
        if (event.replaced)
            add_links(scene, state.forest, event.replaced->receiver, *event.replaced, -1, drawn.replaced);
        drawn.sentence = linking_words(scene, state.forest, event);
    }
    out.linkings = std::move(linkings);
}

/// By what they made.
std::unordered_map<const Interaction *, int> linkings_of(const State &state) {
    std::unordered_map<const Interaction *, int> numbers;
    if (state.events)
        for (std::size_t k = 0; k < state.events->links.size(); ++k)
            numbers[state.events->links[k].made.get()] = static_cast<int>(k);
    return numbers;
}

} // namespace

std::shared_ptr<Snapshot> take_snapshot(const Setting &setting, const State &state) {
    const Scene &scene = *setting.scene;
    auto out = std::make_shared<Snapshot>();
    out->version = ++versions;
    out->scene = scene.name;
    out->options = setting.options;
    out->phase = state.phase;
    out->counters = state.counters;
    out->curves = state.drawn_curves;
    out->peak = state.peak;
    out->sentence = state.sentence;
    out->effects = ledger(scene, setting.options, setting.plan, state.counters);
    for (int s = 0; s < scene.n_surfaces(); ++s)
        out->surfaces.push_back(surface_of(scene, SurfaceId(s)));
    const std::vector<double> missed = missed_squares(scene, state);
    const std::vector<SnapshotPlace> places = add_splits(state.forest, scene.own.size, *out);
    const std::vector<int> made_by = makers(state);
    const auto linkings = linkings_of(state);
    for (std::size_t i = 0; i < state.forest.elements.size(); ++i) {
        const Element &e = state.forest.elements[i];
        for (const auto &interaction : state.interactions[i]) {
            const auto made = linkings.find(interaction.get());
            add_links(scene, state.forest, ElementId(i), *interaction, made == linkings.end() ? -1 : made->second, out->links);
        }
        if (!e.leaf())
            continue;
        out->patches.push_back(patch_of(scene, state, e, places[i], out->coefficients));
        if (missed[i] >= 0)
            out->patches.back().estimate = scene.own.size * std::sqrt(missed[i] * e.basis.area());
    }
    add_events(scene, state, places, made_by, *out);
    add_linkings(scene, state, *out);
    return out;
}

std::shared_ptr<Snapshot> take_snapshot(const Setting &setting, const State &state, const QuadraticField &field) {
    auto out = take_snapshot(setting, state);
    out->reconstructed = true;
    out->counters.estimated_error = out->counters.error_limit = out->counters.error_bound = -1;
    out->coefficients.clear();
    out->events.reset(); // which are of the constants
    out->linkings.reset();
    auto patch = out->patches.begin();
    for (const Element &e : field.forest.elements)
        if (e.leaf()) {
            patch->estimate = -1;
            add_polynomial(e, field.radiosity, *patch++, out->coefficients);
        }
    return out;
}

SnapshotCurve draw_curve(const Scene &scene, const Curve &curve) {
    const PlaneFrame &frame = scene.surface(curve.receiver).frame;
    SnapshotCurve drawn{static_cast<std::int32_t>(curve.kind), curve.order, curve.source.index, curve.receiver.index,
                        {}, {}};
    for (const SurfaceId b : curve.blockers)
        drawn.blockers.push_back(b.index);
    for (const Vec2 &p : polyline(curve, polyline_accuracy * receiver_size(scene, curve.receiver)))
        drawn.points.push_back(scene.own.to_own(frame.to_space(p)));
    drawn.touched = touched_edges(scene, curve);
    return drawn;
}

} // namespace penumbra
