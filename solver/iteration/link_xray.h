// Through one link: what a surface really brings along a line over the receiver, and what the link's fit makes of it.
#pragma once

#include "core/ids.h"
#include "core/vec.h"

#include <vector>

namespace penumbra {

class Cancel;
class Oracle;       // iteration/oracle.h
struct Interaction; // transport/interaction.h
struct Setting;     // iteration/state.h
struct State;

/// Which line is looked at: through the centre of the element that was picked, or where the fit misses most.
enum class XrayLine { centre, worst };

struct XrayPoint {
    double at = 0;  ///< from the line's beginning [scene's length unit]
    Rgb exact, fit; ///< T_S and what the links bring of it, reflected [W/m2]
};

/// A point at which the oracle has tested.
struct XrayTest {
    XrayPoint point; ///< `at`: its foot on the line
    double off = 0;  ///< distance from the line
    bool near = false; ///< no farther off than a twentieth of the receiver's breadth
    bool worst = false; ///< of all
};

/// T_S is sampled anew, past every blocker and from all functions of the sources, with the state's radiosity; sources
/// are seen at the level that the links have.
struct LinkXray {
    XrayLine line = XrayLine::centre;
    Vec3 from, to;                  ///< ends of the line, on the receiver's border [scene's own frame]
    double low = 0, high = 0;       ///< the part of it inside the element that was picked; equal: none
    std::vector<XrayPoint> points;  ///< n_xray_points, equally far apart
    std::vector<XrayTest> tests;    ///< all of the oracle's; none of a weak link
    double passes = 0;              ///< misfit that the oracle lets pass [W/m2]
    bool mean_square = false;       ///< as a root mean square over the test points, not at each of them
    int channel = 0;                ///< in which the fit misses most

    double length() const { return (to - from).norm(); }
};
inline constexpr int n_xray_points = 129;

/// The line runs across the receiver along its longer direction. `picked`: the receiver or an element below it.
/// Cancellable. tests/agreement/link_xray_test.cpp.
LinkXray xray(const Setting &setting, const State &state, const Oracle &oracle, ElementId picked,
              const Interaction &interaction, XrayLine line, const Cancel *cancel);

} // namespace penumbra
