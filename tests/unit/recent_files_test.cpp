// Recent files: the latest first, each once, ten at most; what is missing or bad does no harm.
#include "files/recent_files.h"

#include "core/error.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(RecentFiles, TheLatestIsFirstAndTheEleventhFallsAway) {
    RecentFiles files;
    for (char c = 'a'; c <= 'k'; ++c)
        files = with_latest(files, std::string("/") + c);
    EXPECT_THAT(files, ElementsAre("/k", "/j", "/i", "/h", "/g", "/f", "/e", "/d", "/c", "/b"));
    files = with_latest(files, "/e");
    EXPECT_THAT(files, ElementsAre("/e", "/k", "/j", "/i", "/h", "/g", "/f", "/d", "/c", "/b"));
}

TEST(RecentFiles, AreReadAsTheyAreWritten) {
    const RecentFiles files{"/a b/\u00fcber.obj", "/\"quoted\".png"};
    EXPECT_EQ(read_recent_files("recent.json", recent_files_text(files)), files);
    EXPECT_THAT(read_recent_files("recent.json", R"({"files": ["a.obj", "/b.obj", "/b.obj"]})"), ElementsAre("/b.obj"));
    for (const char *bad : {"", "{}", "[]", R"({"files": {}})", R"({"files": [1]})"})
        EXPECT_THROW(read_recent_files("recent.json", bad), BadInput) << bad;
}

TEST(RecentFiles, AreNotedWithTheirFullPaths) {
    char name[] = "/tmp/penumbra-recent-XXXXXX";
    const fs::path folder = ::mkdtemp(name), before = fs::current_path();
    ::setenv("XDG_STATE_HOME", folder.c_str(), 1);
    for (const char *file : {"one.obj", "two.obj"})
        std::ofstream(folder / file) << "v 0 0 0\n";
    fs::current_path(folder);
    EXPECT_THAT(note_recent_file("one.obj"), ElementsAre(folder / "one.obj"));
    EXPECT_THAT(note_recent_file("figure-4"), ElementsAre(folder / "one.obj")) << "a bundled scene's name is no file";
    EXPECT_THAT(note_recent_file("./two.obj"), ElementsAre(folder / "two.obj", folder / "one.obj"));
    EXPECT_THAT(note_recent_file(folder), ElementsAre(folder / "two.obj", folder / "one.obj")) << "a folder is none";
    fs::remove("two.obj");
    EXPECT_THAT(that_exist(read_recent_files()), ElementsAre(folder / "one.obj"));
    std::ofstream(recent_files_file()) << "{";
    EXPECT_THAT(read_recent_files(), IsEmpty());
    fs::current_path(before);
    fs::remove_all(folder);
    ::unsetenv("XDG_STATE_HOME");
}

} // namespace
} // namespace penumbra
