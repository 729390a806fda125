// A whole picture: panes side by side, labelled, with one legend, or one for each of them that has a tone of its own. The window's pictures and the command line's are both
// made here.
#pragma once

#include "capture.h"
#include "iteration/profile.h"
#include "iteration/snapshot.h"
#include "measure/keyhole.h"
#include "render/camera.h"
#include "render/error_scale.h"
#include "render/look.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace penumbra {

struct PicturePane {
    std::shared_ptr<const Snapshot> snapshot;
    std::string tag; ///< "(a)", or nothing
    std::shared_ptr<const ErrorMap> errors = nullptr; ///< of the snapshot, for error pictures; null: not known
    std::shared_ptr<const Snapshot> minus = nullptr;  ///< the errors are the difference from it; null: they are not
    std::optional<Camera> camera{};                   ///< none: the spec's
    std::optional<Tone> tone{};                       ///< none: the look's; ranges that it lacks are the pane's own
};

struct PictureSpec {
    int width = 1600, height = 1200; ///< pixels
    std::vector<PicturePane> panes;
    int columns = 1;
    /// Two panes in one place, the first left of this share of its width, the second right of it; none: side by side.
    std::optional<double> wipe;
    Camera camera;      ///< of all panes without one of their own
    Look look;          ///< without a range: common_range() of all panes; without one of errors: error_range() of all
    std::shared_ptr<const Keyhole> keyhole; ///< drawn at the right, its point in all panes; null: none
    std::optional<ProfileLine> profile;     ///< drawn in all panes; none: no line
    std::string price;   ///< what two panes took, below the caption; empty: none
    std::string caption; ///< a sentence below the panes, where no curve is in the limelight; empty: none
    double text = 0;    ///< text height [pixels]; 0: from the picture's size
    bool labels = true, legend = true;
    /// Drawn so many times larger and averaged, 1 to 4. Lines and text keep their size in the picture.
    int supersample = 1;
};

/// Aspect (width / height) of one pane of such a picture, for fitting the camera.
double pane_aspect(const PictureSpec &spec);

/// With ranges of what the pane alone shows, where it has none.
Tone with_ranges(Tone tone, const PicturePane &pane, const Look &look);

/// What its panes show, for error_range().
std::vector<Judged> judged(const PictureSpec &spec);

/// Larger pictures are drawn in tiles of at most this side [samples]: no driver's framebuffers are smaller, and the window goes on
/// between two of them.
inline constexpr int largest_tile = 1024;

/// A picture that is drawn tile by tile in the current context, into framebuffers of its own. Each call leaves the bound
/// framebuffer and the ImGui context as they were. Supersampling averages light, not sRGB: mean of a tile's samples after decoding (IEC
/// 61966-2-1). With a transparent look the image has alpha, and labels stand on plates of the theme's background, to be
/// read on anything; over that background it is the picture that is not transparent, but for what a plate covers. tests/golden/tiles_test.cpp
class PictureDrawing {
public:
    explicit PictureDrawing(const PictureSpec &spec, int tile_side = largest_tile);
    ~PictureDrawing();
    PictureDrawing(const PictureDrawing &) = delete;
    PictureDrawing &operator=(const PictureDrawing &) = delete;

    bool draw_tile();     ///< the next; false where there is none left. Throws Unavailable where the driver fails
    double share() const; ///< of the tiles that are drawn
    Image take() &&;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// All of it at once.
Image draw_picture(const PictureSpec &spec, int tile_side = largest_tile);

} // namespace penumbra
