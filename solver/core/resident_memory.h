// What the program has in RAM.
#pragma once

namespace penumbra {

/// Resident memory of the whole program [MiB]: resident pages of /proc/self/statm, as the system's own tools show it; 0
/// where the system does not tell. Takes some microseconds.
double resident_mib();

} // namespace penumbra
