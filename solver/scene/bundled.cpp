#include "scene/bundled.h"

#include "core/error.h"
#include "scene/obj_header.h"
#include "scene/read_obj.h"

namespace penumbra {

std::string BundledScene::description() const { return read_obj_header(obj).description; }

Scene open_scene(const std::string &name, const Vec3 &up) {
    std::error_code none;
    if (std::filesystem::exists(name, none))
        return read_obj(name, up);
    std::string known;
    for (const BundledScene &scene : bundled_scenes()) {
        if (scene.name == name)
            return read_obj_text(
                name + ".obj", scene.obj, [&](const std::string &) { return std::string(scene.mtl); }, up);
        known += (known.empty() ? "" : ", ") + std::string(scene.name);
    }
    throw BadInput(name + ": there is no such file; the bundled scenes are " + known);
}

} // namespace penumbra
