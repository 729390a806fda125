// What a driver does when the graphics card hangs or is taken away.
#pragma once

namespace penumbra::gl {

/// Whether the current context was lost: nothing that is drawn in it appears any more. Always false where it was made
/// without notification of resets (ARB_robustness).
bool context_is_lost();

} // namespace penumbra::gl
