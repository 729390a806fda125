// Wavefront OBJ: any bytes as the scene, beside a material library that is there.
#include "scene/read_obj.h"
#include "fuzz/sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    using namespace penumbra;
    const std::string_view text(reinterpret_cast<const char *>(data), size);
    const auto library = [](const std::string &name) -> std::optional<std::string> {
        if (name != "m.mtl")
            return std::nullopt;
        return "newmtl grey\nKd 0.5 0.5 0.5\nnewmtl lamp\nKd 0.2 0.2 0.2\nKe 10 10 10\n";
    };
    fuzz::expect_sound([&] { return read_obj_text("scene.obj", text, library); });
    return 0;
}
