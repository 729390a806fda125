#include "scene/read_obj.h"

#include "core/error.h"
#include "core/read_text.h"
#include "scene/build_scene.h"
#include "scene/obj_header.h"
#include "scene/read_mtl.h"

#include <algorithm>
#include <charconv>

namespace penumbra {

namespace {

/// A face while vertices that it may name are still to come.
struct IndexedFace {
    int line = 0;
    std::string object;
    std::string material;
    std::vector<long long> vertices; ///< from 0; not yet compared with the number of vertices
};

struct ObjReader {
    std::filesystem::path file;
    std::vector<Vec3> vertices;
    std::vector<IndexedFace> faces;
    std::vector<std::pair<int, std::string>> libraries; ///< line and name
    std::string object, material;
    Skipped skipped;

    [[noreturn]] void fail(int line, const std::string &what) const {
        throw BadInput(file.string() + ":" + std::to_string(line) + ": " + what);
    }

    void read_vertex(const TextLine &line, const std::vector<std::string_view> &words) {
        if (words.size() < 4)
            fail(line.number, "a vertex has " + std::to_string(words.size() - 1) + " coordinates; give three (is the file whole?)");
        Vec3 x;
        for (std::size_t i = 0; i < 3; ++i) {
            double &c = x[static_cast<Eigen::Index>(i)];
            if (!number_from(words[1 + i], c))
                fail(line.number, "coordinate " + in_quotes(words[1 + i]) + " is not a number; write it as 12.5 or 1e-3");
            if (!std::isfinite(c))
                fail(line.number, "coordinate " + in_quotes(words[1 + i]) + " is not finite; give a finite number");
        }
        vertices.push_back(x);
    }

    /// `7`, `7/1`, `7//3`, `7/1/3`: the first number counts, from 1, or back from the newest vertex when negative.
    long long read_corner(const TextLine &line, std::string_view word) const {
        const std::string_view digits = word.substr(0, word.find('/'));
        long long index = 0;
        const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (status != std::errc{} || end != digits.data() + digits.size())
            fail(line.number, "face index " + in_quotes(word) + " is not a whole number; write it as 7, 7/1 or 7//3");
        if (index == 0)
            fail(line.number, "face index 0 is out of range; indices count from 1");
        const auto n = static_cast<long long>(vertices.size());
        if (index < -n)
            fail(line.number, "face index " + std::to_string(index) + " is out of range; only " + std::to_string(n) +
                                  " vertices stand before it");
        return index > 0 ? index - 1 : n + index;
    }

    void read_face(const TextLine &line, const std::vector<std::string_view> &words) {
        if (words.size() < 4)
            fail(line.number, "a face has " + std::to_string(words.size() - 1) + " corners; give at least three (is the file whole?)");
        IndexedFace &face = faces.emplace_back(IndexedFace{line.number, object, material, {}});
        for (std::size_t i = 1; i < words.size(); ++i)
            face.vertices.push_back(read_corner(line, words[i]));
    }

    void read(std::string_view text) {
        for (const TextLine &line : lines_of(text)) {
            const auto words = words_of(line.text);
            const auto rest = [&] {
                return words.size() < 2 ? std::string()
                                        : line.text.substr(static_cast<std::size_t>(words[1].data() - line.text.data()));
            };
            if (words[0] == "v")
                read_vertex(line, words);
            else if (words[0] == "f" || words[0] == "fo")
                read_face(line, words);
            else if (words[0] == "o" || words[0] == "g")
                object = rest();
            else if (words[0] == "usemtl")
                material = rest();
            else if (words[0] == "mtllib")
                libraries.emplace_back(line.number, rest());
            else
                ++skipped[std::string(words[0])];
        }
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

/// Index of the named material; those that no library has become grey.
int material_index(std::vector<Material> &materials, const std::string &name) {
    auto found = std::ranges::find(materials, name, &Material::name);
    if (found == materials.end())
        found = materials.insert(materials.end(), Material{.name = name});
    return static_cast<int>(found - materials.begin());
}

void note_grey(std::vector<std::string> &notes, const std::string &file, const std::map<std::string, int> &grey) {
    for (const auto &[name, n] : grey)
        notes.push_back(file + ": " + std::to_string(n) + (n == 1 ? " face" : " faces") +
                        (name.empty() ? " without a material" : " of the missing material " + in_quotes(name)) +
                        ": grey 0.5 is taken");
}

void note_skipped(std::vector<std::string> &notes, const std::string &file, const Skipped &skipped) {
    if (skipped.empty())
        return;
    std::string note = file + ": skipped, as they mean nothing here:";
    constexpr std::size_t most = 20;
    std::size_t n = 0;
    for (auto it = skipped.begin(); it != skipped.end() && n < most; ++it, ++n)
        note += (n ? ", " : " ") + in_quotes(it->first) + " " + std::to_string(it->second) + "x";
    notes.push_back(note + (skipped.size() > most ? " and other keywords" : ""));
}

RawScene assemble(ObjReader &reader, const OpenLibrary &open) {
    RawScene raw;
    raw.file = reader.file;
    raw.name = reader.file.stem().string();
    raw.materials = read_libraries(reader, open, raw.notes);
    const std::size_t n_known = raw.materials.size();
    std::map<std::string, int> grey;
    for (const IndexedFace &face : reader.faces) {
        RawFace &out = raw.faces.emplace_back();
        out.object = face.object;
        out.where = reader.file.string() + ":" + std::to_string(face.line);
        out.material = material_index(raw.materials, face.material);
        if (static_cast<std::size_t>(out.material) >= n_known)
            ++grey[face.material];
        for (const long long v : face.vertices) {
            if (v >= static_cast<long long>(reader.vertices.size()))
                reader.fail(face.line, "face index " + std::to_string(v + 1) + " is out of range; the file has " +
                                           std::to_string(reader.vertices.size()) + " vertices (is it whole?)");
            out.corners.push_back(reader.vertices[static_cast<std::size_t>(v)]);
        }
    }
    note_grey(raw.notes, reader.file.string(), grey);
    note_skipped(raw.notes, reader.file.string(), reader.skipped);
    return raw;
}

/// A library beside the scene or below it; others are not opened.
std::optional<std::string> open_beside(const std::filesystem::path &folder, std::string name) {
    std::ranges::replace(name, '\\', '/');
    const std::filesystem::path relative = std::filesystem::path(name).lexically_normal();
    if (relative.empty() || relative.is_absolute() || *relative.begin() == "..")
        return std::nullopt;
    const std::filesystem::path file = folder / relative;
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
        return std::nullopt;
    return read_text(file, largest_mtl);
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
    return read_obj_text(file, text, [&](const std::string &name) { return open_beside(file.parent_path(), name); }, up);
}

} // namespace penumbra
