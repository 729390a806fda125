// A matrix as a heat map of signed values.
#pragma once

#include <Eigen/Core>
#include <imgui.h>

#include <optional>

namespace penumbra {

struct MatrixCell {
    int row = 0, column = 0;
};

/// At the cursor, `side` wide and high, on the colours from -range to range; row 0 at the top. Returns the cell under
/// the mouse. Range 0: all cells have the colour of 0.
std::optional<MatrixCell> draw_matrix_map(const char *name, const Eigen::MatrixXd &matrix, double range, float side);

/// Text that runs upward, its middle at `middle` along a line that begins at `left`, from there to the right.
void draw_upward(const char *text, float left, float middle, ImU32 colour, float size);

/// The colours with the ends of the range below.
void draw_map_scale(double range, float width);

} // namespace penumbra
