#include "synthetic.h"

#include "render/camera.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace penumbra {
namespace {

/// Place in the frame, [-1, 1], y up.
glm::dvec2 project(const Camera &camera, double aspect, const glm::dvec3 &x) {
    const Bounds box{glm::dvec3(-5), glm::dvec3(5)};
    const glm::dvec4 clip = projection_matrix(camera, aspect, box) * view_matrix(camera) * glm::dvec4(x, 1);
    return glm::dvec2(clip) / clip.w;
}

const Camera camera{{2, -3, 2.5}, {0.1, 0.2, 0.3}, {0, 0, 1}, 40};
const glm::dvec3 point{0.5, 0.6, 0.1};

TEST(Camera, ZoomKeepsThePointInPlace) {
    const Camera nearer = zoom(camera, 0.4, point);
    EXPECT_NEAR(glm::distance(nearer.eye, point), 0.4 * glm::distance(camera.eye, point), 1e-12);
    EXPECT_NEAR(glm::distance(project(nearer, 1.5, point), project(camera, 1.5, point)), 0, 1e-12);
}

TEST(Camera, PanMovesTheAnchorWithTheMouse) {
    const double width = 900, height = 600;
    const Camera moved = pan(camera, 30, -12, height, point); // pixels, y down
    const glm::dvec2 way = project(moved, width / height, point) - project(camera, width / height, point);
    EXPECT_NEAR(way.x * width / 2, 30, 1e-9);
    EXPECT_NEAR(way.y * height / 2, 12, 1e-9);
}

TEST(Camera, OrbitKeepsPivotDistanceAndHorizon) {
    const Camera turned = orbit(camera, 0.7, -0.3, point);
    EXPECT_NEAR(glm::distance(turned.eye, point), glm::distance(camera.eye, point), 1e-12);
    EXPECT_NEAR(glm::distance(project(turned, 1, point), project(camera, 1, point)), 0, 1e-12) << "the pivot stays put";
    EXPECT_GT(glm::distance(turned.eye, camera.eye), 0.5);
    for (const double pitch : {-10.0, 10.0}) { // over the pole
        const Camera steep = orbit(camera, 0, pitch, camera.target);
        const glm::dvec3 forward = glm::normalize(steep.target - steep.eye);
        EXPECT_LT(std::abs(forward.z), 1);
        EXPECT_GT(std::abs(forward.z), 0.999);
    }
}

TEST(Camera, FitShowsTheSceneAndFillsTheFrame) {
    for (const double aspect : {0.6, 1.0, 1.8}) {
        const auto snapshot = synthetic::closed_room();
        const Camera fitted = fit(camera, *snapshot, aspect);
        double reach = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec2 p = project(fitted, aspect, glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1));
            reach = std::max({reach, std::abs(p.x), std::abs(p.y)});
        }
        EXPECT_LT(reach, 1);
        EXPECT_GT(reach, 0.9);
    }
}

TEST(Camera, RayGoesThroughItsPlaceInTheFrame) {
    const glm::dvec3 x = camera.eye + 2.0 * view_ray(camera, 1.6, 0.3, -0.7);
    EXPECT_NEAR(glm::distance(project(camera, 1.6, x), glm::dvec2(0.3, -0.7)), 0, 1e-12);
}

TEST(Camera, ARoomIsSeenLevel) {
    const auto room = synthetic::closed_room();
    const Camera level = default_view(*room, 1);
    EXPECT_NEAR(level.eye.z, level.target.z, 1e-12);
    const auto open = synthetic::lamp_and_blocker();
    const Camera above = default_view(*open, 1);
    EXPECT_GT(above.eye.z, above.target.z + 1);
}

} // namespace
} // namespace penumbra
