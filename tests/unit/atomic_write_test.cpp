#include "core/atomic_write.h"

#include "core/error.h"

#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
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

TEST_F(AtomicWrite, FailsInAReadOnlyFolder) {
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may write into read-only folders";
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THROW(write_atomically(folder / "a", "x"), Unavailable);
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
