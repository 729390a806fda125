#include "render/error_scale.h"

#include "iteration/error_map.h"
#include "render/diverging.h"
#include "render/tone.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace penumbra {

namespace {

constexpr double covered_share = 0.998; ///< of the values, inside the range
constexpr double most_decades = 4;

/// The value that this share of all are not above; reorders them.
double quantile(std::vector<double> &values, double share) {
    if (values.empty())
        return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, at);
    return *at;
}

double rounded_up(double x) {
    const double unit = std::pow(10.0, std::floor(std::log10(x)));
    for (const double m : {1.0, 2.0, 5.0})
        if (x <= m * unit * (1 + 1e-9))
            return m * unit;
    return 10 * unit;
}

/// Sizes of what is shown; of whole patches by their number, of points by the lattice's.
std::vector<double> sizes(ErrorKind kind, std::span<const Judged> judged) {
    std::vector<double> all;
    for (const Judged &j : judged)
        for (std::size_t i = 0; j.errors && i < j.errors->patches.size(); ++i) {
            if (kind == ErrorKind::patch || kind == ErrorKind::estimate) {
                if (const double value = patch_value(kind, *j.snapshot, *j.errors, i); value > 0)
                    all.push_back(kind == ErrorKind::estimate ? std::max(value, 1 / value) : value);
                continue;
            }
            for (const Rgb &missed : j.errors->patches[i].missed)
                if (const double value = std::abs(point_value(kind, missed, j.errors->peak)); value > 0)
                    all.push_back(value);
        }
    return all;
}

} // namespace

double patch_value(ErrorKind kind, const Snapshot &snapshot, const ErrorMap &map, std::size_t patch) {
    if (map.patches[patch].n == 0)
        return -1;
    if (kind == ErrorKind::patch)
        return map.share(patch);
    const double estimate = snapshot.patches[patch].estimate;
    return estimate > 0 ? std::sqrt(map.patches[patch].square) / estimate : -1;
}

double point_value(ErrorKind kind, const Rgb &missed, double peak) {
    return kind == ErrorKind::signed_error ? missed.mean() : std::sqrt(missed.square().mean()) / std::max(peak, 1e-300);
}

Range error_range(ErrorKind kind, std::span<const Judged> judged) {
    std::vector<double> all = sizes(kind, judged);
    const double most = quantile(all, covered_share);
    switch (kind) {
    case ErrorKind::signed_error: {
        const double end = most > 0 ? rounded_up(most) : 1;
        return {-end, end};
    }
    case ErrorKind::estimate: {
        const double end = std::clamp(std::pow(10, std::ceil(std::log10(std::max(most, 1.5)) - 1e-9)), 10.0, 1000.0);
        return {1 / end, end};
    }
    case ErrorKind::relative:
    case ErrorKind::patch:
        break;
    }
    if (!(most > 0))
        return {1e-4, 1};
    const double high = std::ceil(std::log10(most) - 1e-9), low = std::floor(std::log10(quantile(all, 0.05)) + 1e-9);
    return {std::pow(10, std::clamp(low, high - most_decades, high - 1)), std::pow(10, high)};
}

double place(ErrorKind kind, const Range &range, double value) {
    if (!is_logarithmic(kind))
        return (value - range.low) / (range.high - range.low);
    return std::log(std::max(value, 1e-30) / range.low) / std::log(range.high / range.low);
}

glm::dvec3 error_colour(ErrorKind kind, const Range &range, double value) {
    const double t = std::clamp(place(kind, range, value), 0.0, 1.0);
    return is_diverging(kind) ? diverging(2 * t - 1) : cividis(t);
}

std::string error_heading(const Look &look) {
    if (look.difference) {
        const auto one = [](Strategy s) { return std::string("B (") + "abcd"[static_cast<std::size_t>(s)] + ")"; };
        return one(look.difference->second) + " \u2212 " + one(look.difference->first) + ", mean of R, G, B [W/m\u00b2]";
    }
    if (look.change) {
        const std::string other = words(*look.change);
        switch (look.error) {
        case ErrorKind::signed_error:
            return "B\u2095 \u2212 B with " + other + ", mean of R, G, B [W/m\u00b2]";
        case ErrorKind::relative:
            return "change with " + other + " / peak of B \u2212 E, rms of R, G, B";
        case ErrorKind::patch:
            return "L\u00b2 change of each patch with " + other + " / \u2016B \u2212 E\u2016";
        case ErrorKind::estimate:
            return "L\u00b2 change of each patch with " + other + " / estimated error";
        }
    }
    switch (look.error) {
    case ErrorKind::signed_error:
        return "error B\u2095 \u2212 B, mean of R, G, B [W/m\u00b2]";
    case ErrorKind::relative:
        return "|B\u2095 \u2212 B| / peak of B \u2212 E, rms of R, G, B";
    case ErrorKind::patch:
        return "L\u00b2 error of each patch / \u2016B \u2212 E\u2016";
    case ErrorKind::estimate:
        return "L\u00b2 error of each patch: true / estimated";
    }
    return "";
}

std::string_view error_sentence(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::signed_error:
        return "Solution minus truth at every point: brown where it is too bright, blue where it is too dark.";
    case ErrorKind::relative:
        return "Size of the error at every point, as a share of the largest reflected radiosity; not of the radiosity "
               "there, "
               "which is 0 in full shadow.";
    case ErrorKind::patch:
        return "One number a patch: its part of the whole error; the squares add up to the square of the error in the "
               "label.";
    case ErrorKind::estimate:
        return "Does the oracle tell the truth here? True error of each patch over what its test points saw: brown "
               "where it "
               "saw too little, blue where it saw too much.";
    }
    return "";
}

} // namespace penumbra
