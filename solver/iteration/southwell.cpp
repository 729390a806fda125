#include "iteration/relaxation.h"

#include "core/parallel.h"
#include "iteration/coarse_correction.h"

#include <algorithm>
#include <utility>

namespace penumbra {

namespace {

class Shooting {
public:
    Shooting(const Setting &setting, State &state, const Cancel *cancel)
        : setting_(setting), state_(state), forest_(state.forest), cancel_(cancel),
          surfaces_(elements_by_surface(state.forest)), receivers_(surfaces_.size()), receiving_(surfaces_.size()),
          unshot_(surfaces_.size(), 0) {
        for (std::size_t e = 0; e < state.interactions.size(); ++e)
            for (const auto &interaction : state.interactions[e]) {
                add(receivers_[interaction->source.at()], ElementId(e));
                add(receiving_[interaction->source.at()], forest_.elements[e].surface);
            }
        for (auto &of_source : receiving_) {
            std::ranges::sort(of_source, {}, &SurfaceId::index);
            of_source.erase(std::ranges::unique(of_source).begin(), of_source.end());
        }
    }

    Shots run(const std::vector<char> &renewed) {
        Shots done;
        if (state_.shot.rows() > 0) {
            inherit_shot();
            done.links = gather_renewed(renewed);
        } else {
            state_.shot.setZero(forest_.n_coefficients, 3);
            state_.irradiance.setZero(forest_.n_coefficients, 3);
        }
        pushed_.setZero(forest_.n_coefficients, 3);
        radiosity_ = state_.radiosity;
        const bool once = corrects_coarsely(setting_);
        if (!once)
            parallel_for(surfaces_.size(), [&](std::size_t s) { push_pull_surface(s); });
        for (std::size_t s = 0; s < surfaces_.size(); ++s)
            unshot_[s] = unshot(s);
        std::int64_t shot_links = 0;
        while (shot_links < state_.counters.links) {
            const auto most = std::ranges::max_element(unshot_);
            if (most == unshot_.end() || *most <= 0)
                break;
            const auto s = static_cast<std::size_t>(most - unshot_.begin());
            shot_links += shoot(s);
            ++done.surfaces;
            unshot_[s] = 0;
            if (!once)
                receive(receiving_[s]);
        }
        done.links += shot_links;
        return done;
    }

private:
    template <class Id>
    static void add(std::vector<Id> &list, Id id) {
        if (list.empty() || list.back() != id)
            list.push_back(id);
    }

    /// New elements have shot what their parent did.
    void inherit_shot() {
        const Eigen::Index before = state_.shot.rows();
        state_.shot.conservativeResize(forest_.n_coefficients, 3);
        for (const Element &e : forest_.elements) {
            if (e.first >= before) // never a root
                rows(e, state_.shot) = e.filters->push * rows(forest_[e.parent], state_.shot);
        }
    }

    std::int64_t gather_renewed(const std::vector<char> &renewed) {
        std::int64_t n_links = 0;
        for (std::size_t e = 0; e < renewed.size(); ++e)
            if (renewed[e] && state_.batches[e])
                n_links += static_cast<std::int64_t>(state_.batches[e]->n_links());
        parallel_for(renewed.size(), [&](std::size_t e) {
            if (!renewed[e])
                return;
            if (cancel_)
                cancel_->check();
            auto irradiance = rows(forest_.elements[e], state_.irradiance);
            irradiance.setZero();
            if (state_.batches[e])
                state_.batches[e]->add_irradiance(state_.shot, irradiance);
        });
        return n_links;
    }

    void push_pull_surface(std::size_t s) {
        push_pull(forest_, *setting_.scene, surfaces_[s], state_.irradiance, pushed_, radiosity_);
    }

    /// Area times radiosity not shot yet, largest channel.
    double unshot(std::size_t s) const {
        double sum = 0;
        for (const ElementId id : surfaces_[s]) {
            const Element &e = forest_[id];
            if (e.leaf())
                sum += e.basis.area() *
                       (rows(e, radiosity_) - rows(e, state_.shot)).colwise().norm().maxCoeff();
        }
        return sum;
    }

    std::int64_t shoot(std::size_t s) {
        if (unshot_difference_.rows() == 0)
            unshot_difference_.setZero(forest_.n_coefficients, 3);
        for (const ElementId id : surfaces_[s]) {
            const Element &e = forest_[id];
            rows(e, unshot_difference_) = rows(e, radiosity_) - rows(e, state_.shot);
            rows(e, state_.shot) = rows(e, radiosity_);
        }
        const auto &receivers = receivers_[s];
        std::vector<std::int64_t> n_links(receivers.size());
        parallel_for(receivers.size(), [&](std::size_t i) {
            if (cancel_)
                cancel_->check();
            n_links[i] = static_cast<std::int64_t>(state_.batches[receivers[i].at()]->add_irradiance_from(
                SurfaceId(s), unshot_difference_, rows(forest_[receivers[i]], state_.irradiance)));
        });
        std::int64_t sum = 0;
        for (const std::int64_t n : n_links)
            sum += n;
        return sum;
    }

    void receive(const std::vector<SurfaceId> &receiving) {
        parallel_for(receiving.size(), [&](std::size_t i) {
            push_pull_surface(receiving[i].at());
            unshot_[receiving[i].at()] = unshot(receiving[i].at());
        });
    }

    const Setting &setting_;
    State &state_;
    const Forest &forest_;
    const Cancel *cancel_;
    std::vector<std::vector<ElementId>> surfaces_;
    std::vector<std::vector<ElementId>> receivers_; ///< by source surface: the elements with links from it
    std::vector<std::vector<SurfaceId>> receiving_; ///< by source surface: their surfaces
    std::vector<double> unshot_;                    ///< by surface
    Coefficients radiosity_, pushed_, unshot_difference_;
};

} // namespace

Shots shoot(const Setting &setting, State &state, const std::vector<char> &renewed, const Cancel *cancel) {
    return Shooting(setting, state, cancel).run(renewed);
}

} // namespace penumbra
