#include "commands/judge_picture.h"

#include "commands/progress.h"
#include "commands/terminal.h"
#include "files/find_reference.h"
#include "iteration/error_map.h"

#include <utility>
#include <vector>

namespace penumbra {

namespace {

/// What error pictures and profiles are held against; with it goes how wrong each pane is.
Truth find_truth(const std::shared_ptr<const Scene> &scene, const Cancel &cancel, const CommonOptions &common) {
    std::optional<Progress> progress;
    if (!has_one_bounce(*scene)) {
        if (!common.quiet)
            say_notes({"solving a reference"});
        progress.emplace(Options().to_tolerance(picture_tolerance), common.quiet, common.verbose);
    }
    return truth_of(scene,
                    find_reference(scene, picture_tolerance, &cancel, [&](const Counters &c) { progress->show(c); }));
}

/// What changes of effects are told from.
Truth find_changed(const std::shared_ptr<const Scene> &scene, const Options &options, const EffectChange &change,
                   const Cancel &cancel, const CommonOptions &common) {
    if (!common.quiet)
        say_notes({"solving with " + text_of(change)});
    Progress progress(options, common.quiet, common.verbose);
    return with_change(scene, options, change, &cancel, [&](const Counters &c) { progress.show(c); });
}

} // namespace

std::optional<ProfileData> judge(const std::shared_ptr<const Scene> &scene, PictureSpec &spec, const Cancel &cancel,
                                 const CommonOptions &common) {
    const bool changes = spec.look.shading == Shading::error && spec.look.change;
    std::optional<Truth> truth;
    if (!(changes || spec.look.difference) || spec.profile)
        truth = find_truth(scene, cancel, common);
    if (spec.look.difference) {
        for (PicturePane &pane : spec.panes)
            pane.errors = ErrorMapper(truth_in(pane.minus)).map(*pane.snapshot, &cancel);
    } else if (changes) {
        for (PicturePane &pane : spec.panes)
            pane.errors = ErrorMapper(find_changed(scene, pane.snapshot->options, *spec.look.change, cancel, common))
                              .map(*pane.snapshot, &cancel);
    } else if (spec.look.shading == Shading::error) {
        ErrorMapper mapper(*truth);
        for (PicturePane &pane : spec.panes)
            pane.errors = mapper.map(*pane.snapshot, &cancel);
    }
    if (!spec.profile)
        return std::nullopt;
    std::vector<std::shared_ptr<const Snapshot>> solutions;
    for (const PicturePane &pane : spec.panes)
        solutions.push_back(pane.snapshot);
    return profile_along(*spec.profile, solutions, *truth, &cancel);
}

} // namespace penumbra
