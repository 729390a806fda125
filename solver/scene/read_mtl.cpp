#include "scene/read_mtl.h"

#include "core/error.h"
#include "core/read_text.h"

#include <algorithm>

namespace penumbra {

namespace {

[[noreturn]] void fail(const std::string &file, const TextLine &line, const std::string &what) {
    throw BadInput(file + ":" + std::to_string(line.number) + ": " + what);
}

Rgb colour(const std::string &file, const TextLine &line, const std::vector<std::string_view> &words) {
    const std::string keyword(words[0]);
    if (words.size() != 2 && words.size() != 4)
        fail(file, line, keyword + " has " + std::to_string(words.size() - 1) + " values; give red, green and blue");
    Rgb rgb;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view word = words[words.size() == 2 ? 1 : 1 + i];
        if (!number_from(word, rgb[static_cast<Eigen::Index>(i)]))
            fail(file, line, keyword + " " + in_quotes(word) + " is not a number; give red, green and blue");
    }
    return rgb;
}

/// The material that a `newmtl` opened, while its lines are read.
struct Open {
    Material material;
    bool has_kd = false;
    int line = 0;
};

void close(const Open &open, const std::string &file, std::vector<Material> &materials,
           std::vector<std::string> &notes) {
    Material material = open.material;
    const std::string where = file + ":" + std::to_string(open.line) + ": material " + in_quotes(material.name);
    if (std::ranges::any_of(materials, [&](const Material &m) { return m.name == material.name; })) {
        notes.push_back(where + " is there already; the first one is kept");
        return;
    }
    if (!open.has_kd && material.exitance.maxCoeff() > 0)
        material.reflectance = Rgb::Zero();
    else if (!open.has_kd)
        notes.push_back(where + " has no Kd; grey 0.5 is taken");
    materials.push_back(std::move(material));
}

} // namespace

void read_mtl(const std::string &file, std::string_view text, std::vector<Material> &materials, Skipped &skipped,
              std::vector<std::string> &notes) {
    Open open;
    for (const TextLine &line : lines_of(text)) {
        const auto words = words_of(line.text);
        if (words[0] == "newmtl") {
            if (words.size() < 2)
                fail(file, line, "newmtl has no name; give one");
            if (open.line > 0)
                close(open, file, materials, notes);
            open = {};
            open.line = line.number;
            // Names may hold blanks: all that stands behind the keyword.
            open.material.name = line.text.substr(static_cast<std::size_t>(words[1].data() - line.text.data()));
        } else if (words[0] == "Kd" || words[0] == "Ke") {
            if (open.line == 0)
                fail(file, line, std::string(words[0]) + " stands before any newmtl; put a newmtl above it");
            (words[0] == "Kd" ? open.material.reflectance : open.material.exitance) = colour(file, line, words);
            open.has_kd |= words[0] == "Kd";
        } else {
            ++skipped[std::string(words[0])];
        }
    }
    if (open.line > 0)
        close(open, file, materials, notes);
}

} // namespace penumbra
