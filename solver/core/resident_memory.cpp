#include "core/resident_memory.h"

#include <cstdio>
#include <memory>
#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace penumbra {

double resident_mib() {
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen("/proc/self/statm", "r"), std::fclose);
    unsigned long long whole = 0, resident = 0; // [pages]
    if (!file || std::fscanf(file.get(), "%llu %llu", &whole, &resident) != 2)
        return 0;
    return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1 << 20);
}

void give_back_memory() {
#ifdef __GLIBC__
    ::malloc_trim(0);
#endif
}

} // namespace penumbra
