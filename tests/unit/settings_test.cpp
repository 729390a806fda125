// Settings: what is good is taken, what is bad has its default and a line, and nothing is thrown.
#include "files/settings.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace penumbra {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(Settings, AreReadAsTheyAreWritten) {
    const Settings chosen{1.265625, Theme::light, 7.5, true};
    std::vector<std::string> notes;
    EXPECT_EQ(read_settings("s.json", settings_text(chosen), notes), chosen);
    EXPECT_THAT(notes, IsEmpty());
}

TEST(Settings, MissingOnesHaveTheirDefaultsAndUnknownOnesArePassedOver) {
    std::vector<std::string> notes;
    const Settings s = read_settings("s.json", R"({"ui_scale": 2, "theme": null, "of a later version": [1, 2]})", notes);
    EXPECT_EQ(s, (Settings{.ui_scale = 2}));
    EXPECT_THAT(notes, IsEmpty());
}

TEST(Settings, ABadValueHasItsDefaultAndTheOthersStay) {
    for (const char *bad : {R"("ui_scale": "big")", R"("ui_scale": 0)", R"("ui_scale": -3)", R"("ui_scale": 1e300)", R"("theme": "green")",
                            R"("theme": 1)", R"("phases_per_second": 0)", R"("phases_per_second": [])", R"("tour_seen": "yes")"}) {
        SCOPED_TRACE(bad);
        const bool of_the_tour = std::string_view(bad).find("tour") != std::string_view::npos;
        std::vector<std::string> notes;
        const std::string rest = of_the_tour ? R"("ui_scale": 2)" : R"("tour_seen": true)";
        const Settings s = read_settings("s.json", "{" + std::string(bad) + ", " + rest + "}", notes);
        EXPECT_EQ(s, (of_the_tour ? Settings{.ui_scale = 2} : Settings{.tour_seen = true}));
        EXPECT_THAT(notes, ElementsAre(testing::AllOf(StartsWith("s.json"), HasSubstr("passed over"))));
        EXPECT_EQ(notes.front().find('\n'), std::string::npos);
    }
}

TEST(Settings, ATextThatIsNoneIsOneLine) {
    const std::string deep(100, '[');
    const std::string long_one = "{\"theme\": \"" + std::string(1 << 20, 'x') + "\"}";
    for (const std::string &text : {std::string(), std::string("{"), std::string("[1, 2]"), std::string("7"), std::string("\0\xff\xfe", 3),
                                    std::string(R"({"ui_scale": 1e999})"), deep, long_one}) {
        SCOPED_TRACE(text.substr(0, 20));
        std::vector<std::string> notes;
        EXPECT_EQ(read_settings("s.json", text, notes), Settings());
        EXPECT_THAT(notes, ElementsAre(HasSubstr("passed over")));
    }
}

TEST(Settings, TheFileIsInTheConfigFolder) {
    char name[] = "/tmp/penumbra-settings-XXXXXX";
    const std::filesystem::path folder = ::mkdtemp(name);
    ::setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
    EXPECT_EQ(settings_file(), folder / "penumbra/settings.json");
    std::vector<std::string> notes;
    EXPECT_EQ(read_settings(notes), Settings()) << "there is none yet";
    EXPECT_THAT(notes, IsEmpty());
    write_settings({.ui_scale = 3});
    EXPECT_EQ(read_settings(notes), Settings{.ui_scale = 3});
    EXPECT_THAT(notes, IsEmpty());
    std::filesystem::remove(settings_file());
    std::filesystem::create_directories(settings_file()); // a folder in its place
    EXPECT_EQ(read_settings(notes), Settings());
    EXPECT_THAT(notes, ElementsAre(HasSubstr("passed over")));
    std::filesystem::remove_all(folder);
    ::unsetenv("XDG_CONFIG_HOME");
}

} // namespace
} // namespace penumbra
