// The corpora through the same harnesses, compiled by any compiler: what fuzzing found once stays found.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);

/// Arguments are folders of inputs; an empty one is a failure.
int main(int n_arguments, char **arguments) {
    for (int i = 1; i < n_arguments; ++i) {
        int n = 0;
        for (const auto &entry : std::filesystem::directory_iterator(arguments[i])) {
            std::printf("%s\n", entry.path().c_str());
            std::fflush(stdout); // the last one named is the one that failed
            std::ifstream in(entry.path(), std::ios::binary);
            const std::string bytes{std::istreambuf_iterator<char>(in), {}};
            LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t *>(bytes.data()), bytes.size());
            ++n;
        }
        if (n == 0) {
            std::fprintf(stderr, "%s holds no input\n", arguments[i]);
            return 1;
        }
    }
    return n_arguments > 1 ? 0 : 2;
}
