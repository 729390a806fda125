#include "files/picture_state.h"

#include "files/curves_json.h"

#include <nlohmann/json.hpp>

namespace penumbra {

std::string picture_state(const PictureSpec &spec, const std::filesystem::path &scene_file) {
    using Json = nlohmann::ordered_json;
    const auto triple = [](const glm::dvec3 &v) { return Json::array({v.x, v.y, v.z}); };
    const Snapshot &first = *spec.panes.front().snapshot;
    const Look &look = spec.look;
    Json strategies = Json::array();
    for (const PicturePane &pane : spec.panes)
        strategies.push_back(name(pane.snapshot->options.strategy));
    Json j;
    j["scene"] = first.scene;
    j["file"] = scene_file.string();
    j["options"] = {{"threshold", first.options.threshold},
                    {"basis", name(first.options.basis)},
                    {"order", first.options.order},
                    {"cut", name(first.options.cut)},
                    {"max_depth", first.options.max_depth}};
    j["iteration"] = first.counters.iteration;
    j["phase"] = name(first.phase);
    j["layout"] = spec.panes.size() == 1 ? "single" : spec.panes.size() == 2 ? "two" : "four";
    j["strategies"] = strategies;
    j["camera"] = {{"eye", triple(spec.camera.eye)},
                   {"target", triple(spec.camera.target)},
                   {"up", triple(spec.camera.up)},
                   {"fov", spec.camera.fov_y}};
    j["layers"] = {{"mesh", look.layers.mesh},
                   {"curves", look.layers.curves},
                   {"links", look.layers.links},
                   {"fresh", look.emphasise_fresh},
                   {"legend", spec.legend}};
    j["curves"] = curves_json(look);
    j["keyhole"] = spec.keyhole ? Json{spec.keyhole->point.x(), spec.keyhole->point.y(), spec.keyhole->point.z()} : Json();
    j["shading"] = name(look.shading);
    j["false_colour"] = look.false_colour;
    j["exposure"] = look.exposure_ev;
    j["range"] = look.range ? Json::array({look.range->low, look.range->high}) : Json();
    j["background"] = look.theme == Theme::dark ? "dark" : "light";
    return j.dump(1);
}

} // namespace penumbra
