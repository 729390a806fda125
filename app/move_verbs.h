// Lights, blockers and all else, moved by hand; the solution follows.
#pragma once

#include "app_state.h"

namespace penumbra {

/// The object that a surface (or its back) is part of is in hand from now on; -1: none is.
void choose_object(AppState &state, int surface);
/// Where the object in hand has come to, from its place in the file; none in hand: nothing has moved.
ObjectMove move_in_hand(const AppState &state);
/// Has it there, of that size. What cannot be is told and not done.
void move_object(AppState &state, const ObjectMove &move);
/// All objects where the file has them.
void put_objects_back(AppState &state);
/// Takes these moves of the original scene for the present ones; see history.h.
void set_moves(AppState &state, std::shared_ptr<const Scene> scene, const std::vector<ObjectMove> &moves);

/// The same, the scene made from them; throws BadInput where it cannot be.
void set_moves(AppState &state, const std::vector<ObjectMove> &moves);

/// "lamp", or "surface 3" where it has no name.
std::string object_name(const Scene &scene, int surface);

} // namespace penumbra
