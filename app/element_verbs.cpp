#include "element_verbs.h"

#include <algorithm>

namespace penumbra {

void pick_element(AppState &state, const SurfacePoint &at) {
    state.element.at = at;
    state.element.cursor.reset();
    state.halted = false;
}

void pick_source(AppState &state, int source) {
    std::optional<int> &picked = state.element.source;
    picked = picked == source ? std::nullopt : std::optional(source);
    state.element.cursor.reset();
    state.halted = false;
}

void set_xray_line(AppState &state, XrayLine line) {
    state.element.line = line;
    state.element.cursor.reset();
    state.halted = false;
}

std::optional<Inspection> inspection(const AppState &state) {
    const ElementMode &mode = state.element;
    if (state.inspector != Inspector::element || !mode.at)
        return std::nullopt;
    return Inspection{{state.active_strategy(), state.position}, {mode.at->surface, mode.at->point, mode.source, mode.line}};
}

bool awaits_report(const AppState &state) {
    const auto asked = inspection(state);
    const auto snapshot = state.active_solution();
    const ElementMode &mode = state.element;
    return asked && snapshot && !state.halted &&
           !(mode.strategy == asked->stand.strategy && mode.answered == asked->question && mode.version == snapshot->version);
}

const ElementReport *shown_report(const AppState &state) {
    const auto snapshot = state.active_solution();
    const ElementMode &mode = state.element;
    const bool of_this = snapshot && mode.strategy == state.active_strategy() && mode.version == snapshot->version;
    return of_this ? mode.shown.get() : nullptr;
}

const LinkReport *picked_links(const AppState &state) {
    const ElementReport *report = shown_report(state);
    if (!report || !state.element.source)
        return nullptr;
    const auto found = std::ranges::find(report->links, *state.element.source, &LinkReport::source);
    return found == report->links.end() ? nullptr : &*found;
}

} // namespace penumbra
