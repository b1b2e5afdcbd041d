// What can be bought: steps that each take something off the error of the image, by their price.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace rt {

/// Sorts offers into classes of an eighth of an octave, so that finding the price at which the
/// error is met takes one look at each offer.
class PriceList {
  public:
    explicit PriceList(double error) : error_(error) {}

    /// A step that takes `gain` off the error; `price` is the error that it works on for each unit
    /// of its cost. What costs more than it brings has a low price.
    void offer(double price, double gain) { gain_[classOf(price)] += gain; }

    /// The highest price for which all steps of at least that price bring the error to `target`;
    /// the lowest of all where they cannot.
    double priceFor(double target) const {
        double left = error_;
        for (std::size_t c = kClasses; c-- > 1;) {
            left -= gain_[c];
            if (left <= target) return lowest(c);
        }
        return lowest(1);
    }

    static bool isAtLeast(double price, double limit) { return classOf(price) >= classOf(limit); }

  private:
    /// 2^-96 to 2^16; what is below is too little to be worth anything.
    static constexpr std::size_t kClasses = 8 * 112;
    static constexpr std::uint64_t kFirst = std::uint64_t{1023 - 96} << 3;

    static std::size_t classOf(double price) {
        if (!(price > 0.0)) return 0;
        const std::uint64_t code = std::bit_cast<std::uint64_t>(price) >> 49;
        if (code < kFirst) return 0;
        return code - kFirst >= kClasses ? kClasses - 1 : static_cast<std::size_t>(code - kFirst);
    }
    static double lowest(std::size_t c) {
        return std::bit_cast<double>((std::uint64_t{c} + kFirst) << 49);
    }

    double error_;
    std::array<double, kClasses> gain_{};
};

}  // namespace rt
