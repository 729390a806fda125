// The program as scripts see it: exit statuses, where output goes, what is in the files.
#include "sanitizers/time_factor.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string text(const fs::path &file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

struct Result {
    int status;
    std::string out, err;
};

class CommandLine : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("penumbra-cli-" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }

    std::string in_folder(const std::string &arguments) const {
        return "cd '" + folder.string() + "' && exec '" PENUMBRA_PROGRAM "' " + arguments + " >.out 2>.err";
    }
    Result run(const std::string &arguments) const {
        const int status = std::system(in_folder(arguments).c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text(folder / ".out"), text(folder / ".err")};
    }
    void write(const std::string &name, const std::string &content) const { std::ofstream(folder / name) << content; }
    nlohmann::json record(const std::string &name) const { return nlohmann::json::parse(text(folder / name)); }

    fs::path folder;
};

TEST_F(CommandLine, HelpAndVersionAreData) {
    EXPECT_EQ(run("--help").status, 0);
    EXPECT_THAT(run("--help").out, HasSubstr("scenes"));
    EXPECT_THAT(run("--version").out, testing::MatchesRegex("penumbra [0-9]+\\.[0-9]+\\.[0-9]+\n"));
    EXPECT_THAT(run("solve -h").out, HasSubstr("--threshold"));
    EXPECT_THAT(run("solve -h").err, IsEmpty());
}

TEST_F(CommandLine, WrongUseIsTwoAndOneLine) {
    for (const char *wrong : {"solve", "solve figure-4 --order 5", "solve figure-4 --order x", "solve figure-4 --bogus",
                              "solve figure-4 --strategy best", "solve figure-4 --threshold 0",
                              "solve figure-4 --threshold nan", "solve figure-4 more", "solve figure-4 --probe p.csv",
                              "solve figure-4 --max-depth -1", "solve figure-4 --cut all", "curves figure-4", "solve figure-4 --up w"}) {
        const Result result = run(wrong);
        EXPECT_EQ(result.status, 2) << wrong;
        EXPECT_THAT(result.err, StartsWith("penumbra: ")) << wrong;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << wrong << ": " << result.err;
        EXPECT_THAT(result.out, IsEmpty()) << wrong;
    }
}

TEST_F(CommandLine, EffectsAreDecidedExplainedAndOverruled) {
    ASSERT_EQ(run("solve grey -q -o r.json").status, 0);
    const auto effect = [&](const std::string &name) {
        const auto all = record("r.json");
        for (const auto &e : all["effects"])
            if (e["name"] == name)
                return nlohmann::json(e);
        return nlohmann::json();
    };
    const auto colour = effect("colour");
    EXPECT_EQ(colour["decision"], "off");
    EXPECT_EQ(colour["reason"], "1 channel is solved: the others are multiples, or dark");
    EXPECT_EQ(colour["unit"], "products");
    EXPECT_EQ(colour["saved"].get<std::int64_t>(), 2 * colour["done"].get<std::int64_t>());
    EXPECT_EQ(record("r.json")["final"]["channels"], 1);
    ASSERT_EQ(run("solve grey -q -o r.json --effect colour=on --effect discontinuities=off --effect colour=on").status, 0);
    EXPECT_EQ(effect("colour")["decision"], "on");
    EXPECT_EQ(effect("colour")["reason"], "asked for: on");
    EXPECT_EQ(record("r.json")["final"]["channels"], 3);
    for (const char *part : {"ve-ev", "eee", "contact", "secondary"})
        EXPECT_EQ(effect(std::string("discontinuities.") + part)["decision"], "off");
    EXPECT_EQ(record("r.json")["final"]["curves"], 0);
    for (const char *wrong : {"fog=on", "colour", "colour=maybe", "=on", "discontinuities.=on"}) {
        const Result result = run(std::string("solve grey --effect ") + wrong);
        EXPECT_EQ(result.status, 2) << wrong;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << wrong << ": " << result.err;
    }
}

TEST_F(CommandLine, UnlessAskedOtherwiseTheErrorIsBelowOneInAHundred) {
    EXPECT_EQ(run("solve slanted-edge -q -o r.json").status, 0);
    const auto found = record("r.json");
    EXPECT_EQ(found["tolerance"], 0.01);
    EXPECT_LT(found["final"]["error"], 0.01);
    EXPECT_LT(found["final"]["estimated_error"], 0.01);
    EXPECT_EQ(found["final"]["confidence"], 0.99);
    EXPECT_EQ(run("solve slanted-edge --threshold 0.1 -q -o t.json").status, 0);
    const auto by_threshold = record("t.json");
    EXPECT_EQ(by_threshold["tolerance"], nullptr);
    EXPECT_EQ(by_threshold["threshold"], 0.1);
    EXPECT_GT(by_threshold["final"]["estimated_error"], 0) << "is estimated in any case";
}

TEST_F(CommandLine, ATimeLimitAloneIsABudget) {
    // Far more than the first settled states take, far less than rounding would.
    const Result result = run("solve cornell-box --time-limit " + std::to_string(3 * penumbra::time_factor) + " -o r.json");
    EXPECT_EQ(result.status, 4);
    EXPECT_THAT(result.err, HasSubstr("most accurate complete solution"));
    EXPECT_THAT(result.err, HasSubstr("its error is about"));
    const auto found = record("r.json");
    EXPECT_EQ(found["tolerance"], nullptr);
    EXPECT_EQ(found["stopped_by"], "time limit");
    const double reached = found["final"]["estimated_error"];
    EXPECT_GT(reached, 0);
    int measured = 0;
    for (const auto &i : found["iterations"])
        if (!i["estimated_error"].is_null()) {
            ++measured;
            EXPECT_LE(reached, i["estimated_error"]);
        }
    EXPECT_GT(measured, 0);
}

TEST_F(CommandLine, AToleranceOutOfReachIsSaidWithWhatWasReached) {
    // A floor in one piece and a constant: nothing can be split.
    const Result result = run("solve slanted-edge --tolerance 0.001 --max-depth 0 --strategy uniform-constant -o r.json");
    EXPECT_EQ(result.status, 4);
    EXPECT_THAT(result.err, HasSubstr("out of reach"));
    const auto found = record("r.json")["final"];
    EXPECT_EQ(found["converged"], false);
    EXPECT_GT(found["estimated_error"], 0.001);
    EXPECT_GT(found["error_bound"], found["error"]);
}

TEST_F(CommandLine, CheckSaysWhatHoldsAndWhatFails) {
    // Status 1 exactly when a case fails, and the table names the same ones.
    const Result table = run("check"), json = run("check --json -o shelf.json");
    const auto shelf = record("shelf.json");
    std::size_t n_failed = 0;
    for (const auto &found : shelf) {
        n_failed += found["holds"] == false;
        const std::string line = "FAILED: " + found["name"].get<std::string>() + " (" + found["basis"].get<std::string>() + ")\n";
        EXPECT_EQ(table.out.find(line) != std::string::npos, found["holds"] == false) << line;
        for (const auto &m : found["measurements"])
            EXPECT_EQ(m["holds"], !m["value"].is_null() && m["value"] <= m["bound"]) << found["name"] << m["quantity"];
    }
    EXPECT_GE(shelf.size(), 40U);
    EXPECT_EQ(table.status, n_failed > 0 ? 1 : 0);
    EXPECT_EQ(json.status, table.status);
    EXPECT_THAT(table.out, HasSubstr(std::to_string(shelf.size() - n_failed) + " of " + std::to_string(shelf.size()) + " hold"));
}

TEST_F(CommandLine, CheckOfAScene) {
    EXPECT_EQ(run("check furnace figure-4 --json -o health.json").status, 0);
    const auto health = record("health.json");
    ASSERT_EQ(health.size(), 4U); // two scenes, two bases
    for (const auto &found : health) {
        EXPECT_EQ(found["non_finite"], 0);
        EXPECT_LT(found["energy_balance_error"], 0.02);
        EXPECT_EQ(found["converged"], true);
        EXPECT_LT(found["max_gram_error"], 1e-12);
        EXPECT_NEAR(found["absorbed"].get<double>() + found["lost"].get<double>() + found["drift"].get<double>(), 1, 1e-12);
        EXPECT_LT(std::abs(found["drift"].get<double>()), 0.02);
    }
    for (const int basis : {0, 1}) {
        EXPECT_LT(health[static_cast<std::size_t>(basis)]["closure_error"], 1e-4);
        EXPECT_TRUE(health[static_cast<std::size_t>(2 + basis)]["closure_error"].is_null()); // an open scene
    }
    EXPECT_NEAR(health[0]["lost"], 0, 1e-12); // a closed room of reflecting walls
    EXPECT_THAT(run("check furnace").out, HasSubstr("planar"));
    EXPECT_EQ(run("check none.obj").status, 3);
    EXPECT_EQ(run("check -o none/a.json").status, 5);
}

TEST_F(CommandLine, ThePlanarBasisHasFewerCoefficientsAPatch) {
    const Result result = run("solve figure-4 --basis planar");
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.out, HasSubstr("\"basis\": \"planar\""));
    EXPECT_EQ(run("solve figure-4 --basis cubic").status, 2);
}

TEST_F(CommandLine, BadInputIsThree) {
    write("white.obj", "mtllib white.mtl\nusemtl w\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    write("white.mtl", "newmtl w\nKd 1 1 1\n");
    for (const char *bad : {"solve none.obj", "solve .", "solve white.obj", "curves white.obj -o c.csv"}) {
        const Result result = run(bad);
        EXPECT_EQ(result.status, 3) << bad;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << bad;
    }
    EXPECT_THAT(run("solve white.obj").err, HasSubstr("white.obj:6: material 'w': reflectance (Kd) 1"));
}

TEST_F(CommandLine, WhatCannotBeWrittenIsFive) {
    for (const char *place : {"none/a.json", ".", "/dev/full"})
        EXPECT_EQ(run(std::string("solve furnace --max-depth 0 -o ") + place).status, 5) << place;
    for (const char *said : {"--version", "--help", "scenes", "solve furnace --max-depth 0"}) {
        const int status = std::system(("'" PENUMBRA_PROGRAM "' " + std::string(said) + " 2>/dev/null >/dev/full").c_str());
        EXPECT_EQ(WEXITSTATUS(status), 5) << said;
    }
}

/// A line each: the name, and from one column on what it is.
TEST_F(CommandLine, ScenesAreListed) {
    const Result result = run("scenes");
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.out, HasSubstr("cornell-box      The Cornell box"));
    EXPECT_THAT(result.out, HasSubstr("venetian-blinds  A long narrow window"));
    std::size_t n_files = 0;
    for (const auto &file : fs::directory_iterator(PENUMBRA_SOURCE_DIR "/assets/scenes"))
        n_files += file.path().extension() == ".obj";
    EXPECT_EQ(std::ranges::count(result.out, '\n'), static_cast<std::ptrdiff_t>(n_files));
}

TEST_F(CommandLine, TheRecordHoldsWhatTheContractLists) {
    const Result result = run("solve figure-4 --threads 1 -o r.json");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.out, IsEmpty());
    EXPECT_THAT(result.err, IsEmpty()) << "no bar where there is no terminal";
    const auto json = record("r.json");
    for (const char *key : {"scene", "strategy", "basis", "order", "threshold", "tolerance", "threads", "version",
                            "iterations", "final", "effects", "diagnostics"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const char *key : {"iteration", "patches", "coefficients", "links", "kernel_evaluations", "clips", "rays",
                            "link_evaluations", "refine_s", "gather_s", "push_pull_s", "change"})
        EXPECT_TRUE(json["iterations"].at(0).contains(key)) << key;
    for (const char *key : {"converged", "patches", "coefficients", "links", "link_bytes", "nodes_at_limit", "sampled_visibility",
                            "kernel_evaluations", "clips", "rays", "link_evaluations", "seconds", "peak_memory_mib", "estimated_error",
                            "error_bound"})
        EXPECT_TRUE(json["final"].contains(key)) << key;
    for (const char *key : {"energy_balance_error", "min_radiosity", "max_filter_condition", "non_finite"})
        EXPECT_TRUE(json["diagnostics"].contains(key)) << key;
    EXPECT_EQ(json["scene"], "figure-4");
    EXPECT_EQ(json["strategy"], "discontinuity-wavelet");
    EXPECT_EQ(json["threads"], 1);
    EXPECT_EQ(json["final"]["converged"], true);
    EXPECT_EQ(json["diagnostics"]["non_finite"], 0);
    EXPECT_EQ(json["tolerance"], 0.01);
}

TEST_F(CommandLine, TheRecordSaysHowItWasCut) {
    const auto cuts = [&](const std::string &options) {
        EXPECT_EQ(run("solve figure-4 --threshold 0.01 -o r.json" + options).status, 0);
        const auto json = record("r.json");
        EXPECT_GE(json["final"]["snapped_cuts"], 0);
        EXPECT_GE(json["final"]["left_out_curves"], 0);
        return json["cut"];
    };
    EXPECT_EQ(cuts(""), "curves");
    EXPECT_EQ(cuts(" --cut curves"), "curves");
    EXPECT_EQ(cuts(" --cut best"), "best");
}

TEST_F(CommandLine, TheRecordSaysInWhichOrderItGathered) {
    const auto gathered = [&](const std::string &options) {
        EXPECT_EQ(run("solve figure-4 --threshold 0.05 -o r.json" + options).status, 0);
        return record("r.json");
    };
    EXPECT_EQ(gathered("")["gather"], "jacobi");
    for (const char *order : {"jacobi", "gauss-seidel", "southwell"}) {
        const auto json = gathered(" --gather " + std::string(order));
        EXPECT_EQ(json["gather"], order);
        EXPECT_GE(json["final"]["link_evaluations"], json["final"]["links"]);
    }
    EXPECT_EQ(run("solve figure-4 --gather seidel").status, 2);
}

TEST_F(CommandLine, TheRecordGoesToStandardOutputUnlessNamed) {
    const Result result = run("solve furnace --max-depth 0");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(nlohmann::json::accept(result.out));
}

TEST_F(CommandLine, TooFewIterationsAreFourAndStillWritten) {
    const Result result = run("solve furnace --max-depth 0 --max-iterations 1 -o r.json");
    EXPECT_EQ(result.status, 4);
    EXPECT_THAT(result.err, HasSubstr("fixed point"));
    EXPECT_EQ(record("r.json")["iterations"].size(), 1U);
    EXPECT_EQ(record("r.json")["final"]["converged"], false);
}

// A closed box whose walls emit 1 and reflect half has 2 everywhere.
TEST_F(CommandLine, ProbesReadTheSolution) {
    write("in.csv", "x,y,z,nx,ny,nz\r\n0.3,0.4,0,0,0,1\r\n0.3,0.4,1,0,0,-2\n0.3,0.4,0.5,0,0,1\n0.3,0.4,0,0,0,-1\n");
    ASSERT_EQ(run("solve furnace -q -o r.json --probe in.csv --probe-output out.csv").status, 0);
    std::istringstream lines(text(folder / "out.csv"));
    std::vector<std::string> rows;
    for (std::string line; std::getline(lines, line);)
        rows.push_back(line);
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows[0], "x,y,z,nx,ny,nz,r,g,b");
    for (std::size_t i : {1U, 2U})
        EXPECT_NEAR(std::stod(rows[i].substr(rows[i].rfind(',') + 1)), 2, 0.01) << rows[i];
    EXPECT_EQ(rows[3], "0.3,0.4,0.5,0,0,1,nan,nan,nan") << "in the air";
    EXPECT_EQ(rows[4], "0.3,0.4,0,0,0,-1,nan,nan,nan") << "from behind";
}

TEST_F(CommandLine, BadProbesAreThreeBeforeAnythingIsSolved) {
    for (const char *bad : {"x,y,z\n1,2,3\n", "x,y,z,nx,ny,nz\n1,2,3,0,0\n", "x,y,z,nx,ny,nz\n1,2,nan,0,0,1\n",
                            "x,y,z,nx,ny,nz\n1,2,3,0,0,0\n", ""}) {
        write("in.csv", bad);
        EXPECT_EQ(run("solve furnace -o r.json --probe in.csv --probe-output out.csv").status, 3) << bad;
        EXPECT_FALSE(fs::exists(folder / "r.json"));
    }
}

TEST_F(CommandLine, CurvesAreRowsOfPolylines) {
    ASSERT_EQ(run("curves figure-4 -o c.csv --svg drawings").status, 0);
    std::istringstream lines(text(folder / "c.csv"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "curve,kind,order,source,receiver,x,y,z,blockers");
    int n = 0;
    while (std::getline(lines, line) && ++n)
        EXPECT_EQ(std::ranges::count(line, ','), 8) << line;
    EXPECT_GE(n, 4) << "two ends of two lines at least";
    EXPECT_THAT(text(folder / "drawings" / "receiver-0.svg"), StartsWith("<svg"));
}

/// Two lines cross figure-4's floor from side to side: three regions. Each edge names faces and curves that there are.
TEST_F(CommandLine, RegionsOfAReceiverAsJson) {
    ASSERT_EQ(run("curves figure-4 -o c.csv --arrangement regions").status, 0);
    const auto json = nlohmann::json::parse(text(folder / "regions" / "receiver-0.json"));
    EXPECT_EQ(json["scene"], "figure-4");
    EXPECT_EQ(json["receiver"], 0);
    ASSERT_EQ(json["faces"].size(), 3U);
    EXPECT_EQ(json["vertices"].size(), 4U + 4U);
    EXPECT_EQ(json["edges"].size(), 8U + 2U);
    int n_inner = 0;
    for (const auto &edge : json["edges"]) {
        EXPECT_EQ(edge["border"], edge["left"] == -1 || edge["right"] == -1);
        EXPECT_EQ(edge["border"], edge["curves"].empty());
        n_inner += edge["border"] == false;
    }
    EXPECT_EQ(n_inner, 2);
    std::vector<double> areas;
    for (const auto &face : json["faces"])
        areas.push_back(face["area"]);
    // The floor is 2 x 2; the file says where its penumbra lies, to four digits.
    EXPECT_THAT(areas, testing::UnorderedElementsAre(testing::DoubleNear(2 * (0.5972 + 1), 1.1e-4),
                                                     testing::DoubleNear(2 * (0.6528 - 0.5972), 2.1e-4),
                                                     testing::DoubleNear(2 * (1 - 0.6528), 1.1e-4)));
}

/// Starts a solution that takes minutes, sends the signal, and waits.
int status_after(int signal, const std::string &command, double *seconds) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        ::_exit(99);
    }
    std::this_thread::sleep_for(penumbra::time_factor * std::chrono::milliseconds(1500));
    const auto start = std::chrono::steady_clock::now();
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    *seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(CommandLine, InterruptsStillWriteTheLastCompleteSolution) {
    double seconds = 0;
    const std::string slow = "solve cornell-box --threshold 1e-7 --max-depth 12 -o ";
    EXPECT_EQ(status_after(SIGINT, in_folder(slow + "int.json"), &seconds), 130);
    EXPECT_LT(seconds, 2 * penumbra::time_factor);
    EXPECT_EQ(record("int.json")["final"]["converged"], false);
    EXPECT_EQ(status_after(SIGTERM, in_folder(slow + "term.json"), &seconds), 143);
    EXPECT_TRUE(record("term.json").contains("final"));
}

TEST_F(CommandLine, TheTimeLimitIsFour) {
    const Result result = run("solve cornell-box --threshold 1e-7 --max-depth 12 --time-limit 1 -o r.json");
    EXPECT_EQ(result.status, 4);
    EXPECT_THAT(result.err, HasSubstr("time limit"));
    EXPECT_TRUE(record("r.json").contains("final"));
}

} // namespace
