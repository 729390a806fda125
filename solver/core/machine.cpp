#include "core/machine.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

namespace penumbra {

namespace {

/// What stands after "key :" in the first line that begins so.
std::string value_of(std::string_view cpuinfo, std::string_view key) {
    std::istringstream lines{std::string(cpuinfo)};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t colon = line.find(':');
        if (colon == line.npos || !line.starts_with(key) ||
            line.find_first_not_of(" \t", key.size()) != colon)
            continue;
        std::istringstream words(line.substr(colon + 1));
        std::string value;
        for (std::string word; words >> word;)
            value += (value.empty() ? "" : " ") + word;
        return value;
    }
    return "";
}

} // namespace

std::string cpu_model_in(std::string_view cpuinfo) {
    const std::string name = value_of(cpuinfo, "model name");
    return name.empty() ? value_of(cpuinfo, "Model") : name;
}

std::string cpu_model() {
    std::ifstream file("/proc/cpuinfo");
    return cpu_model_in(std::string(std::istreambuf_iterator<char>(file), {}));
}

int n_cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

} // namespace penumbra
