// Draws one solution into one rectangle of the current framebuffer. Needs a current GL 4.1 core context, always the
// same one.
#pragma once

#include "iteration/snapshot.h"
#include "render/camera.h"
#include "render/look.h"

#include <memory>
#include <optional>

namespace penumbra {

struct ErrorMap; // iteration/error_map.h

/// Pixels of a framebuffer; x from the left, y from the top, downward.
struct PixelRect {
    int x = 0, y = 0, width = 0, height = 0;
    double aspect() const { return height > 0 ? static_cast<double>(width) / height : 1; }
    bool operator==(const PixelRect &) const = default;
};
/// What both hold; of no width or height where that is nothing.
PixelRect overlap(const PixelRect &a, const PixelRect &b);

class PaneRenderer {
public:
    /// Compiles the passes. Throws Unavailable with the driver's words when it cannot.
    PaneRenderer();
    ~PaneRenderer();
    PaneRenderer(const PaneRenderer &) = delete;
    PaneRenderer &operator=(const PaneRenderer &) = delete;

    /// Brings the snapshot to the GPU, unless its version is the one that is there, and keeps it.
    /// For error pictures it needs the snapshot's map, too; without (null) these show the light itself.
    void upload(std::shared_ptr<const Snapshot> snapshot, std::shared_ptr<const ErrorMap> errors = nullptr);

    /// Clears the rectangle to the theme's background and draws what was uploaded. `framebuffer_height` [pixels] says
    /// where the top is. Leaves blending, depth test and scissor off, and no program or vertex array bound. Lines are
    /// `pixel_scale.factor` pixels wide. With a transparent background colours are multiplied by their alpha.
    /// `part`: the framebuffer holds this part alone of one that would be so high, which may be larger than any that
    /// the driver makes; what lies in the part is drawn as the whole would have it. None: all of it. What lies outside of
    /// `only` stays as it is; none: nothing stays.
    void draw(const Camera &camera, const Look &look, const PixelRect &rect, int framebuffer_height,
              PixelScale pixel_scale = {}, const std::optional<PixelRect> &part = std::nullopt,
              const std::optional<PixelRect> &only = std::nullopt);

    /// Radiosity of what is seen [W/m2], as red, green and blue, with alpha 1 where there is a surface and 0 where
    /// there is none; for a framebuffer of floats without multisampling.
    void draw_values(const Camera &camera, Shading shading, const PixelRect &rect, int framebuffer_height);
    /// The same for errors: point_value() or patch_value() of what is seen, in all three channels, where it reflects.
    void draw_error_values(const Camera &camera, ErrorKind kind, const PixelRect &rect, int framebuffer_height);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace penumbra
