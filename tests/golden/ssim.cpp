#include "ssim.h"

namespace penumbra {
namespace {

double luminance(const Image &image, int x, int y) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    return 0.2126 * image.rgb[i] + 0.7152 * image.rgb[i + 1] + 0.0722 * image.rgb[i + 2];
}

} // namespace

double ssim(const Image &a, const Image &b) {
    if (a.width != b.width || a.height != b.height)
        return 0;
    constexpr int window = 8, stride = 4;
    constexpr double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    double sum = 0;
    int n_windows = 0;
    for (int y0 = 0; y0 + window <= a.height; y0 += stride)
        for (int x0 = 0; x0 + window <= a.width; x0 += stride) {
            double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
            for (int y = y0; y < y0 + window; ++y)
                for (int x = x0; x < x0 + window; ++x) {
                    const double p = luminance(a, x, y), q = luminance(b, x, y);
                    sa += p;
                    sb += q;
                    saa += p * p;
                    sbb += q * q;
                    sab += p * q;
                }
            constexpr double n = window * window;
            const double ma = sa / n, mb = sb / n, va = saa / n - ma * ma, vb = sbb / n - mb * mb, cov = sab / n - ma * mb;
            if (va < 1e-9 && vb < 1e-9 && ma == mb)
                continue;
            sum += (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
            ++n_windows;
        }
    return n_windows > 0 ? sum / n_windows : 1;
}

} // namespace penumbra
