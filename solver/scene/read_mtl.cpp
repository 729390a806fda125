#include "scene/read_mtl.h"

#include "core/read_text.h"
#include "scene/mend.h"
#include "scene/validate.h"
#include "scene/wavefront_line.h"

#include <algorithm>

namespace penumbra {

namespace {

Rgb colour(const WavefrontLine &line) {
    const std::string keyword(line.words[0]);
    const std::size_t n = line.words.size() - 1;
    if (n != 1 && n != 3 && n != 4) // some write an alpha behind it
        line.fail(keyword + " has " + std::to_string(n) + " values; give red, green and blue");
    Rgb rgb;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string_view word = line.words[n == 1 ? 1 : 1 + i];
        if (!number_from(word, rgb[static_cast<Eigen::Index>(i)]))
            line.fail(keyword + " " + in_quotes(word) + " is not a number; give red, green and blue");
    }
    return rgb;
}

/// The material that a `newmtl` opened, while its lines are read.
struct Open {
    Material material;
    bool has_kd = false;
    int line = 0;
};

void close(const Open &open, const std::string &file, std::vector<Material> &materials, Notes &notes) {
    Material material = open.material;
    const std::string where = file + ":" + std::to_string(open.line) + ": material " + in_quotes(material.name);
    if (std::ranges::any_of(materials, [&](const Material &m) { return m.name == material.name; })) {
        notes.add("materials of a name that is there already", where + " is there already; the first one is kept");
        return;
    }
    if (!open.has_kd && material.exitance.maxCoeff() > 0)
        material.reflectance = Rgb::Zero();
    else if (!open.has_kd)
        notes.add("materials without a Kd", where + " has no Kd; grey 0.5 is taken");
    materials.push_back(std::move(material));
}

} // namespace

void read_mtl(const std::string &file, std::string_view text, std::vector<Material> &materials, Skipped &skipped,
              std::vector<std::string> &notes) {
    Open open;
    Notes of_materials;
    std::size_t n_opened = 0;
    for_each_wavefront_line(file, text, [&](const WavefrontLine &line) {
        const std::string_view keyword = line.words[0];
        if (keyword == "newmtl") {
            if (line.words.size() < 2)
                line.fail("newmtl has no name; give one");
            if (++n_opened > most_materials)
                line.fail("there are more than " + std::to_string(most_materials) + " materials; merge some");
            if (open.line > 0)
                close(open, file, materials, of_materials);
            open = {};
            open.line = line.number;
            open.material.name = line.name();
        } else if (keyword == "Kd" || keyword == "Ke") {
            if (open.line == 0)
                line.fail(std::string(keyword) + " stands before any newmtl; put a newmtl above it");
            (keyword == "Kd" ? open.material.reflectance : open.material.exitance) = colour(line);
            open.has_kd |= keyword == "Kd";
        } else {
            skipped.add(keyword);
        }
    });
    if (open.line > 0)
        close(open, file, materials, of_materials);
    of_materials.append_to(notes);
}

} // namespace penumbra
