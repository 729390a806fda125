// What is too large is refused in one line, before memory or time run out; and what repeats is noted briefly.
#include "obj_text.h"

#include "core/error.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace penumbra {
namespace {

using testing::HasSubstr;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string repeated(const std::string &text, int n) {
    std::string out;
    for (int i = 0; i < n; ++i)
        out += text;
    return out;
}

/// "head 0 tail", "head 1 tail" and so on.
std::string numbered(const std::string &head, int n, const std::string &tail = "\n") {
    std::string out;
    for (int i = 0; i < n; ++i)
        out += fmt::format("{}{}{}", head, i, tail);
    return out;
}

std::string refusal(const std::string &obj, const std::string &mtl = "") {
    try {
        scene_of(obj, mtl);
    } catch (const BadInput &e) {
        EXPECT_THAT(e.what(), testing::Not(HasSubstr("\n")));
        return e.what();
    }
    ADD_FAILURE() << "was taken";
    return "";
}

TEST(Limits, FacesAndCorners) {
    EXPECT_THAT(refusal(square + repeated("f 1 2 3\n", 200'001)),
                HasSubstr("t.obj: has more than 200000 faces; simplify"));
    EXPECT_THAT(refusal(square + repeated("f" + repeated(" 1 2 3 4", 2500) + "\n", 201)),
                HasSubstr("more than 2000000 corners of faces; simplify"));
    EXPECT_THAT(refusal(square + "f 1 2 8000001\n"), HasSubstr("t.obj:5: face index 8000001 is out of range"));
}

TEST(Limits, FacesThatLieOnEachOther) {
    EXPECT_THAT(refusal(square + repeated("f 1 2 3 4\n", 3000)), HasSubstr("remove the duplicates"));
    EXPECT_EQ(scene_of(square + repeated("f 1 2 3 4\n", 100)).n_surfaces(), 100);
}

TEST(Limits, LinesAndNames) {
    EXPECT_THAT(refusal(square + "f" + repeated(" 1", 600'000)),
                HasSubstr("t.obj:5: the line is longer than 1024 KiB"));
    EXPECT_THAT(refusal(square + repeated("f 1 2 3 \\\n", 200'000)), HasSubstr("the line is longer than 1024 KiB"));
    EXPECT_THAT(refusal("o " + std::string(300, 'x') + "\n" + square + "f 1 2 3\n"),
                HasSubstr("a name of 300 bytes is too long"));
}

TEST(Limits, MaterialsAndLibraries) {
    EXPECT_THAT(refusal("mtllib m\n" + square + "f 1 2 3\n", numbered("newmtl a", 10'001)),
                HasSubstr("m:10001: there are more than 10000 materials; merge some"));
    EXPECT_THAT(refusal(numbered("mtllib l", 17) + square + "f 1 2 3\n"),
                HasSubstr("t.obj:17: there are more than 16 material libraries"));
    EXPECT_EQ(scene_of(repeated("mtllib m\n", 1000) + square + "f 1 2 3\n", "newmtl a\n").materials.size(), 2U)
        << "a library named again is read once";
}

TEST(Limits, NotesStayBrief) {
    const auto all_are_short = [](const Scene &scene) {
        EXPECT_LT(scene.notes.size(), 10U);
        for (const std::string &note : scene.notes)
            EXPECT_LT(note.size(), 1500U) << note;
    };
    all_are_short(scene_of(square + numbered("k", 100'000) + "f 1 2 3\n"));
    all_are_short(scene_of(square + numbered("usemtl m", 1000, "\nf 1 2 3\n")));
    all_are_short(scene_of("mtllib m\n" + square + "f 1 2 3\n", repeated("newmtl same\n", 10'000)));
    all_are_short(scene_of("mtllib m\n" + square + "f 1 2 3\n", numbered("newmtl a", 10'000)));
}

} // namespace
} // namespace penumbra
