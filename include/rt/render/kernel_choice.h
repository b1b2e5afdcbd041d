// Which of the instruction-set variants of the renderer to run.
#pragma once

#include "rt/trace/trace_kernel.h"

#include <string>
#include <vector>

namespace rt {

/// The kernels that this processor can run, slowest first: "baseline", "avx2", "avx512".
/// What the C library was told to mask (GLIBC_TUNABLES) counts as absent.
const std::vector<const TraceKernel*>& availableKernels();

/// By name, or the fastest for "". UsageError for one that is unknown or cannot run here.
const TraceKernel& chooseKernel(const std::string& name);

}  // namespace rt
