// Saved states: any bytes as the text; what is taken can be drawn, and is written and read again the same.
#include "files/read_state.h"
#include "files/write_state.h"
#include "fuzz/sound.h"

#include <cmath>

namespace penumbra::fuzz {

namespace {

bool finite(const glm::dvec3 &v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound_state(const SavedState &s) {
    const Options &o = s.options;
    expect(o.threshold > 0 && std::isfinite(o.threshold) && o.order >= 1 && o.order <= 4 && o.max_depth >= 0 &&
               o.max_depth <= 20 && o.max_iterations >= 1,
           "options", s.scene);
    expect(!s.strategies.empty() && s.active >= 0 && static_cast<std::size_t>(s.active) < s.strategies.size(), "panes",
           s.scene);
    expect(s.position >= 0 && s.position <= 3'000'000, "position", s.scene);
    if (s.camera) {
        const glm::dmat4 view = view_matrix(*s.camera);
        expect(finite(view[0]) && finite(view[1]) && finite(view[2]) && finite(view[3]), "camera", s.scene);
    }
    expect(!s.keyhole || s.keyhole->allFinite(), "keyhole", s.scene);
    expect(!s.look.range || s.look.range->low < s.look.range->high, "range", s.scene);
    expect(s.look.curve_filter.source >= -1 && s.look.spotlight.curve >= -1, "curves", s.scene);
    expect(!s.picture || (s.picture->width >= 64 && s.picture->width <= 16384 && s.picture->height >= 64 &&
                          s.picture->height <= 16384 && s.picture->supersample >= 1 && s.picture->supersample <= 4),
           "picture", s.scene);
    for (const std::string &note : s.notes)
        expect_one_line(note);
}

} // namespace

} // namespace penumbra::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    using namespace penumbra;
    fuzz::expect_refusal_in_one_line([&] {
        const SavedState state = read_state("a.penumbra.json", {reinterpret_cast<const char *>(data), size});
        fuzz::expect_sound_state(state);
        const std::string text = state_text(state);
        fuzz::expect(state_text(read_state("again", text)) == text, "is not read back the same", state.scene);
    });
    return 0;
}
