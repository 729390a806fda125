// What real files need before their faces are surfaces.
#pragma once

#include "scene/build_scene.h"

#include <map>

namespace penumbra {

/// Notes of one kind are many in a large file: the first few are kept whole, the others counted.
class Notes {
public:
    void add(const std::string &kind, std::string text);
    void append_to(std::vector<std::string> &notes) const;

private:
    struct Kind {
        std::vector<std::string> first;
        int n = 0;
    };
    std::map<std::string, Kind> kinds_;
};

/// Faces are flattened when their corners lie within this of their mean plane, as a fraction of the face's size.
inline constexpr double flat_within = 1e-6;
/// Corners nearer to each other, or to the line through their neighbours, than this are dropped (unit size).
inline constexpr double same_within = 1e-12;

/// Planar simple polygons that a face of a normalised scene stands for: none when it has no area, one as a rule, and
/// triangles when it is bent by more than `flat_within`. Throws BadInput for a polygon that crosses or touches itself.
std::vector<std::vector<Vec3>> mend(const RawFace &face, Notes &notes);

} // namespace penumbra
