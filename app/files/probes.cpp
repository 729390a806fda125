#include "files/probes.h"

#include "core/error.h"
#include "core/read_text.h"
#include "iteration/probe.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace penumbra {

namespace {

constexpr std::size_t largest_probe_file = std::size_t{256} << 20;
constexpr std::string_view header = "x,y,z,nx,ny,nz";

Probe probe_from(const TextLine &line, const std::string &where) {
    Probe probe{line.text, {}, {}};
    double n[6];
    std::string_view rest = line.text;
    for (int i = 0; i < 6; ++i) {
        const std::size_t comma = rest.find(',');
        if ((comma == rest.npos) != (i == 5))
            throw BadInput(where + ": row " + in_quotes(line.text) + " has not six columns; give " + std::string(header));
        const auto words = words_of(rest.substr(0, comma));
        if (words.size() != 1 || !number_from(words[0], n[i]) || !std::isfinite(n[i]))
            throw BadInput(where + ": " + in_quotes(rest.substr(0, comma)) + " is not a finite number; give one");
        rest.remove_prefix(std::min(comma, rest.size() - 1) + 1);
    }
    probe.point = {n[0], n[1], n[2]};
    probe.normal = Vec3(n[3], n[4], n[5]).stableNormalized();
    if (!(std::abs(probe.normal.norm() - 1) < 1e-6))
        throw BadInput(where + ": the normal has no length; give the direction that the surface faces");
    return probe;
}

} // namespace

std::vector<Probe> read_probes(const std::filesystem::path &file) {
    const std::vector<TextLine> lines = lines_of(read_text(file, largest_probe_file));
    std::string first = lines.empty() ? std::string() : lines[0].text;
    std::erase(first, ' ');
    if (first != header)
        throw BadInput(file.string() + ":1: the header is " + in_quotes(first) + "; make it " + std::string(header));
    std::vector<Probe> probes;
    for (std::size_t i = 1; i < lines.size(); ++i)
        probes.push_back(probe_from(lines[i], file.string() + ":" + std::to_string(lines[i].number)));
    return probes;
}

std::string probe_csv(const std::vector<Probe> &probes, const Snapshot &snapshot, double size) {
    std::string csv = std::string(header) + ",r,g,b\n";
    for (const Probe &probe : probes) {
        const auto b = radiosity_at(snapshot, probe.point, probe.normal, 1e-6 * size);
        csv += b ? fmt::format("{},{},{},{}\n", probe.row, (*b)[0], (*b)[1], (*b)[2]) : probe.row + ",nan,nan,nan\n";
    }
    return csv;
}

} // namespace penumbra
