#include "files/write_state.h"

#include "files/curves_json.h"
#include "timeline.h"

namespace penumbra {

namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json triple(const Vector &v) {
    return Json::array({v[0], v[1], v[2]});
}

/// Those that somebody decided.
Json effects(const EffectSwitches &switches) {
    Json out = Json::object();
    for (const Effect effect : all_effects)
        if (switches[effect] != Switch::automatic)
            out[std::string(name(effect))] = name(switches[effect]);
    return out;
}

Json options(const Options &o) {
    return {{"threshold", o.threshold},
            {"tolerance", o.tolerance ? Json(*o.tolerance) : Json()},
            {"basis", name(o.basis)},
            {"order", o.order},
            {"cut", name(o.cut)},
            {"max_depth", o.max_depth},
            {"max_iterations", o.max_iterations},
            {"coarse_correction", name(o.coarse_correction)},
            {"gather", name(o.gather)},
            {"effects", effects(o.effects)}};
}

Json camera(const Camera &c) {
    return {{"eye", triple(c.eye)}, {"target", triple(c.target)}, {"up", triple(c.up)}, {"fov", c.fov_y}};
}

Json picture(const SavedPicture &p, bool transparent) {
    return {{"width", p.width},   {"height", p.height}, {"lettered", p.lettered},       {"priced", p.priced},
            {"labels", p.labels}, {"supersample", p.supersample}, {"transparent", transparent}};
}

Json range(const std::optional<Range> &r) { return r ? Json::array({r->low, r->high}) : Json(); }

/// All but the bookmarks and the format.
Json view_json(const SavedState &s) {
    const Look &look = s.look;
    Json strategies = Json::array();
    for (const Strategy strategy : s.strategies)
        strategies.push_back(name(strategy));
    Json reconstructed = Json::array();
    for (std::size_t i = 0; i < s.strategies.size(); ++i)
        reconstructed.push_back(i < s.reconstructed.size() && s.reconstructed[i]);
    Json j;
    j["scene"] = s.scene;
    j["file"] = s.file.empty() ? Json() : Json(s.file);
    j["up"] = s.up ? Json(std::string(1, *s.up)) : Json();
    j["moves"] = Json::array();
    for (const ObjectMove &m : s.moves)
        j["moves"].push_back({{"surface", m.surface}, {"offset", triple(m.offset)}, {"scale", m.scale}});
    j["options"] = options(s.options);
    j["position"] = s.position;
    j["iteration"] = iteration_of(s.position);
    j["phase"] = name(phase_of(s.position));
    j["positions"] = s.positions;
    j["split"] = s.split ? Json(*s.split) : Json();
    j["linking"] = s.linking ? Json(*s.linking) : Json();
    j["converged"] = s.converged;
    j["layout"] = name(s.layout.value_or(layout_of(s.strategies.size())));
    j["wipe"] = s.wipe;
    j["strategies"] = strategies;
    j["reconstructed"] = reconstructed;
    j["active"] = s.active;
    j["camera"] = s.camera ? camera(*s.camera) : Json();
    j["cameras"] = Json::array();
    for (const Camera &c : s.cameras)
        j["cameras"].push_back(camera(c));
    j["tones"] = Json::array();
    for (const Tone &t : s.tones)
        j["tones"].push_back({{"exposure", t.exposure_ev},
                              {"range", range(t.range)},
                              {"range_chosen", t.range_chosen},
                              {"error_range", range(t.error_range)},
                              {"error_range_locked", t.error_range_locked}});
    j["layers"] = {{"mesh", look.layers.mesh},
                   {"curves", look.layers.curves},
                   {"links", look.layers.links},
                   {"fresh", look.emphasise_fresh},
                   {"legend", s.legend}};
    j["curves"] = curves_json(look);
    j["keyhole"] = s.keyhole ? triple(*s.keyhole) : Json();
    j["profile"] = s.profile ? Json::array({triple(s.profile->first), triple(s.profile->second)}) : Json();
    j["shading"] = name(look.shading);
    j["error"] = {{"kind", name(look.error)},
                  {"range", range(look.error_range)},
                  {"locked", s.error_range_locked},
                  {"change", look.change ? Json(text_of(*look.change)) : Json()}};
    j["false_colour"] = look.false_colour;
    j["exposure"] = look.exposure_ev;
    j["range"] = range(look.range);
    j["range_chosen"] = s.range_chosen;
    j["background"] = look.theme == Theme::dark ? "dark" : "light";
    j["picture"] = s.picture ? picture(*s.picture, look.transparent) : Json();
    j["caption"] = s.caption;
    return j;
}

} // namespace

Json state_json(const SavedState &s) {
    Json j;
    j["format"] = state_format;
    j["written_by"] = "penumbra " PENUMBRA_VERSION;
    j.update(view_json(s));
    j["bookmarks"] = Json::array();
    for (const SavedState &bookmark : s.bookmarks)
        j["bookmarks"].push_back(view_json(bookmark));
    return j;
}

std::string state_text(const SavedState &state) {
    return state_json(state).dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace penumbra
