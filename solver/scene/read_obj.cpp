#include "scene/read_obj.h"

#include "core/beside.h"
#include "core/error.h"
#include "core/read_text.h"
#include "scene/build_scene.h"
#include "scene/mend.h"
#include "scene/obj_header.h"
#include "scene/read_mtl.h"
#include "scene/validate.h"
#include "scene/wavefront_line.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace penumbra {

namespace {

/// A face while vertices that it may name are still to come.
struct IndexedFace {
    int line = 0;
    int object = 0, material = 0; ///< indices of names
    std::vector<int> vertices;    ///< from 0; not yet compared with the number of vertices
};

/// Names that faces have, in the order in which they first stood.
struct Names {
    std::vector<std::string> list;
    std::map<std::string, int, std::less<>> numbers;

    int number(const std::string &name) {
        const auto [at, is_new] = numbers.emplace(name, static_cast<int>(list.size()));
        if (is_new)
            list.push_back(name);
        return at->second;
    }
};

struct ObjReader {
    std::filesystem::path file;
    std::vector<Vec3> vertices;
    std::vector<IndexedFace> faces;
    std::vector<std::pair<int, std::string>> libraries; ///< line and name
    Names names;
    std::string object, material; ///< of the faces to come
    Skipped skipped;
    FaceCount count;

    void read_vertex(const WavefrontLine &line) {
        const auto &words = line.words;
        if (words.size() < 4)
            line.fail("a vertex has " + std::to_string(words.size() - 1) +
                      " coordinates; give three (is the file whole?)");
        if (vertices.size() == most_vertices)
            line.fail("there are more than " + std::to_string(most_vertices) + " vertices; simplify the scene");
        Vec3 x;
        for (std::size_t i = 0; i < 3; ++i) {
            double &c = x[static_cast<Eigen::Index>(i)];
            if (!number_from(words[1 + i], c))
                line.fail("coordinate " + in_quotes(words[1 + i]) + " is not a number; write it as 12.5 or 1e-3");
            if (!std::isfinite(c))
                line.fail("coordinate " + in_quotes(words[1 + i]) + " is not finite; give a finite number");
        }
        vertices.push_back(x);
    }

    /// `7`, `7/1`, `7//3`, `7/1/3`: the first number counts, from 1, or back from the newest vertex when negative.
    int read_corner(const WavefrontLine &line, std::string_view word) const {
        const std::string_view digits = word.substr(0, word.find('/'));
        long long index = 0;
        const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (status != std::errc{} || end != digits.data() + digits.size())
            line.fail("face index " + in_quotes(word) + " is not a whole number; write it as 7, 7/1 or 7//3");
        if (index == 0)
            line.fail("face index 0 is out of range; indices count from 1");
        if (index > static_cast<long long>(most_vertices))
            line.fail("face index " + std::to_string(index) + " is out of range; there are at most " +
                      std::to_string(most_vertices) + " vertices");
        const auto n = static_cast<long long>(vertices.size());
        if (index < -n)
            line.fail("face index " + std::to_string(index) + " is out of range; only " + std::to_string(n) +
                      " vertices stand before it");
        return static_cast<int>(index > 0 ? index - 1 : n + index);
    }

    void read_face(const WavefrontLine &line) {
        const std::size_t n = line.words.size() - 1;
        if (n < 3)
            line.fail("a face has " + std::to_string(n) + " corners; give at least three (is the file whole?)");
        count.add(line.file, n);
        IndexedFace &face =
            faces.emplace_back(IndexedFace{line.number, names.number(object), names.number(material), {}});
        for (std::size_t i = 1; i <= n; ++i)
            face.vertices.push_back(read_corner(line, line.words[i]));
    }

    void read_library(const WavefrontLine &line) {
        const std::string name = line.name();
        if (std::ranges::find(libraries, name, &std::pair<int, std::string>::second) != libraries.end())
            return;
        if (libraries.size() == most_libraries)
            line.fail("there are more than " + std::to_string(most_libraries) + " material libraries; merge some");
        libraries.emplace_back(line.number, name);
    }

    void read(std::string_view text) {
        for_each_wavefront_line(file.string(), text, [&](const WavefrontLine &line) {
            const std::string_view keyword = line.words[0];
            if (keyword == "v")
                read_vertex(line);
            else if (keyword == "f" || keyword == "fo")
                read_face(line);
            else if (keyword == "o" || keyword == "g")
                object = line.name();
            else if (keyword == "usemtl")
                material = line.name();
            else if (keyword == "mtllib")
                read_library(line);
            else
                skipped.add(keyword);
        });
    }
};

/// Library names with blanks exist, and so do several names on one line: the whole is tried first.
std::vector<Material> read_libraries(ObjReader &reader, const OpenLibrary &open, std::vector<std::string> &notes) {
    std::vector<Material> materials;
    for (const auto &[line, name] : reader.libraries) {
        std::vector<std::string> names{name};
        std::optional<std::string> text = open(name);
        if (const auto words = words_of(name); !text && words.size() > 1)
            names.assign(words.begin(), words.end());
        for (const std::string &one : names) {
            if (names.size() > 1)
                text = open(one);
            if (text)
                read_mtl((reader.file.parent_path() / one).string(), *text, materials, reader.skipped, notes);
            else
                notes.push_back(reader.file.string() + ":" + std::to_string(line) + ": material library " +
                                in_quotes(one) + " is not there, or outside the scene's folder");
        }
    }
    return materials;
}

void note_grey(std::vector<std::string> &all, const std::string &file, const std::map<std::string, int> &grey) {
    Notes notes;
    for (const auto &[name, n] : grey)
        notes.add("missing materials, taken as grey",
                  file + ": " + std::to_string(n) + (n == 1 ? " face" : " faces") +
                      (name.empty() ? " without a material" : " of the missing material " + in_quotes(name)) +
                      ": grey 0.5 is taken");
    notes.append_to(all);
}

RawScene assemble(ObjReader &reader, const OpenLibrary &open) {
    RawScene raw;
    raw.file = reader.file;
    raw.name = reader.file.stem().string();
    raw.materials = read_libraries(reader, open, raw.notes);
    std::map<std::string, int> index_of, grey;
    for (std::size_t m = 0; m < raw.materials.size(); ++m)
        index_of.emplace(raw.materials[m].name, static_cast<int>(m));
    const std::size_t n_known = raw.materials.size();
    for (const IndexedFace &face : reader.faces) {
        const std::string &material = reader.names.list[static_cast<std::size_t>(face.material)];
        const auto [index, is_new] = index_of.emplace(material, static_cast<int>(raw.materials.size()));
        if (is_new)
            raw.materials.push_back(Material{.name = material}); // that no library has: grey
        RawFace &out = raw.faces.emplace_back();
        out.object = reader.names.list[static_cast<std::size_t>(face.object)];
        out.where = reader.file.string() + ":" + std::to_string(face.line);
        out.material = index->second;
        if (static_cast<std::size_t>(out.material) >= n_known)
            ++grey[material];
        for (const int v : face.vertices) {
            if (static_cast<std::size_t>(v) >= reader.vertices.size())
                throw BadInput(out.where + ": face index " + std::to_string(v + 1) + " is out of range; the file has " +
                               std::to_string(reader.vertices.size()) + " vertices (is it whole?)");
            out.corners.push_back(reader.vertices[static_cast<std::size_t>(v)]);
        }
    }
    note_grey(raw.notes, reader.file.string(), grey);
    reader.skipped.append_to(raw.notes, reader.file.string());
    return raw;
}

} // namespace

Scene read_obj_text(const std::filesystem::path &file, std::string_view text, const OpenLibrary &open, const Vec3 &up) {
    ObjReader reader;
    reader.file = file;
    reader.read(text);
    RawScene raw = assemble(reader, open);
    raw.up = up;
    Scene scene = build_scene(std::move(raw));
    ObjHeader header = read_obj_header(text);
    scene.description = std::move(header.description);
    scene.view = header.view;
    return scene;
}

Scene read_obj(const std::filesystem::path &file, const Vec3 &up) {
    const std::string text = read_text(file, largest_obj);
    const auto open_beside = [&](const std::string &name) -> std::optional<std::string> {
        const auto found = beside(file, name);
        return found ? std::optional(read_text(*found, largest_mtl)) : std::nullopt;
    };
    return read_obj_text(file, text, open_beside, up);
}

} // namespace penumbra
