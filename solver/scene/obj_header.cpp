#include "scene/obj_header.h"

#include "core/read_text.h"

#include <algorithm>
#include <cmath>

namespace penumbra {

std::optional<View> view_from(std::string_view text) {
    const auto words = words_of(text);
    double n[7];
    if (words.size() != std::size(n))
        return std::nullopt;
    for (std::size_t i = 0; i < std::size(n); ++i)
        if (!number_from(words[i], n[i]) || !std::isfinite(n[i]))
            return std::nullopt;
    const View view{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6]};
    if (view.eye == view.target || !(view.fov_degrees > 0 && view.fov_degrees < 180))
        return std::nullopt;
    return view;
}

ObjHeader read_obj_header(std::string_view text) {
    constexpr std::string_view penumbra = "# penumbra:", view = "# view:";
    ObjHeader header;
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    while (text.starts_with('#')) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(penumbra) && header.description.empty()) {
            const std::string_view rest = line.substr(penumbra.size());
            header.description = rest.substr(std::min(rest.find_first_not_of(' '), rest.size()));
        } else if (line.starts_with(view)) {
            header.view = view_from(line.substr(view.size()));
        }
        text.remove_prefix(std::min(text.find_first_not_of("\r\n", end), text.size()));
    }
    return header;
}

} // namespace penumbra
