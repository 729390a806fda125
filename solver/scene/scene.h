// Surfaces as the solver sees them: planar, one-sided, checked, centred and scaled to unit size.
#pragma once

#include "core/ids.h"
#include "core/vec.h"
#include "geometry/plane_frame.h"
#include "geometry/polygon.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct Material {
    std::string name;
    Rgb reflectance = Rgb::Constant(0.5); ///< each channel in [0, 1)
    Rgb exitance = Rgb::Zero();           ///< emitted radiant exitance [W/m2], not negative
};

/// The way from the solver's coordinates, in which the scene's bounding box is centred at 0 and has diagonal 1, to the
/// scene's own frame: x_own = centre + size * x. Radiosity is the same in both.
struct OwnFrame {
    Vec3 centre = Vec3::Zero();
    double size = 1; ///< the bounding box' diagonal

    Vec3 to_own(const Vec3 &x) const { return centre + size * x; }
    Vec3 to_solver(const Vec3 &x) const { return (x - centre) / size; }
};

/// A planar polygon that reflects and emits on its front (counter-clockwise) side and blocks light from both.
struct Surface {
    std::string name;          ///< of the object in the file
    int face = 0;              ///< input face, counted in file order from 0
    bool back = false;         ///< the second side of a double-sided face
    int material = 0;
    std::vector<Vec3> corners; ///< solver coordinates
    PlaneFrame frame;
    Polygon outline;           ///< the corners in the frame's plane
    std::vector<Polygon> parts; ///< convex, of any number of corners; they tile the outline
    /// Convex polygons of other surfaces that lie on this one, in this frame: what they cover is dark and neither
    /// reflects nor emits (the emitter, else the later in file order, lies on top). They may overlap.
    std::vector<Polygon> covers;
    double area = 0; ///< of the outline, covered or not; solver units
};

/// Where a picture of the scene is taken from unless somebody asks for another place; in the scene's own frame.
struct View {
    Vec3 eye, target;
    double fov_degrees = 40; ///< from the lower to the upper border
};

/// Whether p (in the surface's plane) lies under one of its covers.
bool is_covered(const Surface &surface, const Vec2 &p);

struct Scene {
    std::string name;                  ///< as in labels: the file's stem
    std::filesystem::path file;        ///< where it was read from, empty when made in memory
    std::vector<Material> materials;
    std::vector<Surface> surfaces;     ///< by SurfaceId
    OwnFrame own;
    Vec3 up = Vec3::UnitZ();
    std::string description;           ///< one line, empty when the file has none
    std::optional<View> view;          ///< the file's own
    std::vector<std::string> notes;    ///< what was mended or skipped while reading, a line each

    const Surface &surface(SurfaceId s) const { return surfaces[s.at()]; }
    const Material &material(SurfaceId s) const { return materials[static_cast<std::size_t>(surface(s).material)]; }
    const Rgb &reflectance(SurfaceId s) const { return material(s).reflectance; }
    const Rgb &exitance(SurfaceId s) const { return material(s).exitance; }
    bool reflects(SurfaceId s) const { return reflectance(s).maxCoeff() > 0; }
    bool emits(SurfaceId s) const { return exitance(s).maxCoeff() > 0; }
    /// What a surface is called in sentences: its name, or "surface 3".
    std::string words_for(SurfaceId s) const {
        return surface(s).name.empty() ? "surface " + std::to_string(s.index) : surface(s).name;
    }
    int n_surfaces() const { return static_cast<int>(surfaces.size()); }
};

} // namespace penumbra
