// Structural similarity of two pictures (Wang, Bovik, Sheikh & Simoncelli 2004).
#pragma once

#include "capture.h"

namespace penumbra {

/// Mean over 8x8 windows, 4 pixels apart, of the SSIM of the luminances, in [-1, 1]; 1 for equal pictures. Windows in
/// which both pictures are one flat colour, the same in both, are left out: an empty background must not hide what
/// differs in the small part that is drawn. 0 when the sizes differ.
double ssim(const Image &a, const Image &b);

} // namespace penumbra
