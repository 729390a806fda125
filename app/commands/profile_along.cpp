#include "commands/profile_along.h"

#include "capture.h"
#include "core/atomic_write.h"
#include "core/error.h"
#include "files/profile_csv.h"
#include "plot/plot_picture.h"
#include "plot/svg_canvas.h"
#include "profile_data.h"

namespace penumbra {

ProfileLine find_line(const Snapshot &snapshot, const Vec3 &from, const Vec3 &to, double size,
                      const std::string &field) {
    const auto line = line_over(snapshot, from, to, 1e-3 * size);
    if (!line)
        throw BadInput(field +
                       ": no surface that reflects holds both points to within a thousandth of the scene's size, or "
                       "they are one point; give two points of one floor, wall or table");
    return *line;
}

ProfileData profile_along(const ProfileLine &line, const std::vector<std::shared_ptr<const Snapshot>> &solutions,
                          const Truth &truth, const Cancel *cancel) {
    const Snapshot &first = *solutions.front();
    ProfileData data = profile_frame(first, line);
    for (const auto &snapshot : solutions)
        data.curves.push_back(profile_curve(*snapshot, line));
    data.exact = true_profile(truth, first.surfaces[static_cast<std::size_t>(line.surface)], line, n_profile_points,
                              break_places(data), cancel);
    data.truth_error = truth.error;
    return data;
}

void write_profile(const std::filesystem::path &picture, const ProfileLine &line, const ProfileData &data,
                   Theme theme) {
    constexpr int width = 1280, height = 860;
    const PlotLook look{17, theme};
    const auto draw = [&](Canvas &canvas) { draw_profile_figure(canvas, {width, height}, data, look); };
    const auto beside = [&](const char *ending) {
        return picture.parent_path() / (picture.stem().string() + "-profile" + ending);
    };
    write_png(beside(".png"), draw_plot_picture(width, height, look.text, theme, draw));
    SvgCanvas svg(width, height);
    svg.fill({{0, 0}, {width, height}}, background_colour(theme));
    draw(svg);
    write_atomically(beside(".svg"), svg.file());
    write_atomically(beside(".csv"), profile_csv(line, data));
}

} // namespace penumbra
