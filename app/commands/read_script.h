// Scripts of the viewer, in words that people write and the window records.
#pragma once

#include "script.h"

#include <filesystem>

namespace penumbra {

/// A line each, # begins a comment:
///   ACTION [TIMES]      any action by its name: solve.step 3, layers.mesh, view.two
///   open SCENE          a bundled scene's name or a file
///   go ITERATION [PHASE [SPLITS | links PAIRS]]   PHASE: refine, gather or push-pull (the iteration's end); or go end
///   panes STRATEGY... [LAYOUT]   one, two or four of a, b, c, d; two of them also in one place: wipe, flip or difference
///   set OPTIONS         as `penumbra solve` has them: set --threshold 0.01 --order 3
///   show OPTIONS        as `penumbra render` has them: show --view "3 -4 3 0 0 0 30" --exposure 1
///   say TEXT            a caption; nothing: none
///   picture FILE.png    of the panes, below `pictures`
///   window FILE.png     of the whole window
///   wait SECONDS        times `pace`
/// and what script_words.h adds for what the mouse does.
/// Throws BadInput with file and line for what is none of these.
Script read_script(const std::filesystem::path &file, const std::filesystem::path &pictures, double pace);

} // namespace penumbra
