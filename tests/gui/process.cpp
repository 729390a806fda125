#include "gui/process.h"

#include "sanitizers/time_factor.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace penumbra::gui {

namespace {

[[noreturn]] void become(const std::vector<std::string> &arguments, const Environment &environment,
                         const std::string &folder, int output) {
    for (const auto &[name, value] : environment)
        ::setenv(name.c_str(), value.c_str(), 1);
    if (!folder.empty() && ::chdir(folder.c_str()) != 0)
        ::_exit(127);
    if (output >= 0) {
        ::dup2(output, STDOUT_FILENO);
        ::dup2(output, STDERR_FILENO);
    }
    std::vector<char *> words;
    for (const std::string &a : arguments)
        words.push_back(const_cast<char *>(a.c_str()));
    words.push_back(nullptr);
    ::execvp(words[0], words.data());
    ::_exit(127);
}

void nap() { std::this_thread::sleep_for(std::chrono::milliseconds(10)); }

} // namespace

Process::Process(const std::vector<std::string> &arguments, const Environment &environment, const std::string &folder,
                 const std::string &log) {
    const int output = log.empty() ? -1 : ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    id_ = ::fork();
    if (id_ < 0)
        throw std::runtime_error("cannot start " + arguments[0] + ": " + std::strerror(errno));
    if (id_ == 0)
        become(arguments, environment, folder, output);
    if (output >= 0)
        ::close(output);
}

Process::~Process() {
    if (!running())
        return;
    ::kill(id_, SIGTERM);
    if (wait(2) < 0) {
        ::kill(id_, SIGKILL);
        wait(5);
    }
}

bool Process::running() {
    if (!ended_) {
        int status = 0;
        if (::waitpid(id_, &status, WNOHANG) == id_) {
            ended_ = true;
            status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
    }
    return !ended_;
}

int Process::wait(double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(time_factor * seconds);
    while (running()) {
        if (std::chrono::steady_clock::now() > end)
            return -1;
        nap();
    }
    return status_;
}

double Process::processor_seconds() const {
    std::ifstream file("/proc/" + std::to_string(id_) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    std::istringstream words(text.substr(text.rfind(')') + 1)); // the name may hold spaces
    std::string word;
    double user = 0, system = 0;
    for (int i = 0; i < 11; ++i)
        words >> word;
    words >> user >> system;
    return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::string output_of(const std::vector<std::string> &arguments, const Environment &environment) {
    std::array<char, 32> log{"/tmp/penumbra-gui-XXXXXX"};
    const int file = ::mkstemp(log.data());
    if (file < 0)
        throw std::runtime_error("cannot make a temporary file");
    ::close(file);
    int status = -1;
    {
        Process process(arguments, environment, "", log.data());
        status = process.wait(60);
    }
    std::ifstream in(log.data());
    std::string text((std::istreambuf_iterator<char>(in)), {});
    ::unlink(log.data());
    if (status != 0)
        throw std::runtime_error(arguments[0] + " " + (arguments.size() > 1 ? arguments[1] : "") + " ended with status " +
                                 std::to_string(status) + (status == 127 ? " (is it installed?)" : "") + ": " + text);
    return text;
}

} // namespace penumbra::gui
