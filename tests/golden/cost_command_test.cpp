// The command `cost` as scripts see it, on a machine with no display.
#include "capture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace penumbra {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

std::string text(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

using Row = std::map<std::string, std::string>;

class CostCommand : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-cost-" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string line(const std::string &arguments) const {
        return "cd '" + folder.string() + "' && unset DISPLAY WAYLAND_DISPLAY && exec '" PENUMBRA_PROGRAM "' " + arguments +
               " >.out 2>.err";
    }
    int run(const std::string &arguments) const {
        const int status = std::system(line(arguments).c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string err() const { return text(folder / ".err"); }
    std::vector<Row> rows(const std::string &csv) const {
        std::istringstream lines(text(folder / csv));
        std::string row;
        std::getline(lines, row);
        std::vector<std::string> names;
        const auto each = [](const std::string &fields, const auto &take) {
            std::istringstream in(fields);
            for (std::string field; std::getline(in, field, ',');)
                take(field);
        };
        each(row, [&](const std::string &name) { names.push_back(name); });
        std::vector<Row> all;
        while (std::getline(lines, row)) {
            std::size_t i = 0;
            Row fields;
            each(row, [&](const std::string &field) { fields[names.at(i++)] = field; });
            all.push_back(fields);
        }
        return all;
    }
    std::set<std::string> files(const std::string &below) const {
        std::set<std::string> names;
        for (const auto &entry : fs::directory_iterator(folder / below))
            names.insert(entry.path().filename().string());
        return names;
    }

    fs::path folder;
};

TEST_F(CostCommand, WritesTableAndBothDrawings) {
    ASSERT_EQ(run("cost slanted-edge -o out/new --thresholds 0.02,0.2,0.05 --repeats 2 -v --time-limit 60"), 0) << err();
    EXPECT_THAT(files("out/new"), testing::UnorderedElementsAre("cost.csv", "cost.png", "cost.svg")) << "and no part of one";
    const std::vector<Row> all = rows("out/new/cost.csv");
    ASSERT_EQ(all.size(), 4U * 2U * 3U);
    std::set<std::string> curves;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Row &r = all[i];
        curves.insert(r.at("strategy") + r.at("basis"));
        EXPECT_EQ(r.at("status"), "done");
        EXPECT_EQ(r.at("runs"), "2");
        EXPECT_EQ(r.at("threshold"), std::vector<std::string>({"0.2", "0.05", "0.02"})[i % 3]);
        EXPECT_EQ(r.at("scene"), "slanted-edge");
        EXPECT_GT(std::stod(r.at("seconds")), 0);
        EXPECT_LE(std::stod(r.at("seconds_min")), std::stod(r.at("seconds")));
        EXPECT_GE(std::stod(r.at("seconds_max")), std::stod(r.at("seconds")));
        EXPECT_GE(std::stoi(r.at("cores")), 1);
        EXPECT_GT(std::stod(r.at("error")), 0);
        if (i % 3 > 0) {
            EXPECT_LE(std::stod(r.at("error")), std::stod(all[i - 1].at("error"))) << "a finer threshold is no worse";
            EXPECT_GE(std::stoi(r.at("patches")), std::stoi(all[i - 1].at("patches")));
        }
    }
    EXPECT_EQ(curves.size(), 8U);
    EXPECT_GT(read_png(folder / "out/new/cost.png").width, 1000);
    EXPECT_THAT(text(folder / "out/new/cost.svg"), testing::EndsWith("</svg>\n"));
    EXPECT_THAT(err(), HasSubstr("48 of 48: ")) << "24 solutions, twice each";

    const auto state = nlohmann::json::parse(read_png_state(folder / "out/new/cost.png").value_or("null"));
    EXPECT_EQ(state["scene"], "slanted-edge");
    EXPECT_EQ(state["strategies"].size(), 4U);
    EXPECT_EQ(run("render out/new/cost.png -o again.png --size 320x240 --steps 0"), 0) << err();
}

TEST_F(CostCommand, ChoosesStrategiesAndBases) {
    ASSERT_EQ(run("cost figure-4 -o . --thresholds 0.1 --repeats 1 --strategies uniform-wavelet,discontinuity-wavelet "
                  "--bases planar --order 3 -q"),
              0)
        << err();
    const auto all = rows("cost.csv");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].at("strategy"), "uniform-wavelet");
    EXPECT_EQ(all[1].at("strategy"), "discontinuity-wavelet");
    for (const Row &r : all) {
        EXPECT_EQ(r.at("basis"), "planar");
        EXPECT_EQ(r.at("order"), "3");
        EXPECT_EQ(r.at("max_depth"), "12");
    }
    EXPECT_THAT(err(), IsEmpty());
    EXPECT_THAT(text(folder / ".out"), IsEmpty());
}

/// 1e-5 takes the constant strategies minutes, whatever the machine.
TEST_F(CostCommand, ALimitIsRecordedAndFinerThresholdsAreNotTried) {
    ASSERT_EQ(run("cost slanted-edge -o . --thresholds 0.2,1e-5,1e-6 --repeats 3 --strategies uniform-constant --bases "
                  "parametric --time-limit 0.5"),
              0)
        << err();
    const auto all = rows("cost.csv");
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].at("status"), "done");
    EXPECT_EQ(all[1].at("status"), "time limit");
    EXPECT_GE(std::stod(all[1].at("seconds")), 0.5);
    EXPECT_EQ(all[1].at("runs"), "0");
    EXPECT_EQ(all[2].at("status"), "not tried");
    EXPECT_EQ(all[2].at("seconds"), "");
    EXPECT_THAT(text(folder / "cost.svg"), HasSubstr("1 met the time limit of 0.5 s"));
}

TEST_F(CostCommand, WhereACurveHasNoPointTheStatusIsFour) {
    EXPECT_EQ(run("cost slanted-edge -o . --thresholds 1e-5 --repeats 1 --strategies uniform-constant --bases parametric "
                  "--memory-limit 1"),
              4);
    EXPECT_THAT(err(), HasSubstr("raise --time-limit or --memory-limit"));
    EXPECT_EQ(rows("cost.csv")[0].at("status"), "memory limit");
    EXPECT_TRUE(fs::exists(folder / "cost.png"));
}

TEST_F(CostCommand, AnInterruptLeavesWhatWasComplete) {
    const std::string command =
        line("cost slanted-edge -o . --thresholds 0.2,1e-6 --repeats 1 --time-limit 100 --strategies uniform-constant "
             "--bases parametric");
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        ::_exit(99);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    const auto start = std::chrono::steady_clock::now();
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(WEXITSTATUS(status), 130) << err();
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5);
    const auto all = rows("cost.csv");
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].at("status"), "done");
    EXPECT_EQ(all[1].at("status"), "interrupted");
    EXPECT_THAT(err(), HasSubstr("what was complete is written"));
}

TEST_F(CostCommand, WrongUseIsTwoInOneLineAndWritesNothing) {
    for (const char *wrong : {"cost", "cost slanted-edge", "cost slanted-edge -o x --thresholds 0",
                              "cost slanted-edge -o x --thresholds 0.1,x", "cost slanted-edge -o x --thresholds nan", "cost slanted-edge -o x --strategies best",
                              "cost slanted-edge -o x --bases round", "cost slanted-edge -o x --repeats 0",
                              "cost slanted-edge -o x --time-limit -1", "cost slanted-edge -o x --threshold 0.1",
                              "cost slanted-edge -o x --tolerance 0.1"}) {
        EXPECT_EQ(run(wrong), 2) << wrong;
        EXPECT_EQ(std::ranges::count(err(), '\n'), 1) << err();
        EXPECT_FALSE(fs::exists(folder / "x")) << wrong;
    }
}

TEST_F(CostCommand, TheHelpNamesTheColumns) {
    EXPECT_EQ(run("cost --help"), 0);
    const std::string help = text(folder / ".out");
    ASSERT_EQ(run("cost figure-4 -o . --thresholds 0.1 --repeats 1 --strategies discontinuity-wavelet -q"), 0);
    std::istringstream header(text(folder / "cost.csv").substr(0, text(folder / "cost.csv").find('\n')));
    for (std::string column; std::getline(header, column, ',');)
        EXPECT_THAT(help, HasSubstr(column));
}

} // namespace
} // namespace penumbra
