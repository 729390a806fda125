#include "scene/wavefront_line.h"

#include "core/error.h"
#include "core/read_text.h"
#include "scene/validate.h"

#include <fmt/format.h>

namespace penumbra {

std::string WavefrontLine::name() const {
    if (words.size() < 2)
        return {};
    std::string out = text.substr(static_cast<std::size_t>(words[1].data() - text.data()));
    if (out.size() > longest_name)
        fail(fmt::format("a name of {} bytes is too long; give at most {}", out.size(), longest_name));
    return out;
}

void WavefrontLine::fail(const std::string &what) const {
    throw BadInput(fmt::format("{}:{}: {}", file, number, what));
}

void for_each_wavefront_line(const std::string &file, std::string_view text,
                             const std::function<void(const WavefrontLine &)> &take) {
    for_each_line(text, [&](const TextLine &line) {
        WavefrontLine out{file, line.number, line.text, {}};
        if (line.text.size() > longest_line)
            out.fail(fmt::format("the line is longer than {} KiB; split it", longest_line >> 10));
        out.words = words_of(line.text);
        take(out);
    });
}

} // namespace penumbra
