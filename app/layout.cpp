#include "layout.h"

namespace penumbra {

std::string_view name(Layout layout) {
    constexpr std::string_view names[n_layouts] = {"single", "two", "four", "wipe", "flip", "difference"};
    return names[static_cast<std::size_t>(layout)];
}

std::optional<Layout> layout_from_name(std::string_view text) {
    for (std::size_t i = 0; i < n_layouts; ++i)
        if (const auto layout = static_cast<Layout>(i); name(layout) == text)
            return layout;
    return std::nullopt;
}

} // namespace penumbra
