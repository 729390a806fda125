// Links of two whole surfaces, for tests of their coefficients.
#pragma once

#include "reference/faces.h"

#include "transport/interaction.h"

#include <gtest/gtest.h>

namespace penumbra {

/// Two faces, planted with elements of one order.
struct Pair {
    Pair(const reference::Face &p, const reference::Face &q, int order)
        : scene(reference::scene_of({p, q})), blockers(*scene), forest(plant(*scene, order)) {}

    /// The only link from one to the other, at this accuracy.
    Link link(SurfaceId receiver, SurfaceId source, double accuracy, Work &work) const {
        const Transport transport{*scene, blockers, accuracy};
        const auto made = connect(transport, forest, forest.roots[receiver.at()].at(0), source,
                                  all_candidates(transport, receiver, source), forest.roots[source.at()], {}, work);
        EXPECT_EQ(made->links.size(), 1U);
        return made->links.at(0);
    }
    Eigen::MatrixXd kernel(SurfaceId receiver, SurfaceId source, double accuracy, Work &work) const {
        return link(receiver, source, accuracy, work).kernel;
    }
    Eigen::MatrixXd kernel(int receiver, int source, double accuracy) const {
        Work work;
        return kernel(SurfaceId(receiver), SurfaceId(source), accuracy, work);
    }

    std::shared_ptr<const Scene> scene;
    Blockers blockers;
    Forest forest;
};

/// A rectangle length x depth in z = 0 that looks up, its first side along x, and one length x height that is hinged to
/// that side and turned up by `angle`, looking at the first; `shift` moves it along the hinge.
inline reference::Face lying(double length, double depth) {
    return {{{0, 0, 0}, {length, 0, 0}, {length, depth, 0}, {0, depth, 0}}};
}
inline reference::Face turned_up(double length, double height, double angle, double shift = 0) {
    const Vec3 up(0, height * std::cos(angle), height * std::sin(angle)), from(shift, 0, 0), to(shift + length, 0, 0);
    return {{to, from, from + up, to + up}};
}

} // namespace penumbra
