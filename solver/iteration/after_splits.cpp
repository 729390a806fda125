#include "iteration/after_splits.h"

#include "core/check.h"

#include <utility>

namespace penumbra {

namespace {

/// By split of the snapshot: the event that it belongs to, or -1.
std::vector<int> events_of_splits(const Snapshot &snapshot) {
    std::vector<int> events(snapshot.splits.size(), -1);
    for (std::size_t k = 0; k < snapshot.events->size(); ++k)
        events[static_cast<std::size_t>((*snapshot.events)[k].split)] = static_cast<int>(k);
    for (std::size_t i = 0; i < events.size(); ++i) // an element's before its pieces'
        if (const int above = snapshot.splits[i].place.split; above >= 0 && events[i] < 0)
            events[i] = events[static_cast<std::size_t>(above)];
    return events;
}

} // namespace

int n_events(const Snapshot &snapshot) { return snapshot.events ? static_cast<int>(snapshot.events->size()) : 0; }

std::uint64_t version_after(const Snapshot &whole, int n) {
    constexpr int bits_of_snapshots = 40;
    return whole.version | static_cast<std::uint64_t>(n + 1) << bits_of_snapshots;
}

std::shared_ptr<const Snapshot> after_splits(const Snapshot &whole, int n) {
    PENUMBRA_CHECK(n, >=, 0);
    PENUMBRA_CHECK(n, <=, n_events(whole));
    auto out = std::make_shared<Snapshot>(whole);
    if (!whole.events)
        return out;
    const std::vector<int> events = events_of_splits(whole);
    const auto maker = [&](const SnapshotPatch &p) { return p.place.split < 0 ? -1 : events[static_cast<std::size_t>(p.place.split)]; };
    std::erase_if(out->patches, [&](const SnapshotPatch &p) { return maker(p) >= n; });
    for (SnapshotPatch &p : out->patches)
        p.fresh = n > 0 && maker(p) == n - 1;
    std::erase_if(out->links, [&](const SnapshotLink &l) { return l.event >= n; });
    Counters &c = out->counters;
    for (int k = n; k < n_events(whole); ++k) {
        const SnapshotEvent &event = (*whole.events)[static_cast<std::size_t>(k)];
        out->patches.push_back(event.element);
        out->links.insert(out->links.end(), event.links.begin(), event.links.end());
        c.patches -= event.n_pieces - 1;
        c.coefficients -= event.n_coefficients * (event.n_pieces - 1);
        --c.splits;
        c.cuts -= event.cut;
    }
    c.links = static_cast<decltype(c.links)>(out->links.size());
    out->sentence = n > 0 ? (*whole.events)[static_cast<std::size_t>(n - 1)].sentence : "before the first split";
    out->n_shown_events = n;
    out->version = version_after(whole, n);
    return out;
}

} // namespace penumbra
