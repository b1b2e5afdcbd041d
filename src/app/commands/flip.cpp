#include "flip.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rt {
namespace {

// Section 4.1: sums of Gaussians a sqrt(pi/b) exp(-pi^2 x^2 / b), x in degrees, fitted to the
// contrast sensitivity of the achromatic, the red-green and the blue-yellow channel.
struct Gaussian {
    double a;
    double b;
};
constexpr Gaussian kAchromatic{1.0, 0.0047};
constexpr Gaussian kRedGreen{1.0, 0.0053};
constexpr Gaussian kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double kWidestB = 0.04;

// Section 4.1.3: compression of large colour differences, and where it sets in.
constexpr double kColorExponent = 0.7;
constexpr double kKneeShare = 0.4;
constexpr double kKneeValue = 0.95;

// Section 4.2: width of an edge in degrees, and the exponent of its differences.
constexpr double kFeatureWidth = 0.082;
constexpr double kFeatureExponent = 0.5;

// Filters end at this many standard deviations.
constexpr double kFilterReach = 3.0;

/// Linear RGB to CIE XYZ from the chromaticities of IEC 61966-2-1, so that white is (1,1,1).
Mat3 xyzFromRgbMatrix() {
    const auto xyz = [](double x, double y) { return Vec3(x / y, 1.0, (1.0 - x - y) / y); };
    const Mat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
    const Vec3 scales = glm::inverse(primaries) * xyz(0.3127, 0.3290);
    return {primaries[0] * scales.x, primaries[1] * scales.y, primaries[2] * scales.z};
}

/// Colour spaces of the paper, with XYZ relative to white throughout.
class Spaces {
  public:
    Spaces()
        : toXyz_(xyzFromRgbMatrix()), white_(toXyz_ * Vec3(1.0)), toRgb_(glm::inverse(toXyz_)) {}

    Vec3 relativeXyz(const Vec3& rgb) const { return toXyz_ * rgb / white_; }
    Vec3 rgb(const Vec3& relative) const { return toRgb_ * (relative * white_); }

    /// Linear opponent colours: 116 y - 16, 500 (x - y), 200 (y - z).
    static Vec3 opponent(const Vec3& v) {
        return {116.0 * v.y - 16.0, 500.0 * (v.x - v.y), 200.0 * (v.y - v.z)};
    }
    static Vec3 fromOpponent(const Vec3& v) {
        const double y = (v.x + 16.0) / 116.0;
        return {y + v.y / 500.0, y, y - v.z / 200.0};
    }

    /// CIE L*a*b* with a and b scaled by lightness, 0.01 L (Hunt's effect).
    Vec3 huntLab(const Vec3& rgb) const {
        const Vec3 v = relativeXyz(rgb);
        const Vec3 lab = opponent({curve(v.x), curve(v.y), curve(v.z)});
        return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
    }

  private:
    static double curve(double t) {
        constexpr double kDelta = 6.0 / 29.0;
        if (t > kDelta * kDelta * kDelta) return std::cbrt(t);
        return t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    }

    Mat3 toXyz_;
    Vec3 white_;
    Mat3 toRgb_;
};

double linearFromSrgb(double value) {
    const double v = std::clamp(value, 0.0, 1.0);
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// One number for each pixel.
struct Plane {
    int width;
    int height;
    std::vector<double> values;

    double& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    double at(int x, int y) const { return const_cast<Plane&>(*this).at(x, y); }
};

using Kernel = std::vector<double>;  // of odd length, its middle at offset 0

template <class Function>
Kernel sampled(int radius, Function function) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.push_back(function(static_cast<double>(i)));
    return kernel;
}

double sumOf(const Kernel& kernel) {
    double sum = 0.0;
    for (const double weight : kernel) sum += weight;
    return sum;
}

/// Scaled so that the positive weights sum to 1, and the negative ones, if any, to -1.
Kernel normalized(Kernel kernel) {
    double positive = 0.0;
    double negative = 0.0;
    for (const double weight : kernel) (weight > 0.0 ? positive : negative) += weight;
    for (double& weight : kernel) weight /= weight > 0.0 ? positive : -negative;
    return kernel;
}

/// Rows filtered by `across`, columns by `down`; beyond the border the image goes on as it ends.
Plane filtered(const Plane& plane, const Kernel& across, const Kernel& down) {
    const int radius = static_cast<int>(across.size() / 2);
    Plane rows = plane;
    Plane result = plane;
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0.0;
            for (int i = -radius; i <= radius; ++i) {
                sum += across[static_cast<std::size_t>(i + radius)] *
                       plane.at(std::clamp(x + i, 0, plane.width - 1), y);
            }
            rows.at(x, y) = sum;
        }
    }
    for (int y = 0; y < plane.height; ++y) {
        for (int x = 0; x < plane.width; ++x) {
            double sum = 0.0;
            for (int i = -radius; i <= radius; ++i) {
                sum += down[static_cast<std::size_t>(i + radius)] *
                       rows.at(x, std::clamp(y + i, 0, plane.height - 1));
            }
            result.at(x, y) = sum;
        }
    }
    return result;
}

/// The image in linear opponent colours, one plane for each channel.
struct OpponentImage {
    Plane channels[3];
};

OpponentImage opponentImage(const PixelImage& image, const Spaces& spaces) {
    const Plane empty{image.width, image.height, std::vector<double>(image.pixels.size())};
    OpponentImage result{{empty, empty, empty}};
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Color& p = image.pixels[i];
        const Vec3 rgb(linearFromSrgb(p.r), linearFromSrgb(p.g), linearFromSrgb(p.b));
        const Vec3 opponent = Spaces::opponent(spaces.relativeXyz(rgb));
        for (int c = 0; c < 3; ++c) result.channels[c].values[i] = opponent[c];
    }
    return result;
}

/// A Gaussian's kernel before normalization, along one axis.
Kernel sensitivity(const Gaussian& g, int radius, double pixelsPerDegree) {
    const double pi = std::numbers::pi;
    return sampled(radius, [&](double i) {
        const double degrees = i / pixelsPerDegree;
        return std::exp(-pi * pi * degrees * degrees / g.b);
    });
}

/// Both Gaussians of the blue-yellow channel, in the shares that they have of the whole filter.
Plane filterBlueYellow(const Plane& plane, int radius, double pixelsPerDegree) {
    double shares[2];
    Plane parts[2] = {plane, plane};
    for (int i = 0; i < 2; ++i) {
        const Kernel kernel = sensitivity(kBlueYellow[i], radius, pixelsPerDegree);
        const double height = kBlueYellow[i].a * std::sqrt(std::numbers::pi / kBlueYellow[i].b);
        shares[i] = height * sumOf(kernel) * sumOf(kernel);
        parts[i] = filtered(plane, normalized(kernel), normalized(kernel));
    }
    const double total = shares[0] + shares[1];
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        parts[0].values[i] =
            (shares[0] * parts[0].values[i] + shares[1] * parts[1].values[i]) / total;
    }
    return parts[0];
}

/// What the eye resolves of the image, in the space in which colours are compared.
std::vector<Vec3> perceived(const OpponentImage& image, const Spaces& spaces,
                            double pixelsPerDegree) {
    const double deviation = std::sqrt(kWidestB / (2.0 * std::numbers::pi * std::numbers::pi));
    const int radius = static_cast<int>(std::ceil(kFilterReach * deviation * pixelsPerDegree));
    const Kernel achromatic = normalized(sensitivity(kAchromatic, radius, pixelsPerDegree));
    const Kernel redGreen = normalized(sensitivity(kRedGreen, radius, pixelsPerDegree));
    const Plane y = filtered(image.channels[0], achromatic, achromatic);
    const Plane x = filtered(image.channels[1], redGreen, redGreen);
    const Plane z = filterBlueYellow(image.channels[2], radius, pixelsPerDegree);
    std::vector<Vec3> colors;
    colors.reserve(y.values.size());
    for (std::size_t i = 0; i < y.values.size(); ++i) {
        const Vec3 rgb = spaces.rgb(Spaces::fromOpponent({y.values[i], x.values[i], z.values[i]}));
        colors.push_back(spaces.huntLab(glm::clamp(rgb, 0.0, 1.0)));
    }
    return colors;
}

/// Distance for large differences: lightness apart from the chromatic plane (HyAB; S. Abasi,
/// M. Amani Tehran, M. D. Fairchild, Distance metrics for very large color differences, 2020).
double hyab(const Vec3& a, const Vec3& b) {
    return std::fabs(a.x - b.x) + std::sqrt((a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/// Colour differences in [0,1]: `most` is that between green and blue, the largest there is.
double compressed(double distance, double most) {
    const double power = std::pow(distance, kColorExponent);
    const double knee = kKneeShare * most;
    const double value = power < knee
                             ? power / knee * kKneeValue
                             : kKneeValue + (power - knee) / (most - knee) * (1.0 - kKneeValue);
    return std::clamp(value, 0.0, 1.0);
}

/// Strength of edges and of points at each pixel.
struct Features {
    std::vector<double> edges;
    std::vector<double> points;
};

std::vector<double> strength(const Plane& luminance, const Kernel& derivative,
                             const Kernel& smooth) {
    const Plane horizontal = filtered(luminance, derivative, smooth);
    const Plane vertical = filtered(luminance, smooth, derivative);
    std::vector<double> lengths;
    lengths.reserve(luminance.values.size());
    for (std::size_t i = 0; i < luminance.values.size(); ++i) {
        lengths.push_back(std::hypot(horizontal.values[i], vertical.values[i]));
    }
    return lengths;
}

Features features(const Plane& achromatic, double pixelsPerDegree) {
    Plane luminance = achromatic;
    for (double& value : luminance.values) value = (value + 16.0) / 116.0;
    const double sigma = 0.5 * kFeatureWidth * pixelsPerDegree;
    const int radius = static_cast<int>(std::ceil(kFilterReach * sigma));
    const auto gauss = [&](double i) { return std::exp(-i * i / (2.0 * sigma * sigma)); };
    const Kernel smooth = normalized(sampled(radius, gauss));
    const Kernel first = normalized(sampled(radius, [&](double i) { return -i * gauss(i); }));
    const Kernel second = normalized(
        sampled(radius, [&](double i) { return (i * i / (sigma * sigma) - 1.0) * gauss(i); }));
    return {strength(luminance, first, smooth), strength(luminance, second, smooth)};
}

}  // namespace

std::vector<double> flipMap(const PixelImage& first, const PixelImage& second,
                            double pixelsPerDegree) {
    const Spaces spaces;
    const OpponentImage a = opponentImage(first, spaces);
    const OpponentImage b = opponentImage(second, spaces);
    const std::vector<Vec3> colorsA = perceived(a, spaces, pixelsPerDegree);
    const std::vector<Vec3> colorsB = perceived(b, spaces, pixelsPerDegree);
    const Features featuresA = features(a.channels[0], pixelsPerDegree);
    const Features featuresB = features(b.channels[0], pixelsPerDegree);
    const double most = std::pow(
        hyab(spaces.huntLab({0.0, 1.0, 0.0}), spaces.huntLab({0.0, 0.0, 1.0})), kColorExponent);
    std::vector<double> map;
    map.reserve(colorsA.size());
    for (std::size_t i = 0; i < colorsA.size(); ++i) {
        const double color = compressed(hyab(colorsA[i], colorsB[i]), most);
        const double feature = std::max(std::fabs(featuresA.edges[i] - featuresB.edges[i]),
                                        std::fabs(featuresA.points[i] - featuresB.points[i]));
        const double raised =
            std::pow(std::min(feature / std::numbers::sqrt2, 1.0), kFeatureExponent);
        map.push_back(std::pow(color, 1.0 - raised));
    }
    return map;
}

double meanFlip(const PixelImage& first, const PixelImage& second, double pixelsPerDegree) {
    double sum = 0.0;
    for (const double value : flipMap(first, second, pixelsPerDegree)) sum += value;
    return sum / static_cast<double>(first.pixels.size());
}

}  // namespace rt
