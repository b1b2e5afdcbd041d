#include "portable_random.h"

namespace rt {

void PortableRandom::seed(std::uint32_t value) {
    // Zero is a fixed point of the multiplicative generator that fills the state.
    std::int64_t word = static_cast<std::int32_t>(value == 0 ? 1 : value);
    for (std::uint32_t& slot : state_) {
        slot = static_cast<std::uint32_t>(word);
        // The minimal standard generator; a negative seed gives a negative remainder.
        word = 16807 * word % 2147483647;
        if (word < 0) word += 2147483647;
    }
    front_ = 3;
    for (std::size_t discarded = 0; discarded < 10 * state_.size(); ++discarded) next();
}

std::uint32_t PortableRandom::next() {
    const std::size_t rear = (front_ + state_.size() - 3) % state_.size();
    state_[front_] += state_[rear];
    const std::uint32_t result = state_[front_] >> 1;
    front_ = (front_ + 1) % state_.size();
    return result;
}

}  // namespace rt
