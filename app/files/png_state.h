// The state that a picture carries, taken from the file's bytes without a look at its pixels.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace penumbra {

inline constexpr char png_state_key[] = "penumbra";                ///< keyword of the iTXt chunk
inline constexpr std::size_t largest_png = std::size_t{256} << 20; ///< bytes

/// Whether it begins as a PNG does.
bool is_png(std::string_view bytes);

/// The text of the first iTXt chunk `penumbra`, compressed or not (PNG, third edition, 11.3.3.4), or nothing where
/// there is none. That chunk's CRC is checked; a text that inflates beyond `longest` bytes is refused before more is
/// made of it. Throws BadInput, one line, where `bytes` are no PNG, end within a chunk before the text was found, or
/// the text is damaged; `file` is what messages call it.
std::optional<std::string> state_in_png(const std::string &file, std::string_view bytes, std::size_t longest);

} // namespace penumbra
