// glTF 2.0, text and binary: any bytes as the scene, beside a buffer file that is there (three corners of a triangle,
// as floats, and then the indices 0 1 2 as shorts).
#include "scene/read_gltf.h"
#include "fuzz/sound.h"

#include <cstring>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    using namespace penumbra;
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    const auto buffer = [](const std::string &name) -> std::optional<std::string> {
        if (name != "b.bin")
            return std::nullopt;
        const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const std::uint16_t indices[] = {0, 1, 2};
        std::string out(sizeof corners + sizeof indices, '\0');
        std::memcpy(out.data(), corners, sizeof corners);
        std::memcpy(out.data() + sizeof corners, indices, sizeof indices);
        return out;
    };
    fuzz::expect_sound([&] { return read_gltf_bytes("scene.gltf", bytes, buffer); });
    return 0;
}
