#include "core/atomic_write.h"

#include "core/error.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;

class AtomicWrite : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-write-" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override {
        fs::permissions(folder, fs::perms::owner_all);
        fs::remove_all(folder);
    }
    static std::string text(const fs::path &file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::ptrdiff_t n_files() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }

    fs::path folder;
};

TEST_F(AtomicWrite, ReplacesAndLeavesNothingBeside) {
    write_atomically(folder / "a", "first, and longer");
    write_atomically(folder / "a", std::string_view("se\0cond", 7));
    EXPECT_EQ(text(folder / "a"), std::string("se\0cond", 7));
    EXPECT_EQ(n_files(), 1);
}

TEST_F(AtomicWrite, FailsCleanlyWhereItMayNotWrite) {
    EXPECT_THROW(write_atomically(folder / "none" / "a", "x"), Unavailable);
    fs::create_directories(folder / "taken" / "full");
    EXPECT_THROW(write_atomically(folder / "taken", "x"), Unavailable) << "onto a folder that holds something";
    EXPECT_EQ(n_files(), 1);
}

/// Whether it refuses, as one who is not root: root may write anywhere.
bool is_refused_as_anybody(const fs::path &file) {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t nobody = 65534;
        if (::geteuid() == 0 && ::setuid(nobody) != 0)
            ::_exit(2);
        try {
            write_atomically(file, "x");
        } catch (const Unavailable &) {
            ::_exit(0);
        }
        ::_exit(1);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST_F(AtomicWrite, FailsInAReadOnlyFolder) {
    fs::permissions(folder, fs::perms::all);
    EXPECT_FALSE(is_refused_as_anybody(folder / "a")) << "the control: this folder is open to all";
    fs::permissions(folder, fs::perms(0555));
    EXPECT_TRUE(is_refused_as_anybody(folder / "b"));
    EXPECT_EQ(n_files(), 1);
}

TEST_F(AtomicWrite, AFullDeviceIsAnError) { EXPECT_THROW(write_atomically("/dev/full", "x"), Unavailable); }

TEST_F(AtomicWrite, DevicesTakeBytes) { EXPECT_NO_THROW(write_atomically("/dev/null", "x")); }

TEST_F(AtomicWrite, ALinkStays) {
    write_atomically(folder / "a", "old");
    fs::create_symlink("a", folder / "link");
    write_atomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(text(folder / "a"), "new");
}

} // namespace
} // namespace penumbra
