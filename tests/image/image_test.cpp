#include "rt/image/image.h"

#include "compile/scratch_folder.h"
#include "rt/image/oiio_library.h"

#include <doctest/doctest.h>
#include <lodepng.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace {

using namespace rt;

using Bytes = std::vector<unsigned char>;

std::string_view text(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// A PNG of the given kind, its pixels packed as the format wants them.
Bytes png(const Bytes& packed, unsigned width, unsigned height, LodePNGColorType kind,
          unsigned bits, bool interlaced = false) {
    lodepng::State state;
    state.info_raw.colortype = state.info_png.color.colortype = kind;
    state.info_raw.bitdepth = state.info_png.color.bitdepth = bits;
    state.info_png.interlace_method = interlaced;
    state.encoder.auto_convert = 0;
    if (kind == LCT_PALETTE) {
        for (LodePNGColorMode* mode : {&state.info_raw, &state.info_png.color}) {
            lodepng_palette_add(mode, 10, 20, 30, 255);
            lodepng_palette_add(mode, 40, 50, 60, 128);
        }
    }
    Bytes file;
    REQUIRE(lodepng::encode(file, packed, width, height, state) == 0);
    return file;
}

/// A file in a format of OpenImageIO's.
template <typename Sample>
Bytes throughOiio(const char* format, std::vector<Sample> samples, int width, int height,
                  int channels) {
    const OiioLibrary& library = oiioLibrary();
    INFO(library.problem);
    REQUIRE(library);
    const int storage = sizeof(Sample) == 1   ? kRtOiioU8
                        : sizeof(Sample) == 2 ? kRtOiioU16
                                              : kRtOiioFloat;
    const RtOiioImage image{width, height, channels, storage, samples.data(), nullptr};
    void* bytes = nullptr;
    std::size_t count = 0;
    char error[256] = "";
    const int status =
        library.write(format, &image, nullptr, 0, &bytes, &count, error, sizeof error);
    CAPTURE(error);
    REQUIRE(status == kRtOiioDone);
    const unsigned char* const first = static_cast<unsigned char*>(bytes);
    Bytes file(first, first + count);
    library.free(bytes);
    return file;
}

struct Loaded {
    Image image;
    Diagnostics diagnostics;
};

Loaded load(const std::string& name, const Bytes& bytes, const ImageLimits& limits = {}) {
    const test::ScratchFolder folder;
    Loaded loaded;
    loaded.image = loadImage(folder.file(name, text(bytes)), limits, loaded.diagnostics);
    return loaded;
}

template <typename Sample>
const std::vector<Sample>& samplesOf(const Image& image) {
    return std::get<std::vector<Sample>>(image.samples);
}

TEST_CASE("an 8-bit PNG keeps its bytes, from the top row down") {
    const Bytes pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18};
    for (const bool interlaced : {false, true}) {
        const Loaded loaded = load("a.png", png(pixels, 3, 2, LCT_RGB, 8, interlaced));
        CHECK(loaded.image.width == 3);
        CHECK(loaded.image.height == 2);
        CHECK(loaded.image.channels == 3);
        CHECK(samplesOf<std::uint8_t>(loaded.image) == pixels);
        CHECK(loaded.diagnostics.total() == 0);
    }
}

TEST_CASE("every kind of PNG becomes grey or colour, without transparency") {
    const auto codes = [](const Bytes& file) {
        return samplesOf<std::uint8_t>(load("a.png", file).image);
    };
    CHECK(codes(png({0b10100000}, 3, 1, LCT_GREY, 1)) == Bytes{255, 0, 255});
    CHECK(codes(png({0b00011011}, 4, 1, LCT_GREY, 2)) == Bytes{0, 85, 170, 255});
    CHECK(codes(png({0x0f}, 2, 1, LCT_GREY, 4)) == Bytes{0, 255});
    CHECK(codes(png({7, 200}, 2, 1, LCT_GREY, 8)) == Bytes{7, 200});
    CHECK(codes(png({7, 0, 200, 9}, 2, 1, LCT_GREY_ALPHA, 8)) == Bytes{7, 200});
    CHECK(codes(png({1, 2, 3, 0}, 1, 1, LCT_RGBA, 8)) == Bytes{1, 2, 3});
    CHECK(codes(png({0b01000000}, 2, 1, LCT_PALETTE, 1)) == Bytes{10, 20, 30, 40, 50, 60});
    CHECK(load("a.png", png({7}, 1, 1, LCT_GREY, 8)).image.channels == 1);
}

TEST_CASE("a 16-bit PNG keeps 16 bits") {
    const Image image = load("a.png", png({0x12, 0x34, 0xff, 0xfe, 0, 1}, 1, 1, LCT_RGB, 16)).image;
    CHECK(samplesOf<std::uint16_t>(image) == std::vector<std::uint16_t>{0x1234, 0xfffe, 1});
    const Image grey = load("a.png", png({0x12, 0x34}, 1, 1, LCT_GREY, 16)).image;
    CHECK(grey.channels == 1);
    CHECK(samplesOf<std::uint16_t>(grey)[0] == 0x1234);
}

TEST_CASE("long thin images are images") {
    for (const bool interlaced : {false, true}) {
        CHECK(load("a.png", png(Bytes(65536, 9), 1, 65536, LCT_GREY, 8, interlaced)).image.height ==
              65536);
        CHECK(load("a.png", png(Bytes(8192, 9), 65536, 1, LCT_GREY, 1, interlaced)).image.width ==
              65536);
    }
}

TEST_CASE("files without losses come through OpenImageIO as they are") {
    const std::vector<std::uint8_t> codes = {0, 1, 2, 250, 128, 255, 9, 8, 7, 100, 50, 25};
    for (const std::string format : {"tiff", "targa", "bmp"}) {
        CAPTURE(format);
        const std::string extension = format == "tiff" ? "tif" : format == "bmp" ? "bmp" : "tga";
        const Loaded loaded = load("a." + extension, throughOiio(format.c_str(), codes, 2, 2, 3));
        CHECK(loaded.image.width == 2);
        CHECK(loaded.image.channels == 3);
        CHECK(samplesOf<std::uint8_t>(loaded.image) == codes);
        CHECK(loaded.diagnostics.total() == 0);
    }
    const std::vector<std::uint16_t> wide = {0, 1, 65535, 300};
    const Image tiff = load("a.tiff", throughOiio("tiff", wide, 2, 2, 1)).image;
    CHECK(tiff.channels == 1);
    CHECK(samplesOf<std::uint16_t>(tiff) == wide);
}

TEST_CASE("transparency is dropped and not multiplied in") {
    const Image tiff =
        load("a.tif", throughOiio<std::uint8_t>("tiff", {200, 100, 50, 128}, 1, 1, 4)).image;
    CHECK(tiff.channels == 3);
    const Image two = load("a.tif", throughOiio<std::uint8_t>("tiff", {200, 100}, 1, 1, 2)).image;
    CHECK(two.channels == 1);
    CHECK(samplesOf<std::uint8_t>(two)[0] == 200);
    // A TGA of one pixel with straight alpha, in the format's order blue, green, red, alpha.
    const Bytes tga = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 32, 0x28, 50, 100, 200, 128};
    CHECK(samplesOf<std::uint8_t>(load("a.tga", tga).image) == Bytes{200, 100, 50});
}

TEST_CASE("a JPEG is read within its losses") {
    const std::vector<std::uint8_t> codes(16 * 16 * 3, 180);
    const Image image = load("a.jpg", throughOiio("jpeg", codes, 16, 16, 3)).image;
    CHECK(image.width == 16);
    for (const std::uint8_t code : samplesOf<std::uint8_t>(image)) CHECK(std::abs(code - 180) <= 2);
}

TEST_CASE("floats of EXR and HDR are values, and what is no colour becomes 0") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> values = {0.0f, 0.25f, 1e6f, nan, -1.0f, inf};
    const Loaded loaded = load("a.exr", throughOiio("openexr", values, 2, 1, 3));
    CHECK(samplesOf<float>(loaded.image) ==
          std::vector<float>{0.0f, 0.25f, 1e6f, 0.0f, 0.0f, 0.0f});
    REQUIRE(loaded.diagnostics.total() == 1);
    CHECK(loaded.diagnostics.shown()[0].message ==
          "3 values are negative or not finite, and taken as 0");

    const Loaded hdr = load("a.hdr", throughOiio<float>("hdr", {0.5f, 2.0f, 1.0f}, 1, 1, 3));
    CHECK(samplesOf<float>(hdr.image) == std::vector<float>{0.5f, 2.0f, 1.0f});
    CHECK(hdr.diagnostics.total() == 0);
}

TEST_CASE("five channels give the first three") {
    const Image image =
        load("a.tif", throughOiio<std::uint8_t>("tiff", {1, 2, 3, 4, 5}, 1, 1, 5)).image;
    CHECK(image.channels == 3);
    CHECK(samplesOf<std::uint8_t>(image) == Bytes{1, 2, 3});
}

TEST_CASE("the limit of pixels holds in every format, before anything is decoded") {
    const std::vector<std::uint8_t> codes(8 * 8 * 3, 90);
    const std::vector<float> values(8 * 8 * 3, 0.5f);
    const std::pair<const char*, Bytes> files[] = {
        {"a.jpg", throughOiio("jpeg", codes, 8, 8, 3)},
        {"a.tif", throughOiio("tiff", codes, 8, 8, 3)},
        {"a.tga", throughOiio("targa", codes, 8, 8, 3)},
        {"a.bmp", throughOiio("bmp", codes, 8, 8, 3)},
        {"a.exr", throughOiio("openexr", values, 8, 8, 3)},
        {"a.hdr", throughOiio("hdr", values, 8, 8, 3)},
    };
    for (const auto& [name, bytes] : files) {
        CAPTURE(name);
        CHECK(load(name, bytes, {64, "--max-pixels"}).image.width == 8);
        CHECK_THROWS_AS(load(name, bytes, {63, "--max-pixels"}), LimitError);
        // The rest of the file is not looked at: without it the answer is the same.
        Bytes cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() - 8));
        CHECK_THROWS_AS(load(name, cut, {63, "--max-pixels"}), LimitError);
    }
}

TEST_CASE("more than 64 channels are refused, 64 give the first three") {
    for (const std::string format : {"tiff", "openexr"}) {
        CAPTURE(format);
        const std::string name = format == "tiff" ? "a.tif" : "a.exr";
        for (const int channels : {64, 65}) {
            std::vector<float> values;
            for (int c = 0; c < channels; ++c) values.push_back(static_cast<float>(c + 1) / 128.0f);
            const Bytes file = throughOiio(format.c_str(), values, 1, 1, channels);
            if (channels > 64) {
                CHECK_THROWS_AS(load(name, file), SceneError);
                continue;
            }
            const Image image = load(name, file).image;
            CHECK(image.channels == 3);
        }
    }
}

TEST_CASE("a grey JPEG, TIFF or EXR has one channel, and so can be a height map") {
    const std::vector<std::uint8_t> codes(16 * 16, 77);
    CHECK(load("a.jpg", throughOiio("jpeg", codes, 16, 16, 1)).image.channels == 1);
    CHECK(load("a.tif", throughOiio("tiff", codes, 16, 16, 1)).image.channels == 1);
    const std::vector<float> heights(16, 0.25f);
    const Image exr = load("a.exr", throughOiio("openexr", heights, 4, 4, 1)).image;
    CHECK(exr.channels == 1);
    CHECK(samplesOf<float>(exr) == heights);
}

TEST_CASE("the content says what a file is, whatever its name") {
    const Bytes file = png({1, 2, 3}, 1, 1, LCT_RGB, 8);
    const Loaded loaded = load("a.jpg", file);
    CHECK(samplesOf<std::uint8_t>(loaded.image) == Bytes{1, 2, 3});
    REQUIRE(loaded.diagnostics.total() == 1);
    CHECK(loaded.diagnostics.shown()[0].message == "the file is a PNG, whatever its name says");
    CHECK(load("a.PNG", file).diagnostics.total() == 0);
    CHECK(load("a", file).diagnostics.total() == 0);
    const Bytes jpeg = throughOiio("jpeg", std::vector<std::uint8_t>(48, 9), 4, 4, 3);
    CHECK(load("a.png", jpeg).diagnostics.total() == 1);
}

TEST_CASE("a colour profile larger than the image does no harm") {
    lodepng::State state;
    std::mt19937 random(7);
    Bytes profile(100000);
    for (unsigned char& byte : profile) byte = static_cast<unsigned char>(random());
    std::memcpy(&profile[16], "RGB ", 4);
    lodepng_set_icc(&state.info_png, "p", profile.data(), static_cast<unsigned>(profile.size()));
    state.info_raw.colortype = LCT_RGB;
    Bytes file;
    REQUIRE(lodepng::encode(file, Bytes{1, 2, 3}, 1, 1, state) == 0);
    CHECK(samplesOf<std::uint8_t>(load("a.png", file).image)[2] == 3);
}

}  // namespace
