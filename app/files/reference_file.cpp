#include "files/reference_file.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <type_traits>

namespace penumbra {

namespace {

constexpr std::uint64_t format = 0x31'66'65'72'62'6d'75'70; // "pumbref1" where bytes are in the order of most machines

/// FNV-1a, word by word (Fowler, Noll & Vo).
struct Sum {
    std::uint64_t value = 0xcbf29ce484222325;

    void add(std::uint64_t word) { value = (value ^ word) * 0x100000001b3; }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const auto &vector) {
        for (const double x : vector)
            add(x);
    }
};

std::uint64_t sum_of(const Scene &scene) {
    Sum sum;
    sum.add(format);
    for (const Surface &s : scene.surfaces) {
        sum.add(std::uint64_t(s.corners.size()) + (s.back ? 1u << 31 : 0u));
        for (const Vec3 &x : s.corners)
            sum.add(x);
        const Material &m = scene.materials[static_cast<std::size_t>(s.material)];
        sum.add(m.reflectance);
        sum.add(m.exitance);
    }
    return sum.value;
}

/// A node as it stands in the file.
struct Node {
    std::int32_t surface, parent, first_child, n_children, order, unused;
    std::array<double, 8> corners;
};
static_assert(std::is_trivially_copyable_v<Node> && std::has_unique_object_representations_v<std::int32_t> &&
              sizeof(Node) == 6 * 4 + 8 * 8);

struct Header {
    std::uint64_t format, scene;
    std::int64_t n_nodes, n_coefficients;
    double tolerance, error;
};

template <class T>
void append(std::string &bytes, const T *first, std::size_t n) {
    bytes.append(reinterpret_cast<const char *>(first), n * sizeof(T));
}

/// Takes the next values off; false when there are not as many.
template <class T>
bool take(std::span<const char> &bytes, T *first, std::size_t n) {
    if (bytes.size() / sizeof(T) < n)
        return false;
    std::memcpy(first, bytes.data(), n * sizeof(T));
    bytes = bytes.subspan(n * sizeof(T));
    return true;
}

std::uint64_t sum_of(std::span<const char> bytes) {
    Sum sum;
    std::uint64_t word = 0;
    while (take(bytes, &word, 1))
        sum.add(word);
    return sum.value;
}

bool sound(const Node &node, std::size_t index, const std::vector<Node> &nodes, const Scene &scene) {
    const auto within = [](std::int64_t i, std::int64_t low, std::size_t high) {
        return i >= low && i < static_cast<std::int64_t>(high);
    };
    return within(node.surface, 0, scene.surfaces.size()) && within(node.parent, -1, index) && within(node.order, 1, 5) &&
           within(node.n_children, 0, nodes.size()) &&
           (node.n_children == 0 || (node.first_child > static_cast<std::int64_t>(index) &&
                                     within(std::int64_t(node.first_child) + node.n_children - 1, 0, nodes.size())));
}

/// The forest of these nodes; null when they are none.
std::shared_ptr<Forest> planted(const Scene &scene, const std::vector<Node> &nodes) {
    auto forest = std::make_shared<Forest>();
    forest->roots.resize(scene.surfaces.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node &node = nodes[i];
        if (!sound(node, i, nodes, scene))
            return nullptr;
        Element e;
        BilinearQuad quad;
        for (std::size_t c = 0; c < 4; ++c)
            quad.corners[c] = {node.corners[2 * c], node.corners[2 * c + 1]};
        e.basis = ElementBasis(node.order, quad);
        e.surface = SurfaceId(node.surface);
        e.first = forest->n_coefficients;
        if (node.parent >= 0) {
            e.parent = ElementId(node.parent);
            e.filters = std::make_shared<const TwoScale>(two_scale((*forest)[e.parent].basis, e.basis));
        } else {
            forest->roots[e.surface.at()].emplace_back(i);
        }
        if (node.n_children > 0)
            e.first_child = ElementId(node.first_child);
        e.n_children = node.n_children;
        forest->n_coefficients += e.basis.n_functions();
        forest->elements.push_back(std::move(e));
    }
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        if (forest->roots[s].empty())
            return nullptr;
    return forest;
}

} // namespace

std::filesystem::path reference_path(const std::filesystem::path &folder, const Scene &scene) {
    return folder / "references" / fmt::format("{:016x}.reference", sum_of(scene));
}

std::string reference_bytes(const Scene &scene, const KeptSolution &kept) {
    const Forest &forest = *kept.solution.forest;
    const Header header{format,         sum_of(scene),         static_cast<std::int64_t>(forest.elements.size()), forest.n_coefficients,
                        kept.tolerance, kept.solution.error};
    std::string bytes;
    append(bytes, &header, 1);
    for (const Element &e : forest.elements) {
        Node node{e.surface.index, e.parent.valid() ? e.parent.index : -1, e.leaf() ? -1 : e.first_child.index,
                  e.n_children, e.basis.order(), 0, {}};
        for (std::size_t c = 0; c < 4; ++c) {
            node.corners[2 * c] = e.basis.quad()->corners[c].x();
            node.corners[2 * c + 1] = e.basis.quad()->corners[c].y();
        }
        append(bytes, &node, 1);
    }
    append(bytes, kept.solution.radiosity.data(), static_cast<std::size_t>(kept.solution.radiosity.size()));
    const std::uint64_t sum = sum_of(std::span<const char>(bytes));
    append(bytes, &sum, 1);
    return bytes;
}

std::optional<KeptSolution> read_reference(const Scene &scene, const std::string &bytes) {
    std::span<const char> rest(bytes);
    Header header{};
    if (!take(rest, &header, 1) || header.format != format || header.scene != sum_of(scene) ||
        !(header.tolerance > 0) || !(header.error >= 0))
        return std::nullopt;
    const auto n_nodes = static_cast<std::uint64_t>(header.n_nodes), n_rows = static_cast<std::uint64_t>(header.n_coefficients);
    if (n_nodes > rest.size() / sizeof(Node) || n_rows > rest.size() / (3 * sizeof(double)) ||
        rest.size() != n_nodes * sizeof(Node) + (3 * n_rows + 1) * sizeof(double))
        return std::nullopt;
    std::vector<Node> nodes(n_nodes);
    KeptSolution kept{header.tolerance, {nullptr, Coefficients(header.n_coefficients, 3), header.error}};
    std::uint64_t sum = 0;
    take(rest, nodes.data(), nodes.size());
    take(rest, kept.solution.radiosity.data(), 3 * n_rows);
    take(rest, &sum, 1);
    if (sum != sum_of(std::span(bytes).first(bytes.size() - sizeof sum)))
        return std::nullopt;
    const auto forest = planted(scene, nodes);
    if (!forest || forest->n_coefficients != header.n_coefficients)
        return std::nullopt;
    kept.solution.forest = forest;
    return kept;
}

} // namespace penumbra
