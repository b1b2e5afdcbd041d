// Bad images, as tables: what is in the file, and what must be said.
#include "compile/scratch_folder.h"
#include "image/image_readers.h"
#include "rt/image/image.h"
#include "rt/image/oiio_library.h"

#include <doctest/doctest.h>
#include <lodepng.h>
#include <sys/stat.h>

#include <random>

namespace {

using namespace rt;

std::string smallPng(unsigned width = 8, unsigned height = 8) {
    std::vector<unsigned char> pixels(3 * width * height);
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<unsigned char>(i * 37);
    std::vector<unsigned char> file;
    lodepng::encode(file, pixels, width, height, LCT_RGB, 8);
    return {file.begin(), file.end()};
}

void put32(std::string& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

/// A PNG whose header claims another size, with the header's checksum put right.
std::string claiming(std::string file, std::uint32_t width, std::uint32_t height) {
    put32(file, 16, width);
    put32(file, 20, height);
    put32(file, 29, lodepng_crc32(reinterpret_cast<const unsigned char*>(&file[12]), 17));
    return file;
}

/// A PNG of the given size whose pixels are `length` zeros, however many it should have.
std::string withData(std::uint32_t width, std::uint32_t height, std::size_t length) {
    std::vector<unsigned char> zeros(length);
    std::vector<unsigned char> packed;
    lodepng::compress(packed, zeros);
    std::vector<unsigned char> file;
    lodepng::encode(file, std::vector<unsigned char>{0, 0, 0}, 1, 1, LCT_RGB, 8);
    std::string bytes = claiming({file.begin(), file.end()}, width, height).substr(0, 33);
    unsigned char* chunk = nullptr;
    std::size_t size = 0;
    lodepng_chunk_create(&chunk, &size, static_cast<unsigned>(packed.size()), "IDAT",
                         packed.data());
    lodepng_chunk_create(&chunk, &size, 0, "IEND", nullptr);
    bytes.append(reinterpret_cast<char*>(chunk), size);
    std::free(chunk);
    return bytes;
}

struct Refused {
    std::string what;
    std::string name;
    std::string bytes;
    std::string message;  ///< somewhere in it, after the path
};

TEST_CASE("what is damaged, or no image that is read here, is refused") {
    std::string flipped = smallPng();
    flipped[45] ^= 0x40;
    const std::string notAnImage = ": not an image of a kind that is read here";
    const std::vector<Refused> table = {
        {"truncated", "a.png", smallPng().substr(0, 60), ": damaged PNG: "},
        {"header only", "a.png", smallPng().substr(0, 20), ": damaged PNG: "},
        {"bad checksum", "a.png", flipped, ": damaged PNG: invalid CRC"},
        {"0 x 8", "a.png", claiming(smallPng(), 0, 8), ": the image has no pixels (0 x 8)"},
        {"less data than pixels", "a.png", withData(64, 64, 100), ": damaged PNG: "},
        {"far more data than pixels", "a.png", withData(4, 4, 40 << 20),
         ": damaged PNG: its compressed data is damaged or too long"},
        {"empty", "a.png", "", notAnImage},
        {"text", "a.png", "hello, world, this is no image at all", notAnImage},
        {"GIF", "a.gif", "GIF89a\1\0\1\0\0\0\0", notAnImage},
        {"PSD", "a.psd", std::string("8BPS\0\1", 6), notAnImage},
        {"SVG", "a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>", notAnImage},
        {"DICOM", "a.dcm", std::string(60, '\0') + "DICM", notAnImage},
        {"JPEG 2000", "a.jp2", std::string("\0\0\0\x0cjP  \r\n\x87\n", 12), notAnImage},
        {"JPEG, cut", "a.jpg", "\xff\xd8\xff\xe0", ": cannot be read: "},
        {"EXR, cut", "a.exr", std::string("\x76\x2f\x31\x01\2\0\0\0", 8), ": cannot be read: "},
        {"HDR, cut", "a.hdr", "#?RADIANCE\n", ": cannot be read: "},
        {"TIFF, cut", "a.tif", std::string("II*\0\x08\0\0\0", 8), ": cannot be read: "},
        {"BMP, cut", "a.bmp", "BM123", ": cannot be read: "},
    };
    for (const Refused& row : table) {
        CAPTURE(row.what);
        const test::ScratchFolder folder;
        const std::string path = folder.file(row.name, row.bytes);
        Diagnostics diagnostics;
        std::string message;
        try {
            loadImage(path, {}, diagnostics);
        } catch (const SceneError& error) {
            message = error.what();
        }
        CHECK(message.substr(0, path.size() + row.message.size()) == path + row.message);
    }
}

TEST_CASE("only regular files are images") {
    const test::ScratchFolder folder;
    REQUIRE(::mkfifo(folder.path("p.png").c_str(), 0600) == 0);
    Diagnostics diagnostics;
    for (const std::string& path :
         {folder.path("none.png"), folder.path(""), folder.path("p.png"), std::string("/dev/zero"),
          std::string("http://a.b/c.png"), std::string("nul")}) {
        CAPTURE(path);
        CHECK_THROWS_AS(loadImage(path, {}, diagnostics), SceneError);
    }
}

TEST_CASE("an image of too many pixels is refused before it is decoded") {
    const test::ScratchFolder folder;
    Diagnostics diagnostics;
    const std::string bomb = folder.file("a.png", claiming(smallPng(), 100000, 100000));
    CHECK_THROWS_WITH_AS(loadImage(bomb, {}, diagnostics),
                         (bomb + ": the image has 100000 x 100000 pixels; --max-pixels allows "
                                 "268435456")
                             .c_str(),
                         LimitError);
    const std::string widest = folder.file("w.png", claiming(smallPng(), 0x7fffffff, 0x7fffffff));
    CHECK_THROWS_AS(loadImage(widest, {}, diagnostics), LimitError);

    const std::string small = folder.file("s.png", smallPng(8, 8));
    CHECK_THROWS_AS(loadImage(small, {63, "--max-pixels"}, diagnostics), LimitError);
    CHECK(loadImage(small, {64, "--max-pixels"}, diagnostics).width == 8);
    // A TGA that claims 60000 x 60000.
    const std::string tga =
        folder.file("a.tga", std::string("\0\0\2\0\0\0\0\0\0\0\0\0\x60\xea\x60\xea\x18\0", 18));
    CHECK_THROWS_WITH_AS(loadImage(tga, {}, diagnostics),
                         (tga + ": the image has 60000 x 60000 pixels; --max-pixels allows "
                                "268435456")
                             .c_str(),
                         LimitError);
}

TEST_CASE("without OpenImageIO the message says what to install, and PNG still works") {
    const OiioLibrary absent = openOiioLibrary("/nonexistent/librt_oiio.so");
    REQUIRE_FALSE(absent);
    CHECK(absent.problem.find("install libopenimageio") != std::string::npos);
    CHECK_THROWS_WITH_AS(readThroughOiio("a.jpg", "jpeg", {}, absent),
                         ("a.jpg: " + absent.problem).c_str(), SceneError);
    const OiioLibrary other = openOiioLibrary("libz.so.1");
    CHECK(other.problem == "libz.so.1 is not this program's plugin: build it again");
}

TEST_CASE("no damage to a file is more than an error") {
    const test::ScratchFolder folder;
    const std::string png = smallPng();
    for (unsigned seed = 1; seed <= 400; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::string bytes = png;
        for (unsigned i = 0; i <= seed % 4; ++i) {
            bytes[8 + random() % (bytes.size() - 8)] = static_cast<char>(random());
        }
        if (seed % 3 == 0) bytes.resize(random() % bytes.size());
        Diagnostics diagnostics;
        try {
            const Image image = loadImage(folder.file("x.png", bytes), {1 << 20, "x"}, diagnostics);
            const auto& samples = std::get<std::vector<std::uint8_t>>(image.samples);
            CHECK(samples.size() ==
                  static_cast<std::size_t>(image.width * image.height * image.channels));
        } catch (const Error& error) {
            CHECK(error.code() != ExitCode::kInternal);
        }
    }
}

}  // namespace
