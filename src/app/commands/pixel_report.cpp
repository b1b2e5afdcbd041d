#include "pixel_report.h"

#include "rt/core/error.h"
#include "rt/core/text.h"
#include "rt/trace/traced_sample.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace rt {
namespace {

/// Six digits: to read, not to compute with.
std::string brief(double value) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
    return std::string(text.data(), end.ptr);
}

std::string place(const Vec3& v) {
    return "(" + brief(v.x) + ", " + brief(v.y) + ", " + brief(v.z) + ")";
}

std::string channels(const Color& c) {
    return brief(c.x) + " " + brief(c.y) + " " + brief(c.z);
}

/// One number where the channels are equal.
std::string share(const Color& c) {
    return c.x == c.y && c.y == c.z ? brief(c.x) : channels(c);
}

/// To the bit what a file of floats holds.
std::string exactly(const Color& c) {
    std::string text;
    for (const double channel : {c.x, c.y, c.z}) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                       static_cast<float>(channel));
        text += (text.empty() ? "" : " ") + std::string(digits.data(), end.ptr);
    }
    return text;
}

const char* nameOf(RayKind kind) {
    constexpr std::array<const char*, 3> kNames{"camera", "reflected", "refracted"};
    return kNames[static_cast<std::size_t>(kind)];
}

/// The text of one picture's pixel.
class Report {
  public:
    Report(const RenderScene& scene, const SceneDesc& desc,
           const std::function<void(const std::string&)>& print)
        : scene_(scene), desc_(desc), print_(print) {}

    void tell(const TracedSample& sample) {
        for (const TracedRay& ray : sample.rays) tellRay(ray);
    }

  private:
    void line(int indent, const std::string& text) {
        print_(std::string(2 * static_cast<std::size_t>(indent), ' ') + text + "\n");
    }

    std::string object(Index instance) const {
        const Instance& placed = scene_.instances[instance];
        std::string name = printable(desc_.nodes[placed.node].name, 80);
        std::replace(name.begin(), name.end(), '\n', ' ');
        return "'" + name + "' (" + nameOf(scene_.shapes[placed.shape]) + ")";
    }

    void tellRay(const TracedRay& ray) {
        const int indent = ray.depth + 1;
        const std::string medium = ray.index == 1.0 ? "" : ", in index " + brief(ray.index);
        line(indent, std::string(nameOf(ray.kind)) + " ray from " + place(ray.ray.origin) +
                         " along " + place(ray.ray.direction) + medium + ", weight " +
                         share(ray.weight));
        if (ray.instance == kNone) {
            line(indent + 1, "hits nothing: background " + channels(ray.color));
        } else {
            tellHit(indent + 1, ray);
        }
        line(indent + 1, "brings " + channels(ray.weight * ray.parts.own * ray.color));
    }

    void tellHit(int indent, const TracedRay& ray) {
        const Shape& shape = scene_.shapes[scene_.instances[ray.instance].shape];
        const bool isMesh = std::holds_alternative<std::shared_ptr<const MeshShape>>(shape);
        line(indent, "hits " + object(ray.instance) +
                         (isMesh ? ", triangle " + std::to_string(ray.piece) : "") +
                         (ray.fromInside ? ", from inside" : "") + ", at t = " + brief(ray.t));
        line(indent, "point " + place(ray.point) + ", normal " + place(ray.normal) +
                         (ray.normal == ray.geometricNormal
                              ? ""
                              : ", of the surface itself " + place(ray.geometricNormal)));
        line(indent, "material: diffuse " + channels(ray.material.diffuse) + ", specular " +
                         channels(ray.material.specular) + ", exponent " +
                         brief(ray.material.exponent));
        const std::string cut =
            ray.parts.cut > 0.0 ? " (" + brief(ray.parts.cut) + " of it cut off)" : "";
        line(indent, "shares: own " + brief(ray.parts.own) + cut + ", reflected " +
                         brief(ray.parts.reflected) + ", refracted " + brief(ray.parts.refracted));
        if (!(ray.parts.own > 0.0)) return;
        line(indent, "own colour " + channels(ray.color) + ", of it ambient light " +
                         channels(ray.material.diffuse * scene_.ambient) +
                         (ray.thrown == Color(0.0) ? "" : ", by photons " + channels(ray.thrown)));
        std::size_t next = 0;
        for (Index light = 0; light < scene_.lights.size(); ++light) {
            const bool isTold = next < ray.lights.size() && ray.lights[next].light == light;
            if (isTold) {
                tellLight(indent + 1, ray.lights[next++]);
            } else {
                line(indent + 1, lightName(light) + " brings nothing: it does not face the point");
            }
        }
    }

    static std::string lightName(Index light) { return "light " + std::to_string(light + 1); }

    void tellLight(int indent, const TracedLight& seen) {
        line(indent, lightName(seen.light) + " brings " + channels(seen.visible * seen.unhidden) +
                         ": visible " + share(seen.visible) +
                         (seen.first == kNone ? "" : ", behind " + object(seen.first)) +
                         ", unhidden " + channels(seen.unhidden) + ", shadow ray along " +
                         place(seen.direction) + " for " + brief(seen.reach));
    }

    const RenderScene& scene_;
    const SceneDesc& desc_;
    const std::function<void(const std::string&)>& print_;
};

std::string headOf(const TracedSample& sample, const std::string& name, bool moves) {
    const bool isFinite = std::isfinite(sample.value.x + sample.value.y + sample.value.z);
    return name + " at " + brief(sample.x) + "," + brief(sample.y) + ": " + channels(sample.value) +
           (sample.filterWeight == 1.0 ? ""
                                       : ", with filter weight " + brief(sample.filterWeight)) +
           (moves ? ", at " + brief(sample.time) + " of the shutter's time" : "") +
           (isFinite ? "" : ", counts as black") + "\n";
}

}  // namespace

void reportPixel(const PixelTrace& trace, const RenderScene& scene, const SceneDesc& desc,
                 const std::string& image, const std::function<void(const std::string&)>& print) {
    const PixelState& state = trace.state;
    print(printable(image, 300) + ", pixel " + std::to_string(trace.place.x) + "," +
          std::to_string(trace.place.y) + " of " + std::to_string(scene.width) + "x" +
          std::to_string(scene.height) + "\ncolour " + exactly(state.mean()) + "\n");
    const bool moves = !scene.moving.empty();
    Report report(scene, desc, print);
    const auto sampleOf = [&](std::uint64_t index) {
        return tracedSample(scene, trace.settings, trace.place, static_cast<int>(index));
    };
    // Towards an error target, a pixel that its corners tell has one value instead of samples.
    if (const TracedSample first = sampleOf(0); state.samples == 1 && first.value != state.sum) {
        print(
            "told by its corners, between which nothing but smooth shading lies; one sample, "
            "which the picture did without (--spp N samples every pixel):\n");
        print(headOf(first, "sample", moves));
        return report.tell(first);
    }
    Color sum(0.0);
    print("the mean of " + std::to_string(state.samples) +
          (state.samples == 1 ? " sample\n" : " samples\n"));
    for (std::uint64_t index = 0; index < state.samples; ++index) {
        const TracedSample sample = sampleOf(index);
        print(headOf(sample, "sample " + std::to_string(index + 1), moves));
        report.tell(sample);
        if (std::isfinite(sample.value.x + sample.value.y + sample.value.z)) sum += sample.value;
    }
    if (sum != state.sum) throw std::logic_error("the rays of the pixel are not the picture's");
}

}  // namespace rt
