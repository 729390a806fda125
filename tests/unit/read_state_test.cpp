// Saved states: what is written is read back the same, and what is wrong is said in one line.
#include "files/read_state.h"
#include "files/write_state.h"

#include "core/error.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace penumbra {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// Nothing in it is as it would be by default.
EffectSwitches off_and_on() {
    EffectSwitches out;
    out[Effect::order] = Switch::on;
    out[Effect::curves_eee] = Switch::off;
    return out;
}

SavedState unusual() {
    SavedState s;
    s.scene = "room";
    s.file = "../scenes/room.glb";
    s.up = 'y';
    s.options = {.strategy = Strategy::uniform_constant,
                 .basis = BasisFamily::planar,
                 .order = 3,
                 .threshold = 1.0 / 3,
                 .tolerance = 0.1 / 3,
                 .max_depth = 9,
                 .max_iterations = 7,
                 .cut = CutChoice::best,
                 .effects = off_and_on(),
                 .gather = GatherOrder::southwell};
    s.strategies = {Strategy::discontinuity_constant, Strategy::uniform_constant, Strategy::uniform_wavelet};
    s.reconstructed = {true, false, false};
    s.wipe = 1.0 / 3;
    s.cameras = {Camera{{3, 1, 1.0 / 3}, {0, 0, 0}, {0, 0, 1}, 31}, Camera{{0.1, 2, 1}, {0, 1, 0}, {0, 0, 1}, 30}, Camera{{1, 7, 1}, {0, 0, 0}, {0, 1, 0}, 29}};
    s.active = 1;
    s.position = 4;
    s.positions = {3, 4, 10};
    s.tones = {Tone{-1.7, Range{0.1, 1e-3 + 0.1}, Range{1e-5, 1.0 / 3}, true, true}, Tone{0.1 + 0.2, {}, {}, false, false},
               Tone{0, Range{0, 2}, {}, false, false}};
    s.split = 3;
    s.linking = 5;
    s.converged = true;
    s.camera = Camera{{0.1, -1e-17, 1e9}, {2, 3, 5}, {0.6, 0.8, 0}, 0.1 + 0.2};
    s.look.shading = Shading::error;
    s.look.error = ErrorKind::relative;
    s.look.change = EffectChange{Effect::two_sided, Switch::on};
    s.look.error_range = Range{1e-5, 1.0 / 3};
    s.error_range_locked = true;
    s.look.layers = {false, false, true};
    s.look.exposure_ev = -1.7;
    s.look.range = Range{0.1, 1e-3 + 0.1};
    s.look.false_colour = true;
    s.look.emphasise_fresh = false;
    s.look.curve_filter = {{true, false, true, false, false}, {false, true, false}, 12};
    s.look.spotlight.curve = 60;
    s.look.theme = Theme::light;
    s.range_chosen = true;
    s.legend = false;
    s.keyhole = Vec3(0.5, -0.45, 1e-300);
    s.profile = std::pair(Vec3(0.1, -2, 1e7), Vec3(1.0 / 3, 4, 5));
    s.picture = SavedPicture{1000, 777, true, true, false, 3};
    s.look.transparent = true;
    s.moves = {{3, {0.1, -1e-17, 2}, 1.5}};
    s.caption = "Where is \u201cit\u201d lit?";
    s.bookmarks = {SavedState{.scene = "table", .caption = "a"}, SavedState{.scene = "figure-4", .caption = "b"}};
    return s;
}

TEST(ReadState, WhatIsWrittenComesBackToTheLastBit) {
    for (const SavedState &state : {unusual(), SavedState{.scene = "figure-4"}}) {
        const std::string text = state_text(state);
        const SavedState again = read_state("a.penumbra.json", text);
        EXPECT_EQ(state_text(again), text);
        EXPECT_THAT(again.notes, testing::IsEmpty());
    }
    const SavedState s = unusual(), again = read_state("a", state_text(s));
    EXPECT_EQ(again.camera, s.camera);
    EXPECT_EQ(again.cameras, s.cameras);
    EXPECT_EQ(again.positions, s.positions);
    EXPECT_EQ(again.tones, s.tones);
    EXPECT_EQ(again.wipe, s.wipe);
    EXPECT_EQ(again.look, s.look);
    EXPECT_EQ(again.keyhole, s.keyhole);
    EXPECT_EQ(again.profile, s.profile);
    EXPECT_EQ(again.error_range_locked, s.error_range_locked);
    EXPECT_EQ(again.picture, s.picture);
    EXPECT_EQ(again.options.threshold, s.options.threshold);
    EXPECT_EQ(again.options.tolerance, s.options.tolerance);
    EXPECT_EQ(again.options.strategy, Strategy::uniform_constant) << "the active pane's";
    EXPECT_EQ(again.options.gather, GatherOrder::southwell);
    EXPECT_EQ(again.strategies, s.strategies);
    EXPECT_EQ(again.reconstructed, s.reconstructed);
    EXPECT_EQ(again.split, s.split);
    EXPECT_EQ(again.linking, s.linking);
    EXPECT_EQ(again.moves, s.moves);
    EXPECT_EQ(again.caption, s.caption);
    ASSERT_EQ(again.bookmarks.size(), 2u);
    EXPECT_EQ(again.bookmarks[1].scene, "figure-4");
    EXPECT_EQ(again.bookmarks[1].caption, "b");
}

TEST(ReadState, LayoutsOfTwoStrategiesInOnePlaceComeBack) {
    for (const Layout layout : {Layout::wipe, Layout::flip, Layout::difference}) {
        SavedState s{.scene = "figure-4", .strategies = {Strategy::uniform_constant, Strategy::uniform_wavelet}};
        s.layout = layout;
        s.wipe = 0.1 + 0.2;
        const SavedState again = read_state("a", state_text(s));
        EXPECT_EQ(again.layout, layout);
        EXPECT_EQ(again.wipe, s.wipe);
        EXPECT_EQ(again.strategies, s.strategies);
    }
}

TEST(ReadState, FilesBeforeTheWipeStandSideBySide) {
    const SavedState s = read_state("a", R"({"scene": "figure-4", "layout": "two", "strategies": ["uniform-constant", "uniform-wavelet"]})");
    EXPECT_FALSE(s.layout.has_value());
    EXPECT_EQ(s.wipe, 0.5);
}

/// The control: every field of the text that was changed changes what is read.
TEST(ReadState, NoFieldIsIgnored) {
    Json whole = Json::parse(state_text(unusual()));
    for (const char *for_people : {"format", "written_by", "iteration", "phase", "layout"})
        whole.erase(for_people);
    const std::string text = state_text(unusual());
    EXPECT_EQ(state_text(read_state("a", whole.dump())), text);
    for (const auto &[key, value] : whole.items()) {
        Json other = whole;
        if (key == "scene")
            other[key] = "cellar";
        else if (key == "strategies")
            other[key][0] = "uniform-constant";
        else
            other.erase(key);
        EXPECT_NE(state_text(read_state("a", other.dump())), text) << key;
    }
}

TEST(ReadState, WhatIsMissingHasItsDefault) {
    const SavedState s =
        read_state("a", R"({"scene": "figure-4", "camera": null, "range": null, "unheard": [1, {"of": 2}]})");
    SavedState expected;
    expected.scene = "figure-4";
    EXPECT_EQ(state_text(s), state_text(expected));
}

TEST(ReadState, TheFirstPicturesHadIterationAndPhase) {
    const auto position = [](const std::string &fields) {
        return read_state("a", R"({"scene": "figure-4", )" + fields + "}").position;
    };
    EXPECT_EQ(position(R"("iteration": 0, "phase": "start")"), 0);
    EXPECT_EQ(position(R"("iteration": 2, "phase": "refine")"), 4);
    EXPECT_EQ(position(R"("iteration": 2, "phase": "gather")"), 5);
    EXPECT_EQ(position(R"("iteration": 2, "phase": "push-pull")"), 6);
    EXPECT_EQ(position(R"("iteration": 2)"), 6);
}

TEST(ReadState, ALaterFormatIsReadWithANote) {
    const SavedState s = read_state("a", R"({"scene": "x", "format": 7, "written_by": "penumbra 9\n", "position": 3})");
    ASSERT_EQ(s.notes.size(), 1U);
    EXPECT_THAT(s.notes[0], HasSubstr("later version ('penumbra 9?', format 7)"));
    EXPECT_EQ(s.position, 3);
}

std::string refusal(const std::string &text) {
    try {
        read_state("dir/a.penumbra.json", text);
    } catch (const BadInput &e) {
        EXPECT_THAT(e.what(), testing::StartsWith("dir/a.penumbra.json: "));
        EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
        return e.what();
    }
    ADD_FAILURE() << "was taken: " << text;
    return "";
}

TEST(ReadState, EachFaultIsOneLineWithFieldValueAndRemedy) {
    const std::pair<const char *, const char *> faults[] = {
        {R"("format": 0)", "format is 0; give a whole number from 1 to"},
        {R"("scene": 3)", "scene is 3; give a string"},
        {R"("scene": "")", "scene is empty; name a bundled scene"},
        {R"("scene": "a\nb")", "scene has control characters"},
        {R"("file": "a\u0000b")", "file has control characters"},
        {R"("file": [])", "file is an array of 0; give a string"},
        {R"("up": "w")", "up is 'w'; give x, y or z"},
        {R"("options": [1])", "options is an array of 1; give an object"},
        {R"("options": {"threshold": 0})", "options.threshold is 0; give a positive number"},
        {R"("options": {"threshold": -1})", "options.threshold is -1; give a number from 0"},
        {R"("options": {"basis": "cubic"})", "options.basis is 'cubic'; give parametric or planar"},
        {R"("options": {"cut": "all"})", "options.cut is 'all'; give curves or best"},
        {R"("options": {"order": 5})", "options.order is 5; give a whole number from 1 to 4"},
        {R"("options": {"order": 2.5})", "options.order is 2.5; give a whole number from 1 to 4"},
        {R"("options": {"max_depth": 21})", "options.max_depth is 21"},
        {R"("options": {"max_iterations": 0})", "options.max_iterations is 0"},
        {R"("strategies": [])", "strategies has 0 strategies; give 1 to 16"},
        {R"("strategies": ["best"])", "strategies[0] is 'best'; give uniform-constant"},
        {R"("layout": "three")", "layout is 'three'; give single, two, four, wipe, flip or difference"},
        {R"("layout": "wipe")", "layout is 'wipe' with 1 strategy; give two"},
        {R"("strategies": ["uniform-constant", "uniform-wavelet", "uniform-wavelet"], "layout": "difference")",
         "layout is 'difference' with 3 strategies; give two"},
        {R"("wipe": 1.5)", "wipe is 1.5; give a number from 0 to 1"},
        {R"("wipe": -0.01)", "wipe is -0.01; give a number from 0 to 1"},
        {R"("wipe": "middle")", "wipe is 'middle'; give a number"},
        {R"("reconstructed": [false, true])", "reconstructed has 2 flags; give one for each of the 1 strategies"},
        {R"("reconstructed": [true])", "reconstructed[0] is true for a strategy without constants"},
        {R"("active": 1)", "active is 1; give a whole number from 0 to 0"},
        {R"("position": -1)", "position is -1"},
        {R"("iteration": 1, "phase": "push")", "phase is 'push'; give start, refine"},
        {R"("split": 0)", "split is 0; give a whole number from 1"},
        {R"("linking": 0)", "linking is 0; give a whole number from 1"},
        {R"("converged": 1)", "converged is 1; give true or false"},
        {R"("camera": {"eye": [0, 0, 1]})", "camera has no target; give one"},
        {R"("camera": {"eye": [0, 0], "target": [0, 0, 0]})", "camera.eye has 2 numbers; give x, y and z"},
        {R"("camera": {"eye": [0, 0, 1e300], "target": [0, 0, 0]})", "camera.eye[2] is 1e+300; give a number from"},
        {R"("camera": {"eye": [0, 0, 1e999], "target": [0, 0, 0]})", "number beyond double precision"},
        {R"("camera": {"eye": [1, 2, 3], "target": [1, 2, 3]})", "camera has its eye in its target; move"},
        {R"("camera": {"eye": [1, 2, 3], "target": [1, 2, 0]})", "camera looks along its up"},
        {R"("camera": {"eye": [1, 2, 3], "target": [0, 2, 0], "up": [0, 0, 0]})", "camera has an up of length 0"},
        {R"("camera": {"eye": [1, 2, 3], "target": [0, 2, 0], "fov": 180})",
         "camera.fov is 180; give a number from 0.01"},
        {R"("cameras": 3)", "cameras is 3; give an array"},
        {R"("cameras": [{"eye": [1, 2, 3], "target": [0, 0, 0]}, {"eye": [1, 2, 3], "target": [0, 0, 0]}])",
         "cameras has 2 views; give one for each of the 1 strategies, or none"},
        {R"("cameras": [{"eye": [1, 2, 3], "target": [1, 2, 3]}])", "cameras[0] has its eye in its target; move"},
        {R"("strategies": ["uniform-constant", "uniform-wavelet"], "layout": "wipe", "cameras": [{"eye": [1, 2, 3], "target": [0, 0, 0]}])",
         "cameras has 1 views, and layout 'wipe' has one place; leave them out"},
        {R"("positions": [3, 4])", "positions has 2 steps; give one for each of the 1 strategies, or none"},
        {R"("positions": [-1])", "positions[0] is -1; give a whole number"},
        {R"("tones": [{}, {}])", "tones has 2 exposures; give one for each of the 1 strategies, or none"},
        {R"("tones": [{"exposure": 41}])", "tones[0].exposure is 41; give a number from -40 to 40"},
        {R"("tones": [{"range": [2, 1]}])", "tones[0].range is 2 to 1; give the low end first"},
        {R"("error": {"kind": "patch"}, "tones": [{"error_range": [-1, 1]}])",
         "tones[0].error_range has a low end that is not above 0, as the kind asks for"},
        {R"("strategies": ["uniform-constant", "uniform-wavelet"], "layout": "wipe", "tones": [{}, {}])",
         "tones has 2 exposures, and layout 'wipe' has one place; leave them out"},
        {R"("layers": {"mesh": "yes"})", "layers.mesh is 'yes'; give true or false"},
        {R"("curves": {"kinds": ["EE"]})", "curves.kinds[0] is 'EE'; give VE, EV"},
        {R"("curves": {"orders": [3]})", "curves.orders[0] is 3; give a whole number from 0 to 2"},
        {R"("curves": {"source": -1})", "curves.source is -1"},
        {R"("curves": {"shown": 1e9})", "curves.shown is 1e+09"},
        {R"("keyhole": [0, "0", 0])", "keyhole[1] is '0'; give a number"},
        {R"("profile": [[0, 0, 0]])", "profile has 1 points; give two"},
        {R"("profile": [[0, 0, 0], [0, 0]])", "profile[1] has 2 numbers; give x, y and z"},
        {R"("shading": "round")", "shading is 'round'; give polynomial, flat, linear or error"},
        {R"("error": {"kind": "big"})", "error.kind is 'big'; give signed, relative, patch or estimate"},
        {R"("error": {"change": "shade=off"})", "error.change is 'shade=off'; give an effect's name with =on or =off"},
        {R"("error": {"change": "discontinuities=off"})", "error.change is 'discontinuities=off'; give an effect's name"},
        {R"("error": {"kind": "patch", "range": [0, 1]})", "error.range has a low end that is not above 0"},
        {R"("exposure": 41)", "exposure is 41; give a number from -40 to 40"},
        {R"("range": [2, 1])", "range is 2 to 1; give the low end first"},
        {R"("range": [1])", "range has 1 numbers"},
        {R"("background": "pink")", "background is 'pink'; give dark or light"},
        {R"("picture": {"width": 63})", "picture.width is 63; give a whole number from 64 to 16384"},
    };
    for (const auto &[field, said] : faults) {
        const std::string scene = std::string(field).starts_with(R"("scene")") ? "{" : R"({"scene": "figure-4", )";
        EXPECT_THAT(refusal(scene + field + "}"), HasSubstr(said));
    }
    EXPECT_THAT(refusal("{}"), HasSubstr("the file has no scene; give one"));
    EXPECT_THAT(refusal("[]"), HasSubstr("the file is an array of 0; give an object"));
    EXPECT_THAT(refusal(R"({"scene": "figure-4")"), HasSubstr("is not valid JSON at byte"));
    EXPECT_THAT(refusal(""), HasSubstr("is not valid JSON"));
}

TEST(ReadState, LongAndDeepOnesAreRefused) {
    EXPECT_THAT(refusal(std::string(largest_state + 1, ' ')),
                HasSubstr("longer than a saved state's limit of 1024 KiB"));
    EXPECT_THAT(refusal(R"({"scene": "x", "deep": )" + std::string(20, '[') + std::string(20, ']') + "}"),
                HasSubstr("nested deeper than 16 levels"));
    std::string many = R"({"scene": "x", "many": [0)";
    for (int i = 0; i < 20'000; ++i)
        many += ",0";
    EXPECT_THAT(refusal(many + "]}"), HasSubstr("more than 20000 values"));
}

} // namespace
} // namespace penumbra
