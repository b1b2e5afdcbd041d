#include "rt/output/image_writer.h"

#include "app/commands/image_difference.h"
#include "output/encoders.h"
#include "rt/core/error.h"
#include "rt/core/version.h"
#include "rt/image/oiio_library.h"
#include "rt/output/atomic_file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <lodepng.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

PixelImage imageOf(int width, int height, std::vector<Color> pixels) {
    return {width, height, std::move(pixels)};
}

PixelImage randomImage(int width, int height, double most) {
    std::mt19937_64 random(42);
    std::uniform_real_distribution<double> value(0.0, most);
    PixelImage image = imageOf(width, height, {});
    for (int i = 0; i < width * height; ++i) {
        image.pixels.emplace_back(value(random), value(random), value(random));
    }
    return image;
}

std::vector<std::uint8_t> png(const PixelImage& image, const ImageSettings& settings,
                              const ImageMetadata& metadata = {}) {
    return encodeImage(imageFormatOf("a.png"), image, settings, metadata);
}

/// The samples of a PNG, read back with lodepng as its file has them.
struct Decoded {
    lodepng::State state;
    unsigned width = 0;
    unsigned height = 0;
    std::vector<unsigned> samples;
};

Decoded decoded(const std::vector<std::uint8_t>& bytes) {
    Decoded result;
    std::vector<unsigned char> raw;
    result.state.decoder.color_convert = 0;
    result.state.decoder.remember_unknown_chunks = 1;
    REQUIRE(lodepng::decode(raw, result.width, result.height, result.state, bytes) == 0);
    REQUIRE(result.state.info_png.color.colortype == LCT_RGB);
    const std::size_t size = result.state.info_png.color.bitdepth / 8;
    for (std::size_t i = 0; i < raw.size(); i += size) {
        result.samples.push_back(size == 1 ? raw[i] : raw[i] * 256u + raw[i + 1]);
    }
    return result;
}

unsigned onlySample(double value, int bits, Transfer transfer) {
    return decoded(png(imageOf(1, 1, {Color(value)}), {bits, transfer})).samples[0];
}

std::string folderOfTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "writer-XXXXXX").string();
    REQUIRE(::mkdtemp(pattern.data()) != nullptr);
    return pattern;
}

}  // namespace

TEST_CASE("A PNG holds round(255 clamp(value)), without a curve") {
    struct Case {
        double value;
        unsigned byte;
    };
    const std::vector<Case> cases = {
        {0.0, 0},           {1.0, 255},
        {-0.0, 0},          {-7.0, 0},
        {1.5, 255},         {1e300, 255},
        {-1e300, 0},        {0.5, 128},
        {0.25, 64},         {0.2, 51},
        {0.499 / 255.0, 0}, {0.501 / 255.0, 1},
        {0.5 / 255.0, 1},   {254.499 / 255.0, 254},
        {1e-320, 0},        {std::nextafter(1.0, 0.0), 255},
    };
    for (const Case& c : cases) {
        CAPTURE(c.value);
        CHECK(onlySample(c.value, 8, Transfer::kRaw) == c.byte);
    }
    for (unsigned k = 0; k <= 255; ++k) CHECK(onlySample(k / 255.0, 8, Transfer::kRaw) == k);
}

TEST_CASE("With 16 bits a PNG holds round(65535 clamp(value))") {
    CHECK(onlySample(0.5, 16, Transfer::kRaw) == 32768);
    CHECK(onlySample(-1.0, 16, Transfer::kRaw) == 0);
    CHECK(onlySample(2.0, 16, Transfer::kRaw) == 65535);
    for (unsigned k = 0; k <= 65535; k += 257) {
        CHECK(onlySample(k / 65535.0, 16, Transfer::kRaw) == k);
    }
    CHECK(onlySample(0x1234 / 65535.0, 16, Transfer::kRaw) == 0x1234);
}

TEST_CASE("The sRGB curve is that of IEC 61966-2-1, and both depths agree with it") {
    // Computed apart, in extended precision; the standard's own constants.
    const auto encoded = [](double v) {
        const long double linear = v;
        return linear <= 0.0031308L ? 12.92L * linear
                                    : 1.055L * std::pow(linear, 1.0L / 2.4L) - 0.055L;
    };
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    PixelImage image = imageOf(100, 20, {});
    for (int i = 0; i < 2000; ++i) {
        const double v = uniform(random);
        image.pixels.emplace_back(v, v * v * v * v, v * 0.004);
    }
    const Decoded eight = decoded(png(image, {8, Transfer::kSrgb}));
    const Decoded sixteen = decoded(png(image, {16, Transfer::kSrgb}));
    for (std::size_t i = 0; i < eight.samples.size(); ++i) {
        const double v = image.pixels[i / 3][static_cast<int>(i % 3)];
        const long double s = encoded(v);
        CAPTURE(v);
        CHECK(std::fabs(255.0L * s - eight.samples[i]) <= 0.5L + 1e-9L);
        CHECK(std::fabs(65535.0L * s - sixteen.samples[i]) <= 0.5L + 1e-7L);
        CHECK(std::fabs(srgbFromLinear(v) - static_cast<double>(s)) < 1e-14);
    }
    CHECK(onlySample(0.0, 8, Transfer::kSrgb) == 0);
    CHECK(onlySample(1.0, 8, Transfer::kSrgb) == 255);
    CHECK(onlySample(-3.0, 8, Transfer::kSrgb) == 0);
    CHECK(onlySample(3.0, 16, Transfer::kSrgb) == 65535);
    // 18 % grey, the usual check value.
    CHECK(onlySample(0.18, 8, Transfer::kSrgb) == 118);
    CHECK(eight.state.info_png.srgb_defined == 1);
    CHECK(decoded(png(image, {8, Transfer::kRaw})).state.info_png.srgb_defined == 0);
}

TEST_CASE("Rows and channels are where they belong") {
    const PixelImage image =
        imageOf(3, 2, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {1, 1, 1}, {0.2, 0.4, 0.6}});
    const Decoded read = decoded(png(image, {}));
    CHECK(read.width == 3);
    CHECK(read.height == 2);
    CHECK(read.samples == std::vector<unsigned>{255, 0, 0, 0, 255, 0, 0, 0, 255,  //
                                                0, 0, 0, 255, 255, 255, 51, 102, 153});
}

TEST_CASE("A PNG says how it was made, and nothing about when") {
    ImageMetadata metadata;
    metadata.scene = "a.lua";
    metadata.seed = 9007199254740992;
    metadata.samplesPerPixel = 4.5;
    metadata.error = 0.00297;
    const std::vector<std::uint8_t> bytes = png(randomImage(9, 5, 1.0), {}, metadata);
    const Decoded read = decoded(bytes);
    const LodePNGInfo& info = read.state.info_png;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < info.text_num; ++i) {
        texts.push_back(std::string(info.text_keys[i]) + "=" + info.text_strings[i]);
    }
    CHECK(texts ==
          std::vector<std::string>{std::string("Software=") + kProgramName + " " + kProgramVersion,
                                   "Scene=a.lua", "Seed=9007199254740992", "Samples per pixel=4.5",
                                   "Estimated RMSE=0.00297"});
    CHECK(info.time_defined == 0);
    CHECK(bytes == png(randomImage(9, 5, 1.0), {}, metadata));
    metadata.error.reset();
    CHECK(decoded(png(randomImage(9, 5, 1.0), {}, metadata)).state.info_png.text_num == 4);
}

TEST_CASE("A scene's name that is not ASCII is kept as UTF-8") {
    ImageMetadata metadata;
    metadata.scene = "h\xc3\xbctte\n.lua";
    const Decoded read = decoded(png(randomImage(2, 2, 1.0), {}, metadata));
    REQUIRE(read.state.info_png.itext_num == 1);
    CHECK(std::string(read.state.info_png.itext_keys[0]) == "Scene");
    CHECK(std::string(read.state.info_png.itext_strings[0]) == metadata.scene);
}

TEST_CASE("A PFM is its header and little-endian floats from the bottom row up") {
    const PixelImage image = imageOf(1, 2, {{1.0, 0.5, -2.0}, {0.0, 1e300, 0.25}});
    const std::vector<std::uint8_t> bytes = encodeImage(imageFormatOf("a.pfm"), image, {}, {});
    const std::string header = "PF\n1 2\n-1.0\n";
    std::vector<std::uint8_t> expected(header.begin(), header.end());
    for (const std::uint32_t word :
         {0x00000000u, 0x7f7fffffu, 0x3e800000u, 0x3f800000u, 0x3f000000u, 0xc0000000u}) {
        for (int shift = 0; shift < 32; shift += 8) {
            expected.push_back(static_cast<std::uint8_t>(word >> shift));
        }
    }
    CHECK(bytes == expected);
}

TEST_CASE("Every format gives back the values, as exactly as it can hold them") {
    struct Precision {
        std::string extension;
        double absolute;
        double relative;  // of the pixel's largest channel
    };
    const std::vector<Precision> precisions = {
        {".png", 0.5 / 255, 0.0}, {".exr", 0.0, 0x1p-24}, {".hdr", 0.0, 0x1p-7},
        {".tif", 0.5 / 255, 0.0}, {".pfm", 0.0, 0x1p-24}, {".tiff", 0.5 / 255, 0.0},
    };
    REQUIRE(precisions.size() == imageFormats().size());
    const std::string folder = folderOfTest();
    for (const Precision& p : precisions) {
        const ImageFormat& format = imageFormatOf("x" + p.extension);
        CAPTURE(p.extension);
        if (format.throughPlugin && !oiioLibrary()) {
            MESSAGE("without OpenImageIO: " << oiioLibrary().problem);
            continue;
        }
        for (const int bits : {8, 16}) {
            const PixelImage image = randomImage(37, 23, format.floats ? 20.0 : 1.0);
            const std::string path = folder + "/image" + p.extension;
            writeImage(path, image, {bits, Transfer::kRaw}, {"s.lua", 1, 2.0, 0.5});
            const ComparedImage read = loadForComparison(path);
            REQUIRE(read.image.width == image.width);
            REQUIRE(read.image.height == image.height);
            CHECK(read.floats == format.floats);
            const double step = bits == 16 ? p.absolute * 255 / 65535 : p.absolute;
            double worst = 0.0;
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                const Color& e = image.pixels[i];
                const double allowed = step + p.relative * std::max({e.r, e.g, e.b}) + 1e-12;
                for (int c = 0; c < 3; ++c) {
                    worst = std::max(worst, std::fabs(read.image.pixels[i][c] - e[c]) / allowed);
                }
            }
            CHECK(worst <= 1.0);
            CHECK(worst > 0.3);
        }
    }
    std::filesystem::remove_all(folder);
}

TEST_CASE("Equal images give equal bytes in every format, a second later too") {
    const PixelImage image = randomImage(16, 16, 1.0);
    const ImageMetadata metadata{"s.lua", 1, 2.0, 0.5};
    std::vector<std::vector<std::uint8_t>> first;
    for (int round = 0; round < 2; ++round) {
        if (round == 1) ::usleep(1100000);
        for (std::size_t i = 0; i < imageFormats().size(); ++i) {
            const ImageFormat& format = imageFormats()[i];
            if (format.throughPlugin && !oiioLibrary()) continue;
            const std::vector<std::uint8_t> bytes = encodeImage(format, image, {}, metadata);
            CAPTURE(std::string(format.extension));
            const std::string text(bytes.begin(), bytes.end());
            const bool namesScene = text.find("s.lua") != std::string::npos;
            const std::string extension = format.extension;
            CHECK(namesScene == (extension != ".pfm" && extension != ".hdr"));
            if (round == 0) first.push_back(bytes);
            if (round == 1) CHECK(bytes == first[i]);
        }
    }
}

TEST_CASE("A value that is not finite is never written") {
    const double inf = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), inf, -inf}) {
        for (const ImageFormat& format : imageFormats()) {
            PixelImage image = randomImage(4, 3, 1.0);
            image.pixels[7].g = bad;
            CAPTURE(std::string(format.extension));
            CHECK_THROWS_AS(encodeImage(format, image, {}, {}), std::logic_error);
        }
    }
}

TEST_CASE("The format is that of the name, in either case, or PNG where the name says nothing") {
    CHECK(std::string(imageFormatOf("a/b.c/x.PNG").extension) == ".png");
    CHECK(std::string(imageFormatOf("x.tar.eXr").extension) == ".exr");
    CHECK(std::string(imageFormatOf("-").extension) == ".png");
    CHECK(std::string(imageFormatOf("/dev/null").extension) == ".png");
    CHECK(holdsFloats("x.exr"));
    CHECK(holdsFloats("x.hdr"));
    CHECK_FALSE(holdsFloats("x.png"));
    for (const std::string name : {"x", "x.xyz", "a.png/x", "a/b/", "", ".", "x."}) {
        CAPTURE(name);
        try {
            imageFormatOf(name);
            FAIL("accepted");
        } catch (const OutputError& error) {
            const std::string said = error.what();
            CHECK(said.find("available: .png, .exr, .hdr") != std::string::npos);
            const bool named = name == "x.xyz" || name == "." || name == "x.";
            CHECK((said.find("has the unknown extension") != std::string::npos) == named);
        }
    }
}

TEST_CASE("What a format cannot hold is refused before rendering") {
    const std::string folder = folderOfTest();
    const auto check = [&](const std::string& name, int width, int height, int bits) {
        checkImageOutput(folder + "/" + name, width, height, {bits, Transfer::kRaw});
    };
    check("a.png", 26000, 26000, 8);
    CHECK_THROWS_AS(check("a.png", 27000, 27000, 8), OutputError);
    CHECK_THROWS_AS(check("a.png", 20000, 20000, 16), OutputError);
    check("a.pfm", 1000000, 1000000, 8);
    CHECK_THROWS_AS(check("a.xyz", 4, 4, 8), OutputError);
    CHECK_THROWS_AS(checkImageOutput(folder, 4, 4, {}), OutputError);
    if (oiioLibrary()) {
        check("a.tif", 37000, 37000, 8);
        CHECK_THROWS_AS(check("a.tif", 38000, 38000, 8), OutputError);
    } else {
        MESSAGE("without OpenImageIO: " << oiioLibrary().problem);
        for (const std::string name : {"a.tif", "a.exr", "a.hdr"}) {
            CHECK_THROWS_AS(check(name, 4, 4, 8), OutputError);
        }
        check("a.png", 4, 4, 8);
    }
    CHECK(std::filesystem::is_empty(folder));
    std::filesystem::remove_all(folder);
}

TEST_CASE("Without the plugin, what needs it is refused before rendering" * doctest::timeout(60)) {
    // This very program under a path that has no plugin beside it.
    const std::string folder = folderOfTest();
    const std::string program = folder + "/tests";
    std::filesystem::copy_file(std::filesystem::read_symlink("/proc/self/exe"), program);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const int log = ::open((folder + "/log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        ::dup2(log, 1);
        ::execl(program.c_str(), program.c_str(), "-tc=What a format cannot hold*",
                static_cast<char*>(nullptr));
        ::_exit(99);
    }
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    std::ifstream log(folder + "/log");
    const std::string text{std::istreambuf_iterator<char>(log), std::istreambuf_iterator<char>()};
    CAPTURE(text);
    CHECK(status == 0);
    CHECK(text.find("without OpenImageIO") != std::string::npos);
    std::filesystem::remove_all(folder);
}

TEST_CASE("A run of # becomes the number, padded to its length") {
    CHECK(numberedName("a#.png", 7) == "a7.png");
    CHECK(numberedName("a####.png", 7) == "a0007.png");
    CHECK(numberedName("#/##-###", 42) == "42/42-042");
    CHECK(numberedName("a##.png", 12345) == "a12345.png");
    CHECK(numberedName("a.png", 7) == "a.png");
    CHECK(numberedName("", 7).empty());
    CHECK(numberedName("##", 0) == "00");
}

TEST_CASE("Flat and noisy images of every small size come back exactly") {
    std::mt19937_64 random(3);
    for (int width = 1; width <= 9; ++width) {
        for (int height = 1; height <= 9; ++height) {
            PixelImage image = imageOf(width, height, {});
            std::vector<unsigned> expected;
            for (int i = 0; i < width * height; ++i) {
                const bool flat = (width + height) % 2 == 0;
                Color pixel(0.0);
                for (int c = 0; c < 3; ++c) {
                    const unsigned byte = flat ? 200u : static_cast<unsigned>(random() % 256);
                    expected.push_back(byte);
                    pixel[c] = byte / 255.0;
                }
                image.pixels.push_back(pixel);
            }
            CHECK(decoded(png(image, {})).samples == expected);
        }
    }
}
