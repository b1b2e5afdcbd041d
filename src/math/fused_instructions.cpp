#include "portable_kernel.h"
#include "rt/math/portable.h"

namespace rt::portable {

#ifdef __FMA__

bool selectFusedInstructions(bool) {
    return true;
}

#else

bool gUseFused = [] {
    __builtin_cpu_init();
    return __builtin_cpu_supports("fma") != 0;
}();

bool selectFusedInstructions(bool wanted) {
    const bool before = gUseFused;
    gUseFused = wanted && __builtin_cpu_supports("fma");
    return before;
}

#endif

}  // namespace rt::portable
