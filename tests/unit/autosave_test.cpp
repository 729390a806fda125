// Which autosaves are orphans: those of processes that have ended.
#include "files/autosave.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;

TEST(Autosave, OrphansAreThoseOfProcessesThatHaveEnded) {
    char name[] = "/tmp/penumbra-autosave-XXXXXX";
    const fs::path top = ::mkdtemp(name), folder = top / "penumbra";
    ::setenv("XDG_STATE_HOME", top.c_str(), 1);
    EXPECT_THAT(orphaned_autosaves(), testing::IsEmpty()) << "where there is no folder yet";
    fs::create_directories(folder);
    EXPECT_EQ(autosave_file(), folder / ("autosave-" + std::to_string(::getpid()) + ".penumbra.json"));

    const pid_t ended = ::fork();
    if (ended == 0)
        ::_exit(0);
    ASSERT_EQ(::waitpid(ended, nullptr, 0), ended);
    const auto write = [&](const std::string &middle, int minutes_ago) {
        const fs::path file = folder / ("autosave-" + middle + ".penumbra.json");
        std::ofstream(file) << "{}";
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::minutes(minutes_ago));
        return file;
    };
    const fs::path of_ended = write(std::to_string(ended), 20), of_none = write("999999999", 10);
    const fs::path of_parent = write(std::to_string(::getppid()), 5), of_earlier_namesake = write(std::to_string(::getpid()), 15);
    for (const char *other : {"", "12x", "-5", "99999999999999999999"})
        write(other, 1);
    std::ofstream(folder / "rescued.penumbra.json") << "{}";

    EXPECT_THAT(orphaned_autosaves(), testing::ElementsAre(of_none, folder / "autosave-0.penumbra.json", of_ended));
    EXPECT_FALSE(fs::exists(of_earlier_namesake)) << "its name is this process' now";
    EXPECT_TRUE(fs::exists(of_parent));
    fs::remove_all(top);
    ::unsetenv("XDG_STATE_HOME");
}

} // namespace
} // namespace penumbra
