// How the panes stand: side by side, or two of them in one place.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace penumbra {

/// `wipe`: one place, the first pane left of a divider, the second right of it. `flip`: one place, the active pane alone.
/// `difference`: one place, the second pane minus the first.
enum class Layout { single, two, four, wipe, flip, difference };
inline constexpr std::size_t n_layouts = 6;

/// Panes that are solved for.
constexpr int n_panes(Layout layout) { return layout == Layout::single ? 1 : layout == Layout::four ? 4 : 2; }
/// Places that they stand in.
constexpr int n_places(Layout layout) { return layout == Layout::two ? 2 : layout == Layout::four ? 4 : 1; }
constexpr bool share_a_place(Layout layout) { return n_places(layout) < n_panes(layout); }

/// Layouts that compare two strategies compare the same two.
inline constexpr std::size_t n_pane_sets = 3;
constexpr std::size_t pane_set_of(Layout layout) { return n_panes(layout) == 1 ? 0 : n_panes(layout) == 2 ? 1 : 2; }

/// `single`, `two`, `four`, `wipe`, `flip`, `difference`; the public names.
std::string_view name(Layout layout);
std::optional<Layout> layout_from_name(std::string_view name);
/// Side by side.
constexpr Layout layout_of(std::size_t n_strategies) {
    return n_strategies == 1 ? Layout::single : n_strategies == 2 ? Layout::two : Layout::four;
}

} // namespace penumbra
