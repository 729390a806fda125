#include "files/find_reference.h"

#include "core/atomic_write.h"
#include "core/error.h"
#include "files/own_folders.h"
#include "files/reference_file.h"
#include "iteration/solver.h"

#include <fstream>
#include <iterator>
#include <utility>

namespace penumbra {

namespace {

std::optional<KeptSolution> kept(const Scene &scene, const std::filesystem::path &file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return std::nullopt;
    return read_reference(scene, {std::istreambuf_iterator<char>(in), {}});
}

void keep(const Scene &scene, const KeptSolution &solution, const std::filesystem::path &file) {
    try {
        std::error_code trouble;
        std::filesystem::create_directories(file.parent_path(), trouble);
        write_atomically(file, reference_bytes(scene, solution));
    } catch (const Unavailable &) {
        // It will be made again.
    }
}

} // namespace

std::shared_ptr<const Reference> find_reference(const std::shared_ptr<const Scene> &scene, double tolerance,
                                                const Cancel *cancel, const ReferenceProgress &told) {
    if (has_one_bounce(*scene))
        return std::make_shared<const Reference>(scene);
    const std::filesystem::path file = reference_path(cache_folder(), *scene);
    std::optional<KeptSolution> solution = kept(*scene, file);
    if (!solution || solution->tolerance > tolerance) {
        solution = {tolerance, solve_for_reference(scene, tolerance, cancel, told)};
        keep(*scene, *solution, file);
    }
    return std::make_shared<const Reference>(scene, std::move(solution->solution));
}

} // namespace penumbra
