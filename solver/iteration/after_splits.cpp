#include "iteration/after_splits.h"

#include "core/check.h"

#include <algorithm>
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

/// Links are those before the n-th linking; links that were replaced then are there.
void take_back_linkings(int n, Snapshot &out) {
    std::erase_if(out.links, [&](const SnapshotLink &l) { return l.linking >= n; });
    for (int k = n; k < n_linkings(out); ++k) {
        const auto &replaced = (*out.linkings)[static_cast<std::size_t>(k)].replaced;
        out.links.insert(out.links.end(), replaced.begin(), replaced.end());
    }
}

} // namespace

int n_linkings(const Snapshot &snapshot) { return snapshot.linkings ? static_cast<int>(snapshot.linkings->size()) : 0; }

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
    take_back_linkings(0, *out);
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

std::uint64_t version_after_linkings(const Snapshot &whole, int n) { return version_after(whole, n_events(whole) + 1 + n); }

std::shared_ptr<const Snapshot> after_linkings(const Snapshot &whole, int n) {
    PENUMBRA_CHECK(n, >=, 0);
    PENUMBRA_CHECK(n, <=, n_linkings(whole));
    auto out = std::make_shared<Snapshot>(whole);
    if (!whole.linkings)
        return out;
    take_back_linkings(n, *out);
    for (SnapshotPatch &p : out->patches)
        p.fresh = false;
    out->counters.links = static_cast<decltype(out->counters.links)>(out->links.size());
    out->sentence = n > 0 ? (*whole.linkings)[static_cast<std::size_t>(n - 1)].sentence : "all splits made, nothing linked yet";
    out->n_shown_linkings = n;
    out->version = version_after_linkings(whole, n);
    return out;
}

std::uint64_t version_of(const Snapshot &whole, const RefinementPart &part) {
    if (part.splits && n_events(whole) > 0)
        return version_after(whole, std::clamp(*part.splits, 0, n_events(whole)));
    if (!part.splits && part.linkings && n_linkings(whole) > 0)
        return version_after_linkings(whole, std::clamp(*part.linkings, 0, n_linkings(whole)));
    return whole.version;
}

std::shared_ptr<const Snapshot> part_of(const Snapshot &whole, const RefinementPart &part) {
    if (part.splits && n_events(whole) > 0)
        return after_splits(whole, std::clamp(*part.splits, 0, n_events(whole)));
    if (!part.splits && part.linkings && n_linkings(whole) > 0)
        return after_linkings(whole, std::clamp(*part.linkings, 0, n_linkings(whole)));
    return nullptr;
}

} // namespace penumbra
