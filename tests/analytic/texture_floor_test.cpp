// A checkered floor to the horizon, against exact area means: seen directly, in a mirror, and
// through a slab of glass.
#include "optics_shot.h"
#include "support/textured_scene.h"

#include <functional>

using namespace rt;
using namespace rt::test;

namespace {

constexpr int kWidth = 32;
constexpr int kHeight = 24;
constexpr double kFov = 60.0;
constexpr double kExtent = 2048.0;  // of the floor, to all sides
constexpr int kTexels = 64;         // of a square, whose side is 1
constexpr int kSquares = 8;         // of a repeat

const Vec3 kEye(0.3, 0.0, 0.2);

/// The floor y = -1, its squares between whole coordinates.
TemporaryFolder& files() {
    static TemporaryFolder folder;
    writeChecker(folder, "checker.png", kSquares, kTexels);
    const std::string e = text(kExtent);
    const std::string u = text(kExtent / kSquares);
    folder.write("floor.obj", "v -" + e + " -1 " + e + "\nv " + e + " -1 " + e + "\nv " + e +
                                  " -1 -" + e + "\nv -" + e + " -1 -" + e + "\nvt -" + u + " -" +
                                  u + "\nvt " + u + " -" + u + "\nvt " + u + " " + u + "\nvt -" +
                                  u + " " + u + "\nf 1/1 2/2 3/3 4/4\n");
    return folder;
}

/// +1 and -1 by turns between whole numbers, bilinear from one texel's centre to the next.
double wave(double t) {
    const double m = t - std::floor(t);
    const double height = std::min(1.0, 2.0 * kTexels * std::min(m, 1.0 - m));
    return static_cast<long long>(std::floor(t)) % 2 == 0 ? height : -height;
}

/// The integral of the wave from 0 to t.
double waveIntegral(double t) {
    const double ramp = 1.0 / kTexels;
    // Of one positive half, from 0 to m <= 1.
    const auto half = [&](double m) {
        if (m < 0.5 * ramp) return m * m / ramp;
        if (m <= 1.0 - 0.5 * ramp) return 0.25 * ramp + m - 0.5 * ramp;
        return 1.0 - 0.5 * ramp - (1.0 - m) * (1.0 - m) / ramp;
    };
    const double m = t - 2.0 * std::floor(0.5 * t);
    return m < 1.0 ? half(m) : half(1.0) - half(m - 1.0);
}

/// The mean of what the image shows along a line of the floor parallel to x: v grows towards -z,
/// and at the top left of the image it is black.
double meanAlongX(double x0, double x1, double z) {
    return 0.5 + 0.5 * wave(-z) * (waveIntegral(x1) - waveIntegral(x0)) / (x1 - x0);
}

/// A way of looking at the floor: what stands in the scene, and where on the floor the ray meets
/// it whose image point lies right and down of the middle, at distance 1.
struct View {
    const char* name;
    const char* body;
    std::function<Vec2(double right, double down)> place;
};

const View kViews[] = {
    {"direct", "",
     [](double right, double down) { return Vec2(kEye.x + right / down, kEye.z - 1.0 / down); }},
    {"mirror",
     "m = gr.nh_box('m', {-5000, -1, -2}, {10000, 9000, 1}) m:set_reflection(0)\n"
     "root:add_child(m, gr.material({1, 1, 1}, {0, 0, 0}, 1))",
     [](double right, double down) {
         return Vec2(kEye.x + right / down, -2.0 - (kEye.z - 1.0 / down));
     }},
    {"glass",
     "g = gr.nh_box('g', {-5000, -5000, -1}, {10000, 10000, 0.5}) g:set_refraction(1.5, 0)\n"
     "root:add_child(g, gr.material({1, 1, 1}, {0, 0, 0}, 1))",
     [](double right, double down) {
         // By Snell's law the slope is smaller within the slab, and the ray lands farther away.
         const double slope = std::sqrt(right * right + down * down);
         const double sine = slope / std::sqrt(1.0 + slope * slope) / 1.5;
         const double within = sine / std::sqrt(1.0 - sine * sine) / slope;
         return Vec2(kEye.x + right / down, kEye.z - (1.0 / down + 0.5 * (1.0 - within)));
     }},
};

std::string script(const View& view) {
    return std::string(
               "root = gr.node('root')\n"
               "root:add_child(gr.mesh('floor', 'floor.obj'), nil, "
               "gr.texture('checker.png', {0, 0, 0}, 1))\n") +
           view.body + "\ngr.background({0.5, 0.5, 0.5})\ngr.render(root, 'o.png', " +
           std::to_string(kWidth) + ", " + std::to_string(kHeight) + ", " + text(kEye) +
           ", {0, 0, -1}, {0, 1, 0}, " + text(kFov) + ", {1, 1, 1}, {})\n";
}

/// The exact means of the pixels below the horizon, row by row.
std::vector<double> areaMeans(const View& view) {
    // Exact along x, where z hardly changes; by the midpoint rule along y.
    constexpr int kAcross = 4;
    constexpr int kDown = 4096;
    const double perPixel = 2.0 * std::tan(kFov * kPi / 360.0) / kHeight;
    std::vector<double> means;
    for (int y = kHeight / 2; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            double sum = 0.0;
            for (int j = 0; j < kDown; ++j) {
                const double down = perPixel * (y + (j + 0.5) / kDown - kHeight / 2);
                const auto place = [&](double i) {
                    return view.place(perPixel * (x + i / kAcross - kWidth / 2), down);
                };
                for (int i = 0; i < kAcross; ++i) {
                    const Vec2 at = place(i + 0.5);
                    const bool there = std::fabs(at.x) < kExtent && std::fabs(at.y) < kExtent;
                    sum += there ? meanAlongX(place(i).x, place(i + 1.0).x, at.y) : 0.5;
                }
            }
            means.push_back(sum / (kAcross * kDown));
        }
    }
    return means;
}

/// The same pixels of a picture.
std::vector<double> shown(const View& view, const RenderOptions& options,
                          Picture* whole = nullptr) {
    PictureSettings settings;
    settings.options = options;
    settings.folder = files().path().string();
    const Picture picture = renderScript(script(view), settings);
    std::vector<double> values;
    for (int y = kHeight / 2; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) values.push_back(picture.at(x, y).x);
    }
    if (whole) *whole = picture;
    return values;
}

double rms(const std::vector<double>& a, const std::vector<double>& b, std::size_t from = 0) {
    double sum = 0.0;
    for (std::size_t i = from; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size() - from));
}

RenderOptions exactly(int spp, bool reference = false) {
    RenderOptions options;
    options.spp = spp;
    options.reference = reference;
    return options;
}

}  // namespace

TEST_CASE("a checkered floor to the horizon meets its exact area means, also in glass and mirror") {
    for (const View& view : kViews) {
        const std::string name = view.name;
        CAPTURE(name);
        const std::vector<double> truth = areaMeans(view);
        for (const int spp : {4, 16, 64, 256}) {
            const double averaged = rms(shown(view, exactly(spp)), truth);
            const double plain = rms(shown(view, exactly(spp, true)), truth);
            MESSAGE(name << ", " << spp << " samples: RMSE " << averaged << ", at full resolution "
                         << plain);
            CHECK(averaged < 0.035 / std::sqrt(spp));
            CHECK(plain > 3.0 * averaged);
        }
        CHECK(rms(shown(view, exactly(1024, true)), truth) < 0.006);
    }
}

TEST_CASE("the bias of averaged textures is below a third of the default error") {
    constexpr int kSeeds = 24;
    for (const View& view : kViews) {
        const std::string name = view.name;
        CAPTURE(name);
        const std::vector<double> truth = areaMeans(view);
        std::vector<double> mean(truth.size(), 0.0);
        double noise = 0.0;
        for (int seed = 0; seed < kSeeds; ++seed) {
            // As many as the shares that a pixel is cut into at the default error.
            RenderOptions options = exactly(128);
            options.seed = seed;
            const std::vector<double> values = shown(view, options);
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += values[i] / kSeeds;
            noise += rms(values, truth) * rms(values, truth) / kSeeds;
        }
        // What is left of the noise in the mean is taken out. Half of the picture is even sky.
        const double whole = rms(mean, truth) * rms(mean, truth);
        const double bias = std::sqrt(0.5 * std::max(0.0, whole - (noise - whole) / (kSeeds - 1)));
        MESSAGE(name << ": bias " << bias << ", noise " << std::sqrt(0.5 * (noise - whole)));
        CHECK(bias < 0.003 / 3.0);
    }
}

TEST_CASE("at the default error the floor is free of sparkle, and its estimate is honest") {
    for (const View& view : kViews) {
        const std::string name = view.name;
        CAPTURE(name);
        const std::vector<double> truth = areaMeans(view);
        Picture picture;
        const std::vector<double> values = shown(view, {}, &picture);
        std::vector<double> farValues(values.begin(), values.begin() + 3 * kWidth);
        std::vector<double> farTruth(truth.begin(), truth.begin() + 3 * kWidth);
        const double samples = static_cast<double>(picture.counts.rays.camera) / (kWidth * kHeight);
        MESSAGE(name << ": RMSE " << rms(values, truth) << ", in the three rows at the horizon "
                     << rms(farValues, farTruth) << ", " << samples << " samples a pixel");
        CHECK(picture.converged);
        // The estimate is of the whole picture, half of which is even sky.
        CHECK(rms(values, truth) < std::sqrt(2.0) * 0.003 * 1.1);
        CHECK(rms(farValues, farTruth) < 0.008);
        CHECK(samples < 150.0);
    }
}
