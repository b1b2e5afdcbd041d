// The numbers that math.random gives, the same everywhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rt {

/// The additive feedback generator x^31 + x^3 + 1 behind random() of the GNU C library, which
/// Lua 5.3 uses on Linux (P. Selinger, The GLIBC random number generator, 2007).
class PortableRandom {
  public:
    static constexpr std::uint32_t kMost = 0x7fffffff;

    PortableRandom() { seed(1); }
    void seed(std::uint32_t value);
    /// The next number, 0 <= n <= kMost.
    std::uint32_t next();

  private:
    std::array<std::uint32_t, 31> state_{};
    std::size_t front_ = 0;
};

}  // namespace rt
