#include "baseline.h"

#include "ssim.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace penumbra {

std::filesystem::path baseline(const std::string &name) {
    return std::filesystem::path(PENUMBRA_SOURCE_DIR) / "tests/golden/baselines" / (name + ".png");
}

void expect_golden(const std::string &name, const Image &drawn) {
    if (std::getenv("PENUMBRA_WRITE_BASELINES") != nullptr) {
        write_png(baseline(name), drawn);
        FAIL() << "baseline written: look at " << baseline(name) << " and run again without PENUMBRA_WRITE_BASELINES";
    }
    ASSERT_TRUE(std::filesystem::exists(baseline(name))) << "no baseline " << baseline(name);
    const double likeness = ssim(drawn, read_png(baseline(name)));
    if (likeness < alike)
        write_png(name + "-drawn.png", drawn);
    EXPECT_GE(likeness, alike) << "drawn: " << std::filesystem::absolute(name + "-drawn.png");
}

} // namespace penumbra
