// What the program has in RAM.
#pragma once

namespace penumbra {

/// Resident memory of the whole program [MiB]: resident pages of /proc/self/statm, as the system's own tools show it; 0
/// where the system does not tell. Takes some microseconds.
double resident_mib();

/// Gives memory that was freed back to the system, where the C library can (glibc): else it counts as resident on.
void give_back_memory();

} // namespace penumbra
