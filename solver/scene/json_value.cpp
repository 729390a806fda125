#include "scene/json_value.h"

#include "core/error.h"
#include "core/read_text.h"

#include <cmath>
#include <fmt/format.h>

namespace penumbra {

using nlohmann::json;

json parse_json(const std::string &file, std::string_view text, const JsonLimits &limits) {
    if (text.size() > limits.bytes)
        throw BadInput(fmt::format("{}: its JSON is longer than the limit of {} MiB; keep the numbers in a binary buffer",
                                   file, limits.bytes >> 20));
    std::size_t n_values = 0;
    const auto bounded = [&](int depth, json::parse_event_t, json &) {
        if (depth > limits.depth)
            throw BadInput(fmt::format("{}: its JSON is nested deeper than {} levels; flatten it", file, limits.depth));
        if (++n_values > limits.values)
            throw BadInput(fmt::format("{}: its JSON has more than {} values; simplify it", file, limits.values));
        return true;
    };
    // The library's own messages quote the text, which may be long and of several lines.
    try {
        return json::parse(text.begin(), text.end(), bounded);
    } catch (const json::parse_error &e) {
        throw BadInput(fmt::format("{}: is not valid JSON at byte {} of {}; export it again (is it whole?)", file, e.byte,
                                   text.size()));
    } catch (const json::exception &) {
        throw BadInput(file + ": its JSON has a number beyond double precision; give finite numbers");
    }
}

void JsonValue::fail(const std::string &what) const {
    throw BadInput(*file_ + ": " + (path_.empty() ? "the file" : path_) + " " + what);
}

std::string JsonValue::shown() const {
    if (json_->is_string())
        return in_quotes(json_->get_ref<const std::string &>());
    if (json_->is_structured())
        return fmt::format("{} of {}", json_->is_array() ? "an array" : "an object", json_->size());
    return json_->is_number_float() ? fmt::format("{:g}", json_->get<double>()) : json_->dump();
}

std::optional<JsonValue> JsonValue::find(const char *key) const {
    if (!json_->is_object())
        fail("is " + shown() + "; give an object");
    const auto found = json_->find(key);
    if (found == json_->end())
        return std::nullopt;
    return JsonValue(*found, *file_, path_.empty() ? key : path_ + "." + key);
}

JsonValue JsonValue::operator[](const char *key) const {
    auto found = find(key);
    if (!found)
        fail(std::string("has no ") + key + "; give one");
    return *found;
}

JsonValue JsonValue::list(const char *key) const {
    static const json none = json::array();
    auto found = find(key);
    if (!found)
        return {none, *file_, path_.empty() ? key : path_ + "." + key};
    found->size();
    return *found;
}

std::size_t JsonValue::size() const {
    if (!json_->is_array())
        fail("is " + shown() + "; give an array");
    return json_->size();
}

JsonValue JsonValue::at(std::size_t i) const { return {(*json_)[i], *file_, fmt::format("{}[{}]", path_, i)}; }

double JsonValue::number() const {
    if (!json_->is_number())
        fail("is " + shown() + "; give a number");
    return json_->get<double>();
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean())
        fail("is " + shown() + "; give true or false");
    return json_->get<bool>();
}

std::string JsonValue::text() const {
    if (!json_->is_string())
        fail("is " + shown() + "; give a string");
    return json_->get<std::string>();
}

std::string JsonValue::text(std::size_t longest) const {
    std::string out = text();
    if (out.size() > longest)
        fail(fmt::format("is a text of {} bytes; give at most {}", out.size(), longest));
    return out;
}

std::int64_t JsonValue::integer(std::int64_t least, std::int64_t most) const {
    const double value = number(); // exact as far as any bound in use goes; some exporters write 3.0
    if (!(value >= static_cast<double>(least) && value <= static_cast<double>(most)) || value != std::floor(value))
        fail(fmt::format("is {}; give a whole number from {} to {}", shown(), least, most));
    return static_cast<std::int64_t>(value);
}

std::size_t JsonValue::index_into(const JsonValue &list) const {
    const std::size_t n = list.size();
    const double value = number();
    if (!(value >= 0 && value < static_cast<double>(n)) || value != std::floor(value))
        fail(fmt::format("is {}, out of range; there are {} {}", shown(), n, list.path()));
    return static_cast<std::size_t>(value);
}

} // namespace penumbra
