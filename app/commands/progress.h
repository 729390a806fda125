// How far a solution is, on standard error.
#pragma once

#include "core/counters.h"
#include "core/options.h"

namespace penumbra {

/// A bar that is redrawn in place on a terminal; with `verbose` a line for each iteration anywhere; else nothing.
class Progress {
public:
    Progress(const Options &options, bool quiet, bool verbose);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    void show(const Counters &counters);

private:
    double fraction(double change) const;

    double threshold_;
    double first_change_ = 0;
    bool bar_, lines_;
};

} // namespace penumbra
