// make_office N FOLDER/NAME: writes NAME.obj and NAME.mtl, an office of about N polygons.
#include "office/office.h"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

int main(int argc, char **argv) {
    int n = 0;
    const std::string_view number = argc == 3 ? argv[1] : "";
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), n);
    if (number.empty() || error != std::errc() || end != number.data() + number.size() || n < 1 || n > 100'000) {
        std::fprintf(stderr, "usage: make_office N FOLDER/NAME: an office of about N polygons, 1 to 100000\n");
        return 2;
    }
    const std::filesystem::path path = argv[2];
    const penumbra::SceneText text = penumbra::office(n, path.filename().string());
    for (const auto &[suffix, content] : {std::pair(".obj", text.obj), std::pair(".mtl", text.mtl)}) {
        std::ofstream file(path.string() + suffix, std::ios::binary);
        if (!(file << content).flush()) {
            std::fprintf(stderr, "make_office: cannot write %s%s\n", path.c_str(), suffix);
            return 5;
        }
    }
}
