#include "preview_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace rt {
namespace {

std::vector<std::uint8_t> png(PixelImage image, ImageSettings settings) {
    settings.bits = 8;
    return encodeImage(imageFormatOf("x.png"), std::move(image), settings, {});
}

/// grey(index) of every pixel, in [0,1].
template <class Grey>
std::vector<std::uint8_t> greyPng(const RenderSnapshot& snapshot, const Grey& grey) {
    PixelImage image{snapshot.area.width(), snapshot.area.height(), {}};
    image.pixels.reserve(snapshot.means.size());
    for (std::size_t i = 0; i < snapshot.means.size(); ++i) image.pixels.emplace_back(grey(i));
    return png(std::move(image), {});
}

}  // namespace

std::vector<std::uint8_t> picturePng(const RenderSnapshot& snapshot,
                                     const ImageSettings& settings) {
    PixelImage image{snapshot.area.width(), snapshot.area.height(), {}};
    image.pixels.assign(snapshot.means.begin(), snapshot.means.end());
    return png(std::move(image), settings);
}

std::vector<std::uint8_t> samplesPng(const RenderSnapshot& snapshot) {
    const double most = std::log1p(std::max(1U, mostSamples(snapshot)));
    return greyPng(snapshot, [&](std::size_t i) { return std::log1p(snapshot.samples[i]) / most; });
}

std::vector<std::uint8_t> errorPng(const RenderSnapshot& snapshot) {
    const auto largest = static_cast<double>(largestError(snapshot));
    return greyPng(snapshot, [&](std::size_t i) {
        if (!(largest > 0.0)) return 0.0;
        return std::sqrt(static_cast<double>(snapshot.errors[i]) / largest);
    });
}

std::uint32_t mostSamples(const RenderSnapshot& snapshot) {
    const auto most = std::max_element(snapshot.samples.begin(), snapshot.samples.end());
    return most == snapshot.samples.end() ? 0 : *most;
}

float largestError(const RenderSnapshot& snapshot) {
    const auto largest = std::max_element(snapshot.errors.begin(), snapshot.errors.end());
    return largest == snapshot.errors.end() ? 0.0F : *largest;
}

}  // namespace rt
