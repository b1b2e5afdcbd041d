// What this process has cost the machine so far.
#pragma once

namespace rt {

/// Processor time of all threads of this process, in seconds.
double processCpuSeconds();

}  // namespace rt
