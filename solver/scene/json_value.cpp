#include "scene/json_value.h"

#include "core/error.h"
#include "core/read_text.h"

#include <cmath>
#include <fmt/format.h>

namespace penumbra {

using nlohmann::json;

namespace {

/// Walks the text without keeping anything, and throws at the first byte that is wrong or one too many. (The library's
/// parser with a callback would do both in one pass, but takes quadratic time for a list of many objects.)
class Bounds : public nlohmann::json_sax<json> {
public:
    Bounds(const std::string &file, std::size_t n_bytes, const JsonLimits &limits)
        : file_(file), n_bytes_(n_bytes), limits_(limits) {}

    bool null() override { return count(); }
    bool boolean(bool) override { return count(); }
    bool number_integer(number_integer_t) override { return count(); }
    bool number_unsigned(number_unsigned_t) override { return count(); }
    bool number_float(number_float_t, const string_t &) override { return count(); }
    bool string(string_t &) override { return count(); }
    bool binary(binary_t &) override { return count(); }
    bool key(string_t &) override { return count(); }
    bool start_object(std::size_t) override { return enter(); }
    bool start_array(std::size_t) override { return enter(); }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    // The library's own messages quote the text, which may be long and of several lines.
    bool parse_error(std::size_t byte, const std::string &, const nlohmann::detail::exception &e) override {
        constexpr int number_out_of_range = 406;
        if (e.id == number_out_of_range)
            throw BadInput(fmt::format(
                "{}: its JSON has a number beyond double precision at byte {}; give finite numbers", file_, byte));
        throw BadInput(fmt::format("{}: is not valid JSON at byte {} of {}; export it again (is it whole?)", file_,
                                   byte, n_bytes_));
    }

private:
    bool count() {
        if (++n_values_ > limits_.values)
            throw BadInput(fmt::format("{}: its JSON has more than {} values; simplify it", file_, limits_.values));
        return true;
    }
    bool enter() {
        if (++depth_ > limits_.depth)
            throw BadInput(
                fmt::format("{}: its JSON is nested deeper than {} levels; flatten it", file_, limits_.depth));
        return count();
    }
    bool leave() {
        --depth_;
        return true;
    }

    const std::string &file_;
    std::size_t n_bytes_;
    const JsonLimits &limits_;
    std::size_t n_values_ = 0;
    int depth_ = 0;
};

} // namespace

json parse_json(const std::string &file, std::string_view text, const JsonLimits &limits) {
    if (text.size() > limits.bytes)
        throw BadInput(
            fmt::format("{}: its JSON is longer than the limit of {} MiB; keep the numbers in a binary buffer", file,
                        limits.bytes >> 20));
    Bounds bounds(file, text.size(), limits);
    json::sax_parse(text.begin(), text.end(), &bounds);
    return json::parse(text.begin(), text.end());
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

std::optional<JsonValue> JsonValue::known(const char *key) const {
    auto found = find(key);
    return found && found->json_->is_null() ? std::nullopt : found;
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
