// Broken invariants stop the program and print what was compared.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace penumbra::detail {

template <class A, class B>
[[noreturn]] void check_failed(const char *file, int line, const char *text, const A &a, const B &b) {
    std::ostringstream s;
    s << file << ':' << line << ": check failed: " << text << " (" << a << " against " << b << ")\n";
    std::fputs(s.str().c_str(), stderr);
    std::abort();
}

} // namespace penumbra::detail

/// Aborts with both values unless `a op b` holds. For bugs only, never for input.
#define PENUMBRA_CHECK(a, op, b)                                                                                       \
    do {                                                                                                               \
        const auto &check_a = (a);                                                                                     \
        const auto &check_b = (b);                                                                                     \
        if (!(check_a op check_b))                                                                                     \
            ::penumbra::detail::check_failed(__FILE__, __LINE__, #a " " #op " " #b, check_a, check_b);                 \
    } while (false)
