// Wavefront MTL: any bytes as the library of a scene that uses some of its materials.
#include "fuzz/sound.h"
#include "scene/read_obj.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    using namespace penumbra;
    const auto library = [&](const std::string &) { return std::string(reinterpret_cast<const char *>(data), size); };
    fuzz::expect_sound([&] {
        return read_obj_text("scene.obj",
                             "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n",
                             library);
    });
    return 0;
}
