// Programs that tests start, and always end.
#pragma once

#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace penumbra::gui {

using Environment = std::map<std::string, std::string>;

class Process {
public:
    /// Starts it with these variables set besides the present ones, in `folder` unless empty; its output goes to the
    /// file `log` unless empty. Throws std::runtime_error when it cannot be started.
    Process(const std::vector<std::string> &arguments, const Environment &environment, const std::string &folder = "",
            const std::string &log = "");
    /// Ends it, politely first.
    ~Process();
    Process(const Process &) = delete;
    Process &operator=(const Process &) = delete;

    bool running();
    /// Waits for its end and returns its exit status, 128 + n when signal n ended it; -1 after `seconds`, times
    /// time_factor, without one.
    int wait(double seconds);
    pid_t id() const { return id_; }
    /// Processor time that it has used [s].
    double processor_seconds() const;

private:
    pid_t id_ = -1;
    bool ended_ = false;
    int status_ = 0;
};

/// Runs a program to its end and returns its output; throws with it when the status is not 0 or it takes over a minute.
std::string output_of(const std::vector<std::string> &arguments, const Environment &environment);

} // namespace penumbra::gui
