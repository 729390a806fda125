// The words of scripts that stand for what the mouse does in panes and panels.
#pragma once

#include "app_state.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace penumbra {

using Act = std::function<bool(AppState &)>;
using Words = std::vector<std::string_view>;

/// A whole number from `least` on; throws BadInput where it is none.
int whole(std::string_view word, int least);
/// ITERATION [PHASE [SPLITS | links PAIRS]], from that word on; throws BadInput.
Place place_from(const Words &words, std::size_t from);

/// What the line does whose first word is one of
///   move SURFACE DX DY DZ [SCALE]   of an object, from where the file has it
///   object SURFACE|none             takes it in hand
///   pick SURFACE X Y Z              for the inspector that is open: an element, or the split that made it
///   xray SURFACE|none [worst]       links from there to the picked element, through its centre or where they miss most
///   filters OUTWARD PIECE           of the picked split: how many splits around it, and which child
///   pivot X Y Z                     views turn about it
///   wipe SHARE                      where the divider of a wipe stands, 0 (left) to 1
///   unpin                           lets go of the curve
///   play [ITERATION [PHASE]]        plays until there; nothing: to the end
///   speed STEPS                     of playing, a second
///   cost MEASURE                    of the plot of costs
///   pictures SIZE SAMPLES [transparent] [no-labels]   SIZE: panes, or as 1920x1080
///   bookmark N, forget N, caption N TEXT
/// Nothing where it is none of these. Throws BadInput for what is wrong in it.
std::optional<Act> act_of_words(const Words &words);

} // namespace penumbra
