// The entry of libFuzzer; RT_FUZZ_TARGET is a function of targets.h.
#include "targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    rt::fuzz::RT_FUZZ_TARGET({data, size});
    return 0;
}
