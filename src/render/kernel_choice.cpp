#include "rt/render/kernel_choice.h"

#include "rt/core/error.h"

#if defined(__clang__)
#define _Bool bool  // the header is C, and clang knows the name there alone
#endif
#include <sys/platform/x86.h>

extern "C" {
const rt::TraceKernel* rtKernel_baseline();
const rt::TraceKernel* rtKernel_avx2();
const rt::TraceKernel* rtKernel_avx512();
}

namespace rt {
namespace {

bool hasAvx2() {
    return CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(FMA) && CPU_FEATURE_ACTIVE(BMI1) &&
           CPU_FEATURE_ACTIVE(BMI2) && CPU_FEATURE_ACTIVE(LZCNT);
}

bool hasAvx512() {
    return hasAvx2() && CPU_FEATURE_ACTIVE(AVX512F) && CPU_FEATURE_ACTIVE(AVX512VL) &&
           CPU_FEATURE_ACTIVE(AVX512DQ) && CPU_FEATURE_ACTIVE(AVX512BW);
}

std::vector<const TraceKernel*> detect() {
    std::vector<const TraceKernel*> kernels{rtKernel_baseline()};
    if (hasAvx2()) kernels.push_back(rtKernel_avx2());
    if (hasAvx512()) kernels.push_back(rtKernel_avx512());
    return kernels;
}

}  // namespace

const std::vector<const TraceKernel*>& availableKernels() {
    static const std::vector<const TraceKernel*> kernels = detect();
    return kernels;
}

const TraceKernel& chooseKernel(const std::string& name) {
    if (name.empty()) return *availableKernels().back();
    std::string known;
    for (const TraceKernel* kernel : availableKernels()) {
        if (name == kernel->name) return *kernel;
        known += (known.empty() ? "" : ", ") + std::string(kernel->name);
    }
    throw UsageError("--isa: this processor cannot run \"" + name + "\"; it can run: " + known);
}

}  // namespace rt
