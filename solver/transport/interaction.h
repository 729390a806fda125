// The transport from one input surface to one receiver element: its links.
#pragma once

#include "core/cancel.h"
#include "hierarchy/push_pull.h"
#include "visibility/visible_part.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace penumbra {

/// How an element and a source see each other; decides how links are integrated (DESIGN section 3).
enum class PairKind { clear, near, partly_hidden, hidden };

/// How an element that is kept though it fails is fitted.
struct Fit {
    /// A partly hidden pair takes twice the points a parameter, and nothing is left out: about the best that p can do.
    bool fine = false;
    /// Of all coefficients but the mean, so that p does not fall below black: 0 leaves a constant, which cannot (the limiter
    /// of X. Zhang and C.-W. Shu 2010, for links).
    double damping = 1;

    bool operator==(const Fit &) const = default;
};

/// A receiver node p and a source node q: K_ij = <N_i, integral over q of G V N_j dA>_p. Geometry only: no reflectance.
struct Link {
    ElementId source;
    /// K: rows are the functions of p of the interaction's order, columns those of q; one where its higher coefficients
    /// are 0 or left out.
    Eigen::MatrixXd kernel;
    /// Rows: the interaction's test points x_c. T_j(x_c) - sum_i N_i(x_c) K_ij: what the fit of p misses.
    Eigen::MatrixXd misfit;
    Eigen::VectorXd left_out; ///< largest |T_j| at a few points, of the columns j > 0 that were left out; else empty
};

/// What links may leave out of what is brought at present. Radiosity changes: whoever uses this judges again.
struct Leeway {
    double weak = -1; ///< share of the source's radiosity: who brings, or varies by, no more gets constants; below 0: nobody
    /// What orders below those of the receiver and the source may miss, reflected [W/m2]; 0: the full orders.
    double misfit = 0;
    bool mean_square = false; ///< as the root mean square over the test points and the sum over channels, not as the largest
    Rgb reflectance = Rgb::Zero();
    const Coefficients *radiosity = nullptr;
};

/// What may stand between two.
struct Candidates {
    std::vector<PairBlocker> blockers;
    int n_proposed = 0; ///< by the boxes of the two surfaces, before any was ruled out; but for those in the receiver's plane
};

/// All links of receiver element p from one input surface S; together they bring T_S. What of S is covered brings
/// nothing; what of p is covered is fitted but not tested. Immutable once made.
struct Interaction {
    ElementId receiver;
    SurfaceId source;
    PairKind kind = PairKind::clear;
    /// What it brings, or how that varies, is below its share of the error: a constant, from a few points, and not tested.
    bool weak = false;
    Fit fit{};
    int order = 1;                     ///< of the fit: up to that of p
    double form_factor = 0;            ///< unoccluded, largest over a few points of p: bounds what S can bring
    double variation = 0;              ///< what constants can miss of it (variation.h); the form factor where that is less
    std::vector<PairBlocker> blockers; ///< those that may stand between p and S
    std::vector<PairBlocker> clipped_by; ///< where nothing is to be left out: all that were proposed; else empty
    int n_proposed = 0;
    std::vector<Link> links;           ///< their sources tile S

    std::span<const PairBlocker> clipping() const { return clipped_by.empty() ? blockers : clipped_by; }
    /// Clips that a point of p takes where nothing is left out, when something may be; else 0.
    int n_clips_of_all() const { return clipped_by.empty() ? n_proposed : 0; }
    /// For the parts of p.
    Candidates candidates() const { return {clipped_by.empty() ? blockers : clipped_by, n_proposed}; }
    /// Largest |T_S - fit| over the test points for each channel [W/m2, before reflection].
    Rgb largest_misfit(const Forest &forest, const Coefficients &radiosity) const;
    /// The mean of (T_S - fit)^2 over them, all counting the same: borders and shadows, where they are dense, weigh more
    /// than their area.
    Rgb mean_square_misfit(const Forest &forest, const Coefficients &radiosity) const;
    /// About the most that columns which were left out would bring anywhere on p [W/m2, before reflection].
    Rgb left_out(const Forest &forest, const Coefficients &radiosity) const;
    /// T_S - fit at each test point [W/m2, before reflection]; no rows where nothing is tested.
    Eigen::Matrix<double, Eigen::Dynamic, 3> misfits(const Forest &forest, const Coefficients &radiosity) const;
};

/// What stays the same while links are made.
struct Transport {
    const Scene &scene;
    const Blockers &blockers;
    /// Of T_j at a point, relative to T_0 (source_moments.h). What a fit misses the receiver's rule cannot see all of, so
    /// that for a pair that sees each other whole
    ///   |K_ij - exact| <= accuracy K_00 max |N_j| + the largest |misfit| of column j:
    /// a link that passes the oracle is right to what passes, one that fails may be wrong by 10 % of K_00 and
    /// more. For an accuracy of 1e-4 or less there are points to match: whatever the fit misses, all coefficients are then
    /// within 20 accuracy K_00 of a pair apart by a fifth of its size, and within 100 of one with an edge in common at 60
    /// degrees or more (at less, the source's other edges hang low over p, and nothing is graded towards
    /// those). tests/agreement/links_test.cpp.
    double accuracy = 1e-4;
    double constant_accuracy = 1; ///< of what the source's constant function brings, where less than `accuracy`
    const Cancel *cancel = nullptr;
    bool clip_by_all = false;     ///< by every blocker that is proposed, not only by those that may stand between
    bool link_hidden = false;     ///< pairs of which one blocker hides all, too
};

/// The unoccluded form factor from p to S, the largest over corners and centre of p and the
/// points of it beneath, or a little in front of, the corners, sides and parts of S; 0 when neither faces the other.
double form_factor_bound(const Transport &transport, const Element &p, SurfaceId source);

/// Classifies the pair and integrates its links, to the orders that `leeway` leaves them (link_orders.h). `candidates`: a
/// superset of the blockers between them (those of a parent; `all_candidates` at a root). A hidden pair has no links.
/// `before`, where given, is what this call gave for the same two with other sources: links of sources in both are taken
/// over, not computed again, and the others get its order, if both are weak, and fitted, alike. Cancellable.
std::shared_ptr<const Interaction> connect(const Transport &transport, const Forest &forest, ElementId receiver,
                                           SurfaceId source, const Candidates &candidates,
                                           std::span<const ElementId> sources, const Leeway &leeway, Work &work,
                                           const Interaction *before = nullptr, Fit fit = {});

/// Everything near the shaft between two surfaces, as proposed by the bounding-volume hierarchy.
Candidates all_candidates(const Transport &transport, SurfaceId receiver, SurfaceId source);

/// Which functions of the sources are looked at: those that links have columns for, or all.
enum class SourceColumns { linked, all };

/// T_S at points of p (in its surface's plane), with the present radiosity: rows points, columns channels.
Eigen::Matrix<double, Eigen::Dynamic, 3> sample(const Transport &transport, const Forest &forest,
                                                const Interaction &interaction, std::span<const Vec2> points,
                                                const Coefficients &radiosity, Work &work,
                                                SourceColumns columns = SourceColumns::linked);

} // namespace penumbra
