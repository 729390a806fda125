// step [SCENE [THRESHOLD]]: steps a scene (a file, or a bundled one's name) to its fixed point, a line for each iteration.
#include "iteration/solver.h"
#include "scene/bundled.h"

#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <string>

int main(int argc, char **argv) try {
    const auto scene =
        std::make_shared<const penumbra::Scene>(penumbra::open_scene(argc > 1 ? argv[1] : "cornell-box"));
    penumbra::Options options;
    options.threshold = argc > 2 ? std::stod(argv[2]) : 0.05;

    std::cout.precision(std::numeric_limits<double>::max_digits10); // the figures can be compared to the last bit
    penumbra::Solver solver(scene, options);
    while (!solver.ended() && solver.counters().iteration < options.max_iterations) {
        solver.step();
        const penumbra::Counters &c = solver.counters();
        std::cout << "iteration " << c.iteration << ": " << c.patches << " patches, " << c.links << " links, change "
                  << c.change << '\n';
    }
    const bool converged = solver.converged();
    std::cout << (converged ? "converged" : "not converged") << " after " << solver.counters().iteration
              << " iterations\n";
    return converged ? 0 : 1;
} catch (const std::exception &e) {
    std::cerr << "step: " << e.what() << '\n';
    return 1;
}
