#include "files/profile_csv.h"

#include <fmt/format.h>

namespace penumbra {

namespace {

std::string row(std::string_view curve, const ProfileLine &line, const ProfilePoint &p, const std::string &element) {
    const Vec3 x = line.at(p.at);
    return fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}\n", curve, p.at,
                       x[0], x[1], x[2], p.radiosity[0], p.radiosity[1], p.radiosity[2], p.slope[0], p.slope[1],
                       p.slope[2], element);
}

} // namespace

std::string profile_csv(const ProfileLine &line, const ProfileData &data) {
    std::string csv = "curve,at,x,y,z,r,g,b,slope_r,slope_g,slope_b,element\n";
    for (const ProfilePoint &p : data.exact)
        csv += row("truth", line, p, "");
    for (const ProfileCurve &curve : data.curves)
        for (std::size_t i = 0; i < curve.pieces.size(); ++i)
            for (const ProfilePoint &p : curve.pieces[i].points)
                csv += row(std::string(name(curve.strategy)) + (curve.reconstructed ? " as quadratics" : ""), line, p,
                           std::to_string(i));
    return csv;
}

} // namespace penumbra
