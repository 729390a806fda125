// What a scene calls for, as far as its geometry and materials tell before the first step.
#pragma once

#include "core/effects.h"
#include "scene/scene.h"

#include <array>
#include <vector>

namespace penumbra {

/// Channels of which every solution is a multiple of another's: they have the same reflectances, and exitances in a
/// constant proportion; or no exitance at all.
struct Channels {
    std::array<int, 3> of{0, 1, 2};        ///< channel c is factor[c] times channel of[c], which is solved for
    std::array<double, 3> factor{1, 1, 1};

    int n_solved() const; ///< 1 to 3
    bool operator==(const Channels &) const = default;
};

/// Every entry is conservative: it changes no answer by more than rounding, or, where it goes by brightness, by more than
/// the share that it was given. A plan that was made of nothing leaves nothing out.
struct Plan {
    bool emission = true;          ///< something emits
    bool interreflection = true;   ///< light that one surface reflects can reach another that reflects, and weighs there
    /// All that is reflected after so many bounces stays below the share that may be missed; 1: the first one is all.
    int bounces = 1;
    std::vector<char> lit;         ///< by surface: light can come to its front, past half-spaces alone; empty: all
    std::vector<char> is_back;     ///< by surface: the second side of a double-sided face, or of two faces back to back; empty: none
    std::vector<char> can_block;   ///< by surface: some of the scene lies on either side of its plane; empty: all
    Channels channels;

    bool is_lit(SurfaceId s) const { return lit.empty() || lit[s.at()] != 0; }
    bool is_second_side(SurfaceId s) const { return !is_back.empty() && is_back[s.at()] != 0; }
    bool anything_blocks() const;
};

/// Decides what switches leave to it; what is on is left whole, what is off is left
/// out. `may_miss`: relative L2 of B - E that light after the last bounce may be. tests/agreement/effects_test.cpp.
Plan make_plan(const Scene &scene, const EffectSwitches &switches, double may_miss);

/// The scene as it is solved: where colour is off, with the mean of the channels of every material.
Scene without_colour(Scene scene);

/// Whether light reflected by any surface can reach no other reflecting surface, judged conservatively (half-spaces):
/// then the direct solution is the whole solution.
bool has_one_bounce(const Scene &scene);

} // namespace penumbra
