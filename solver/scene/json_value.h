// A place in a parsed JSON file: typed access whose errors name the file, the place and the value.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

/// Bounds that hold before anything is built of a text: deep nesting, many small values, long texts.
struct JsonLimits {
    std::size_t bytes = std::size_t{64} << 20;
    int depth = 64;
    std::size_t values = 1'000'000; ///< members and keys together
};

/// Parses `text`. Throws BadInput, one line with the byte, for what is no JSON or exceeds a limit.
nlohmann::json parse_json(const std::string &file, std::string_view text, const JsonLimits &limits = {});

/// Refers to the parsed file, which must outlive it. Every call throws BadInput where the value is not of that kind.
class JsonValue {
public:
    JsonValue(const nlohmann::json &root, const std::string &file) : json_(&root), file_(&file) {}

    /// The member of an object; nothing when it is absent.
    std::optional<JsonValue> find(const char *key) const;
    JsonValue operator[](const char *key) const;
    /// The array of that name; an empty one when it is absent.
    JsonValue list(const char *key) const;
    /// The same; nothing also when it is null.
    std::optional<JsonValue> known(const char *key) const;
    std::size_t size() const;          ///< of an array
    JsonValue at(std::size_t i) const; ///< of an array; i < size()
    double number() const;
    bool boolean() const;
    std::string text() const;
    std::string text(std::size_t longest) const; ///< of at most so many bytes
    /// A whole number in [least, most].
    std::int64_t integer(std::int64_t least, std::int64_t most) const;
    /// An index into `list`, which the message names.
    std::size_t index_into(const JsonValue &list) const;

    [[noreturn]] void fail(const std::string &what) const;
    const std::string &path() const { return path_; } ///< "nodes[3].mesh"

private:
    JsonValue(const nlohmann::json &json, const std::string &file, std::string path)
        : json_(&json), file_(&file), path_(std::move(path)) {}
    std::string shown() const;

    const nlohmann::json *json_;
    const std::string *file_;
    std::string path_;
};

} // namespace penumbra
