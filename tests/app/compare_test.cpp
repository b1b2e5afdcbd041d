#include "app/commands/flip.h"
#include "app/commands/image_difference.h"
#include "rt/app/commands.h"
#include "rt/core/error.h"
#include "rt/image/oiio_library.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace rt;

namespace {

PixelImage filledWith(int width, int height, const Color& color) {
    return {width, height,
            std::vector<Color>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                               color)};
}

PixelImage randomImage(int width, int height, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> value(0.0, 1.0);
    PixelImage image = filledWith(width, height, Color(0.0));
    for (Color& pixel : image.pixels) pixel = {value(random), value(random), value(random)};
    return image;
}

/// A picture of gradients and stripes, and one in which parts of it are changed.
PixelImage pattern() {
    PixelImage image = filledWith(48, 32, Color(0.0));
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 48; ++x) {
            image.at(x, y) = {x / 47.0, y / 31.0, ((x * 7 + y * 13) % 32) / 31.0};
        }
    }
    return image;
}

PixelImage changedPattern() {
    PixelImage image = pattern();
    for (int y = 8; y < 20; ++y) {
        for (int x = 10; x < 30; ++x) std::swap(image.at(x, y).r, image.at(x, y).b);
    }
    for (int y = 0; y < 32; ++y) {
        for (int x = 40; x < 48; ++x) image.at(x, y) *= 0.5;
    }
    return image;
}

PixelImage inverted(PixelImage image) {
    for (Color& pixel : image.pixels) pixel = Color(1.0) - pixel;
    return image;
}

/// A folder with files for the command, and what it prints.
class Bench {
  public:
    Bench() {
        std::string pattern = (std::filesystem::temp_directory_path() / "compare-XXXXXX").string();
        REQUIRE(::mkdtemp(pattern.data()) != nullptr);
        folder_ = pattern;
    }
    ~Bench() { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const PixelImage& image) const {
        const std::string path = folder_ + "/" + name;
        writeImage(path, image, {}, {});
        return path;
    }
    std::string writeBytes(const std::string& name, const std::string& bytes) const {
        const std::string path = folder_ + "/" + name;
        std::ofstream(path, std::ios::binary) << bytes;
        return path;
    }
    std::string path(const std::string& name) const { return folder_ + "/" + name; }

    struct Result {
        int code;
        std::string out;
        std::string err;
    };
    Result compare(const CompareOptions& options) const {
        const std::string out = folder_ + "/out";
        const std::string err = folder_ + "/err";
        std::fflush(stdout);
        std::fflush(stderr);
        const int oldOut = ::dup(1);
        const int oldErr = ::dup(2);
        redirect(out, 1);
        redirect(err, 2);
        const int code = compareCommand(options);
        std::fflush(stdout);
        std::fflush(stderr);
        ::dup2(oldOut, 1);
        ::dup2(oldErr, 2);
        ::close(oldOut);
        ::close(oldErr);
        return {code, contents(out), contents(err)};
    }

  private:
    static void redirect(const std::string& path, int descriptor) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(file, descriptor);
        ::close(file);
    }
    static std::string contents(const std::string& path) {
        std::ifstream file(path);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    std::string folder_;
};

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The bytes of a PFM of 1 x 1 pixel.
std::string tinyPfm(float r, float g, float b) {
    std::string bytes = "PF\n1 1\n-1.0\n";
    for (const float value : {r, g, b}) {
        const auto word = std::bit_cast<std::uint32_t>(value);
        for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift);
    }
    return bytes;
}

}  // namespace

TEST_CASE("FLIP of known images is what the paper's authors' own program gives") {
    // flip-evaluator 1.7 (single precision), LDR, inputs as sRGB.
    constexpr double kSinglePrecision = 1e-4;
    const PixelImage a = pattern();
    const PixelImage black = filledWith(48, 32, Color(0.0));
    const PixelImage white = filledWith(48, 32, Color(1.0));
    struct Case {
        const PixelImage& first;
        PixelImage second;
        double expected;
        double at30;
    };
    const std::vector<Case> cases = {
        {a, changedPattern(), 0.26812878251075745, 0.25356778502464294},
        {a, inverted(a), 0.9254634380340576, 0.9210795760154724},
        {black, white, 0.9673991203308105, 0.9673986434936523},
    };
    for (const Case& c : cases) {
        CHECK(std::fabs(meanFlip(c.first, c.second) - c.expected) < kSinglePrecision);
        CHECK(std::fabs(meanFlip(c.first, c.second, 30.0) - c.at30) < kSinglePrecision);
    }
}

TEST_CASE("FLIP of evenly coloured images follows from the equations alone") {
    // L* of black and white is 0 and 100, so HyAB is 100; green and blue are the largest distance:
    // 203.3 with Hunt's effect; both to the power 0.7, then the knee at 0.4 of the largest.
    CHECK(std::fabs(meanFlip(filledWith(5, 4, Color(0.0)), filledWith(5, 4, Color(1.0))) -
                    0.96738) < 2e-5);
    CHECK(meanFlip(filledWith(5, 4, {0, 1, 0}), filledWith(5, 4, {0, 0, 1})) ==
          doctest::Approx(1.0).epsilon(1e-12));
    const double nearlyEqual =
        meanFlip(filledWith(5, 4, Color(0.5)), filledWith(5, 4, Color(0.5 + 1.0 / 255)));
    CHECK(nearlyEqual > 0.0);
    CHECK(nearlyEqual < 0.05);
}

TEST_CASE("FLIP is 0 for equal images, symmetric, and within [0,1]") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        const int width = 1 + static_cast<int>(seed * 5 % 23);
        const int height = 1 + static_cast<int>(seed * 7 % 19);
        const PixelImage a = randomImage(width, height, seed);
        const PixelImage b = randomImage(width, height, seed + 100);
        CHECK(meanFlip(a, a) == 0.0);
        const std::vector<double> ab = flipMap(a, b);
        CHECK(ab == flipMap(b, a));
        for (const double value : ab) {
            CHECK(value >= 0.0);
            CHECK(value <= 1.0);
        }
    }
}

TEST_CASE("FLIP sees the same from any side, and more in a larger change") {
    const PixelImage a = pattern();
    const PixelImage b = changedPattern();
    const auto mirrored = [](const PixelImage& image) {
        PixelImage result = image;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                result.at(x, y) = image.at(image.width - 1 - x, y);
            }
        }
        return result;
    };
    CHECK(meanFlip(mirrored(a), mirrored(b)) == doctest::Approx(meanFlip(a, b)).epsilon(1e-9));
    double before = 0.0;
    for (const double step : {0.01, 0.05, 0.2, 0.5}) {
        const double flip =
            meanFlip(filledWith(9, 9, Color(0.4)), filledWith(9, 9, Color(0.4 + step)));
        CHECK(flip > before);
        before = flip;
    }
}

TEST_CASE("The errors of known images are what the definitions give") {
    PixelImage a = filledWith(4, 2, Color(0.5));
    PixelImage b = a;
    b.at(3, 1) = {0.5, 0.9, 0.5};
    b.at(1, 0) = {0.5 - 4.0 / 255.0, 0.5, 0.5};
    const ImageDifference d = differenceOf(a, b);
    CHECK(d.rmse == doctest::Approx(std::sqrt((0.16 + 16.0 / 65025.0) / 24.0)));
    CHECK(d.meanAbsolute == doctest::Approx((0.4 + 4.0 / 255.0) / 24.0));
    CHECK(d.maxAbsolute == doctest::Approx(0.4));
    CHECK(d.maxX == 3);
    CHECK(d.maxY == 1);
    CHECK(d.shareOver == 1.0 / 8.0);
    const ImageDifference none = differenceOf(a, a);
    CHECK(none.rmse == 0.0);
    CHECK(none.maxAbsolute == 0.0);
    CHECK(none.shareOver == 0.0);
}

TEST_CASE("Bytes that are 4 apart are not over 4/255, and bytes 5 apart are") {
    for (int byte = 0; byte + 5 <= 255; ++byte) {
        CAPTURE(byte);
        const PixelImage a = filledWith(1, 1, Color(byte / 255.0));
        CHECK(differenceOf(a, filledWith(1, 1, Color((byte + 4) / 255.0))).shareOver == 0.0);
        CHECK(differenceOf(a, filledWith(1, 1, Color((byte + 5) / 255.0))).shareOver == 1.0);
    }
}

TEST_CASE("Equal files compare as equal, with code 0 at tolerance 0") {
    const Bench bench;
    const std::string a = bench.write("a.png", pattern());
    const std::string b = bench.write("b.png", pattern());
    const Bench::Result result = bench.compare({a, b, 0.0});
    CHECK(result.code == 0);
    CHECK(result.out ==
          "RMSE        0\nmean        0\nmax         0 at 0,0\nover 4/255  0 %\nFLIP        0\n");
    CHECK(result.err.empty());
}

TEST_CASE("The tolerance decides between 0 and 10, and without one a comparison only measures") {
    const Bench bench;
    const std::string a = bench.write("a.png", filledWith(6, 6, Color(0.2)));
    const std::string b = bench.write("b.png", filledWith(6, 6, Color(0.4)));
    CHECK(bench.compare({a, b, 0.2001}).code == 0);
    const Bench::Result over = bench.compare({a, b, 0.1999});
    CHECK(over.code == 10);
    CHECK(holds(over.err, "above the tolerance 0.1999"));
    CHECK(holds(over.out, "RMSE        0.2"));
    CHECK(holds(over.out, "over 4/255  100 %"));
    CHECK(bench.compare({a, b, std::nullopt}).code == 0);
    CHECK(bench.compare({a, b, std::numeric_limits<double>::quiet_NaN()}).code == 10);
}

TEST_CASE("Sizes that differ, missing files and damaged ones are failed comparisons") {
    const Bench bench;
    const std::string a = bench.write("a.png", filledWith(6, 5, Color(0.2)));
    const std::string b = bench.write("b.png", filledWith(5, 6, Color(0.2)));
    const Bench::Result sizes = bench.compare({a, b, 10.0});
    CHECK(sizes.code == 10);
    CHECK(holds(sizes.err, "a.png is 6x5"));
    CHECK(holds(sizes.err, "b.png is 5x6"));
    CHECK(sizes.out.empty());
    const std::string pfm = tinyPfm(0, 0, 0);
    const std::vector<std::string> bad = {
        bench.path("missing.png"),
        bench.path(""),
        bench.writeBytes("empty.png", ""),
        bench.writeBytes("half.png", "\x89PNG\r\n\x1a\n\0\0"),
        bench.writeBytes("text.png", "hello, this is no image at all"),
        bench.writeBytes("short.pfm", pfm.substr(0, pfm.size() - 1)),
        bench.writeBytes("long.pfm", pfm + "x"),
        bench.writeBytes("header.pfm", "PF\n"),
        bench.writeBytes("huge.pfm", "PF\n2000000000 2000000000\n-1.0\n"),
        bench.writeBytes("negative.pfm", "PF\n-1 -1\n-1.0\n"),
        bench.writeBytes("big_endian.pfm", "PF\n1 1\n1.0\n123456789012"),
    };
    for (const std::string& path : bad) {
        CAPTURE(path);
        for (const bool first : {true, false}) {
            const Bench::Result result =
                bench.compare({first ? path : a, first ? a : path, std::nullopt});
            CHECK(result.code == 10);
            CHECK(holds(result.err, "compare: "));
        }
    }
}

TEST_CASE("Values that are not finite never pass, even against themselves") {
    const Bench bench;
    const float inf = std::numeric_limits<float>::infinity();
    const std::string good = bench.writeBytes("good.pfm", tinyPfm(0, 0, 0));
    for (const float value : {std::nanf(""), inf, -inf}) {
        const std::string bad = bench.writeBytes("bad.pfm", tinyPfm(0, value, 0));
        CAPTURE(value);
        CHECK(bench.compare({bad, bad, 1e30}).code == 10);
        CHECK(bench.compare({good, bad, 1e30}).code == 10);
        const Bench::Result result = bench.compare({bad, good, std::nullopt});
        CHECK(result.code == 10);
        CHECK(holds(result.err, "bad.pfm holds values that are not finite"));
    }
    CHECK(bench.compare({good, good, 0.0}).code == 0);
}

TEST_CASE("Floats are compared as they are with floats, and clipped with integers") {
    const Bench bench;
    const std::string low = bench.writeBytes("low.pfm", tinyPfm(-1, 1, 3));
    const std::string high = bench.writeBytes("high.pfm", tinyPfm(-1, 1, 5));
    const std::string png = bench.write("a.png", {1, 1, {{0, 1, 1}}});
    CHECK(holds(bench.compare({low, high, std::nullopt}).out, "max         2 at 0,0"));
    CHECK(bench.compare({low, png, 0.0}).code == 0);
    CHECK(bench.compare({png, high, 0.0}).code == 0);
}

TEST_CASE("NaN in an EXR is seen too") {
    if (!oiioLibrary()) {
        MESSAGE("without OpenImageIO: " << oiioLibrary().problem);
        return;
    }
    const Bench bench;
    std::vector<float> samples = {0.0f, std::nanf(""), 0.5f};
    const RtOiioImage raw{1, 1, 3, kRtOiioFloat, samples.data(), nullptr};
    void* bytes = nullptr;
    std::size_t count = 0;
    char words[256] = "";
    REQUIRE(oiioLibrary().write("openexr", &raw, nullptr, 0, &bytes, &count, words,
                                sizeof(words)) == kRtOiioDone);
    const std::string path =
        bench.writeBytes("nan.exr", std::string(static_cast<const char*>(bytes), count));
    oiioLibrary().free(bytes);
    CHECK(bench.compare({path, path, 1.0}).code == 10);
    const std::string good = bench.write("good.exr", filledWith(3, 3, {0.5, 7.0, 1e-3}));
    CHECK(bench.compare({good, good, 0.0}).code == 0);
}
