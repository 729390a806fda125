#include "scene/gltf_buffers.h"

#include "core/read_text.h"
#include "scene/gltf_container.h"

#include <bit>
#include <fmt/format.h>

namespace penumbra {

namespace {

constexpr std::int64_t most = std::int64_t{1} << 32; // no sum or product of two such numbers overflows

template <class T>
T little_endian(std::string_view bytes, std::size_t at) {
    std::make_unsigned_t<T> value = 0;
    for (std::size_t i = sizeof(T); i-- > 0;)
        value =
            static_cast<std::make_unsigned_t<T>>(std::uint64_t{value} << 8 | static_cast<unsigned char>(bytes[at + i]));
    return static_cast<T>(value);
}

std::size_t size_of_component(int component) {
    switch (component) {
    case 5120: // signed and unsigned bytes
    case 5121:
        return 1;
    case 5122: // shorts
    case 5123:
        return 2;
    default: // unsigned int, float
        return 4;
    }
}

/// A signed or unsigned whole number, or the fraction of its type's largest that it stands for.
double component_at(const GltfAccessor &a, std::size_t at) {
    const auto scaled = [&](auto value) {
        using T = decltype(value);
        const double x = static_cast<double>(value);
        return a.normalized ? std::max(x / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : x;
    };
    switch (a.component) {
    case 5120:
        return scaled(little_endian<std::int8_t>(a.bytes, at));
    case 5121:
        return scaled(little_endian<std::uint8_t>(a.bytes, at));
    case 5122:
        return scaled(little_endian<std::int16_t>(a.bytes, at));
    case 5123:
        return scaled(little_endian<std::uint16_t>(a.bytes, at));
    case 5125:
        return scaled(little_endian<std::uint32_t>(a.bytes, at));
    default:
        return static_cast<double>(std::bit_cast<float>(little_endian<std::uint32_t>(a.bytes, at)));
    }
}

/// %20 and the like; nothing where two hexadecimal digits do not follow.
std::optional<std::string> decode_percent(std::string_view uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            out += uri[i];
            continue;
        }
        const auto hex = [&](std::size_t at) {
            return at < uri.size() ? std::string_view("0123456789abcdef")
                                         .find(static_cast<char>(std::tolower(static_cast<unsigned char>(uri[at]))))
                                   : std::string_view::npos;
        };
        const std::size_t high = hex(i + 1), low = hex(i + 2);
        if (high == std::string_view::npos || low == std::string_view::npos)
            return std::nullopt;
        out += static_cast<char>(high * 16 + low);
        i += 2;
    }
    return out;
}

} // namespace

Vec3 GltfAccessor::vec3(std::size_t i) const {
    const std::size_t size = size_of_component(component);
    return {component_at(*this, i * stride), component_at(*this, i * stride + size),
            component_at(*this, i * stride + 2 * size)};
}

std::uint32_t GltfAccessor::index(std::size_t i) const {
    return static_cast<std::uint32_t>(component_at(*this, i * stride)); // exact: up to 32 bits
}

std::string GltfBuffers::load(const JsonValue &buffer) {
    constexpr std::string_view data = "data:", marker = ";base64,";
    const JsonValue place = buffer["uri"];
    const std::string uri = place.text();
    if (uri.starts_with(data)) {
        const std::size_t at = uri.find(marker);
        auto bytes = at == uri.npos ? std::nullopt : decode_base64(std::string_view(uri).substr(at + marker.size()));
        if (!bytes)
            place.fail("is " + in_quotes(uri) + ", which is no base64 data; export it again");
        return std::move(*bytes);
    }
    const auto name = decode_percent(uri);
    if (!name || name->find('\0') != name->npos)
        place.fail("is " + in_quotes(uri) + ", which is malformed; give a file name");
    auto bytes = open_(*name);
    if (!bytes)
        place.fail("is " + in_quotes(uri) +
                   ", which is not there, or outside the scene's folder; put it beside the scene");
    return std::move(*bytes);
}

std::string_view GltfBuffers::buffer(const JsonValue &index) {
    const JsonValue buffers = root_.list("buffers");
    const std::size_t i = index.index_into(buffers);
    const JsonValue buffer = buffers.at(i);
    std::string_view bytes;
    if (i == 0 && binary_ && !buffer.find("uri")) {
        bytes = *binary_;
    } else {
        auto found = loaded_.find(i);
        if (found == loaded_.end()) {
            found = loaded_.emplace(i, load(buffer)).first;
            n_loaded_ += found->second.size();
            if (n_loaded_ > largest_buffers)
                buffer.fail(fmt::format("makes the buffers longer than {} MiB; split or simplify the scene",
                                        largest_buffers >> 20));
        }
        bytes = found->second;
    }
    const JsonValue length = buffer["byteLength"];
    const auto n = static_cast<std::size_t>(length.integer(1, most));
    if (n > bytes.size())
        length.fail(
            fmt::format("is {} but the buffer holds {} bytes; export it again (is it whole?)", n, bytes.size()));
    return bytes.substr(0, n);
}

std::string_view GltfBuffers::view(const JsonValue &index, std::size_t &stride) {
    const JsonValue views = root_.list("bufferViews");
    const JsonValue view = views.at(index.index_into(views));
    if (const auto extensions = view.find("extensions"); extensions && extensions->find("EXT_meshopt_compression"))
        view.fail("is compressed (EXT_meshopt_compression), which is not read; export it without compression");
    const std::string_view bytes = buffer(view["buffer"]);
    const auto offset = view.find("byteOffset");
    const auto from = static_cast<std::size_t>(offset ? offset->integer(0, most) : 0);
    const JsonValue length = view["byteLength"];
    const auto n = static_cast<std::size_t>(length.integer(1, most));
    if (from + n > bytes.size())
        length.fail(
            fmt::format("is {} from byte {} on, beyond the buffer's {}; export it again", n, from, bytes.size()));
    const auto step = view.find("byteStride");
    stride = static_cast<std::size_t>(step ? step->integer(1, 252) : 0);
    return bytes.substr(from, n);
}

GltfAccessor GltfBuffers::access(const JsonValue &index, const char *type, std::size_t n_components) {
    const JsonValue accessors = root_.list("accessors");
    const JsonValue accessor = accessors.at(index.index_into(accessors));
    if (accessor.find("sparse"))
        accessor.fail("is sparse, which is not read; export it without sparse accessors");
    if (accessor["type"].text() != type)
        accessor["type"].fail(fmt::format("is {}; give {}", in_quotes(accessor["type"].text()), type));
    if (!accessor.find("bufferView"))
        accessor.fail("has no bufferView (is it compressed?); export it with plain buffers");
    GltfAccessor out;
    out.path = accessor.path();
    const JsonValue component = accessor["componentType"];
    out.component = static_cast<int>(component.integer(5120, 5126));
    if (out.component == 5124)
        component.fail("is 5124, which glTF does not have; give 5120 to 5123, 5125 or 5126");
    const auto normalized = accessor.find("normalized");
    out.normalized = normalized && normalized->boolean();
    out.count = static_cast<std::size_t>(accessor["count"].integer(1, most));
    const std::size_t element = n_components * size_of_component(out.component);
    out.bytes = view(accessor["bufferView"], out.stride);
    if (out.stride == 0)
        out.stride = element;
    if (out.stride < element)
        accessor.fail(
            fmt::format("has elements of {} bytes at a byteStride of {}; export it again", element, out.stride));
    const auto offset = accessor.find("byteOffset");
    const auto from = static_cast<std::size_t>(offset ? offset->integer(0, most) : 0);
    const std::size_t end = from + (out.count - 1) * out.stride + element;
    if (end > out.bytes.size())
        accessor.fail(fmt::format("reaches to byte {} of a bufferView of {}; export it again", end, out.bytes.size()));
    out.bytes.remove_prefix(from);
    return out;
}

GltfAccessor GltfBuffers::positions(const JsonValue &accessor) {
    GltfAccessor out = access(accessor, "VEC3", 3);
    return out;
}

GltfAccessor GltfBuffers::indices(const JsonValue &accessor) {
    GltfAccessor out = access(accessor, "SCALAR", 1);
    if (out.component != 5121 && out.component != 5123 && out.component != 5125)
        accessor.fail(fmt::format("is an accessor of componentType {}; indices are 5121, 5123 or 5125", out.component));
    out.normalized = false;
    return out;
}

} // namespace penumbra
