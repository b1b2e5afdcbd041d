#include "rt/shading/texture.h"

#include <algorithm>

namespace rt {
namespace {

double largestOf(const std::vector<float>& samples) {
    return samples.empty() ? 0.0 : *std::max_element(samples.begin(), samples.end());
}

/// Codes stand for 0 .. 1.
template <class Code>
double largestOf(const std::vector<Code>&) {
    return 1.0;
}

}  // namespace

double Texture::largestValue() const {
    return std::visit([](const auto& samples) { return largestOf(samples); }, image_.samples);
}

}  // namespace rt
