#include "scene/normalise.h"

#include "core/error.h"

#include <cmath>

namespace penumbra {

OwnFrame normalise(RawScene &raw) {
    Vec3 low = raw.faces.front().corners.front(), high = low;
    for (const RawFace &face : raw.faces)
        for (const Vec3 &x : face.corners) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    OwnFrame own;
    own.centre = (low + high) / 2;
    own.size = (high - low).stableNorm();
    if (!std::isfinite(own.size) || !own.centre.allFinite())
        throw BadInput(raw.file.string() + ": coordinates are too large for double precision; scale the scene down");
    if (!(own.size > 1e-300))
        throw BadInput(raw.file.string() + ": has no surface; all corners lie in one point");
    for (RawFace &face : raw.faces)
        for (Vec3 &x : face.corners)
            x = own.to_solver(x);
    return own;
}

} // namespace penumbra
