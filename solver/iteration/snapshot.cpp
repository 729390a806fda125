#include "iteration/snapshot.h"

#include "basis/element_basis.h"
#include "basis/legendre.h"

namespace penumbra {

std::string_view name(Phase phase) {
    switch (phase) {
    case Phase::start:
        return "start";
    case Phase::refined:
        return "refine";
    case Phase::gathered:
        return "gather";
    case Phase::pushed_pulled:
        return "push-pull";
    }
    return "";
}

Rgb radiosity_at(const Snapshot &snapshot, const SnapshotPatch &patch, double u, double v) {
    const auto a = legendre(u), b = legendre(v);
    Rgb sum = Rgb::Zero();
    for (int i = 0, k = patch.first; i < patch.order; ++i)
        for (int j = 0; j < patch.order; ++j, ++k)
            sum += a[static_cast<std::size_t>(i)] * b[static_cast<std::size_t>(j)] *
                   snapshot.coefficients[static_cast<std::size_t>(k)];
    return sum;
}

Rgb radiosity(const Snapshot &snapshot, const SnapshotPatch &patch, const Vec2 &p) {
    const BasisValues value = ElementBasis(patch.order, BilinearQuad{patch.quad}).evaluate(p);
    Rgb sum = Rgb::Zero();
    for (Eigen::Index k = 0; k < value.size(); ++k)
        sum += value[k] * snapshot.coefficients[static_cast<std::size_t>(patch.first + k)];
    return sum;
}

} // namespace penumbra
