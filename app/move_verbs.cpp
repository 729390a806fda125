#include "move_verbs.h"

#include "core/error.h"
#include "verbs.h"

#include <algorithm>
#include <utility>

namespace penumbra {

void choose_object(AppState &state, int surface) {
    state.objects.grabbed.reset();
    state.objects.chosen = -1;
    if (!state.scene || surface < 0 || surface >= state.scene->n_surfaces())
        return;
    state.objects.chosen = object_surfaces(*state.scene, SurfaceId(surface)).front();
}

ObjectMove move_in_hand(const AppState &state) {
    const ObjectsMode &mode = state.objects;
    const auto found = std::ranges::find(mode.moves, mode.chosen, &ObjectMove::surface);
    ObjectMove none;
    none.surface = mode.chosen;
    return found == mode.moves.end() ? none : *found;
}

void set_moves(AppState &state, std::shared_ptr<const Scene> scene, const std::vector<ObjectMove> &moves) {
    ObjectsMode &mode = state.objects;
    for (int pane = 0; pane < n_panes(state.layout); ++pane)
        if (auto now = state.solution(pane))
            mode.shown_before[static_cast<std::size_t>(pane)] = std::move(now);
    mode.moves = moves;
    replace_scene(state, std::move(scene));
}

void set_moves(AppState &state, const std::vector<ObjectMove> &moves) {
    const auto &original = state.objects.original;
    set_moves(state, moves.empty() ? original : std::make_shared<const Scene>(with_moves(*original, moves)), moves);
}

void move_object(AppState &state, const ObjectMove &move) {
    ObjectsMode &mode = state.objects;
    if (!mode.original || move.surface < 0 || move == move_in_hand(state))
        return;
    std::vector<ObjectMove> moves = mode.moves;
    std::erase_if(moves, [&](const ObjectMove &m) { return m.surface == move.surface; });
    ObjectMove none;
    none.surface = move.surface;
    if (move != none)
        moves.push_back(move);
    std::ranges::sort(moves, {}, &ObjectMove::surface);
    try {
        set_moves(state, moves);
    } catch (const BadInput &e) {
        state.message = {e.what(), true};
    }
}

void put_objects_back(AppState &state) {
    if (state.objects.moves.empty())
        return;
    set_moves(state, std::vector<ObjectMove>());
    state.message = {"Every object is where the file has it.", false};
}

std::string object_name(const Scene &scene, int surface) {
    const std::string &name = scene.surface(SurfaceId(surface)).name;
    return name.empty() ? "surface " + std::to_string(surface) : name;
}

} // namespace penumbra
