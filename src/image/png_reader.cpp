#include "image_readers.h"

#include <lodepng.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace rt {
namespace {

// lodepng's numbers for a failed decoder of ours, an image without pixels, and lack of memory.
constexpr unsigned kZlibFailed = 110;
constexpr unsigned kNoPixels = 93;
constexpr unsigned kOutOfMemory = 83;

/// Upper bound on the filtered bytes of all rows. Interlaced images have up to 15/8 rows a row of
/// pixels and 7 more, each with a filter byte and an incomplete byte.
std::size_t filteredSize(std::size_t width, std::size_t height, std::size_t bitsPerPixel) {
    return width * height * bitsPerPixel / 8 + 4 * height + 16;
}

/// zlib's own inflate in place of lodepng's: it is faster, and it stops at `max_output_size`.
/// lodepng keeps to itself why it failed: the settings' context is a bool, whether it was for lack
/// of memory.
unsigned inflateBounded(unsigned char** out, std::size_t* outSize, const unsigned char* in,
                        std::size_t inSize, const LodePNGDecompressSettings* settings) {
    const auto failed = [settings](bool outOfMemory) {
        *static_cast<bool*>(const_cast<void*>(settings->custom_context)) = outOfMemory;
        return kZlibFailed;
    };
    z_stream stream{};
    if (::inflateInit(&stream) != Z_OK) return failed(true);
    const std::size_t most = settings->max_output_size;
    std::size_t capacity = std::min(most, std::max<std::size_t>(4 * inSize, 1 << 16));
    unsigned char* buffer = static_cast<unsigned char*>(std::malloc(capacity));
    std::size_t filled = 0;
    std::size_t taken = 0;
    int status = buffer == nullptr ? Z_MEM_ERROR : Z_OK;
    while (status == Z_OK) {
        const uInt give = static_cast<uInt>(std::min<std::size_t>(inSize - taken, 1u << 30));
        const uInt room = static_cast<uInt>(std::min<std::size_t>(capacity - filled, 1u << 30));
        stream.next_in = const_cast<unsigned char*>(in + taken);
        stream.avail_in = give;
        stream.next_out = buffer + filled;
        stream.avail_out = room;
        status = ::inflate(&stream, Z_NO_FLUSH);
        taken += give - stream.avail_in;
        filled += room - stream.avail_out;
        if (status != Z_OK || filled < capacity) continue;
        if (capacity == most) break;
        capacity = std::min(most, 2 * capacity);
        unsigned char* const larger = static_cast<unsigned char*>(std::realloc(buffer, capacity));
        if (larger == nullptr) status = Z_MEM_ERROR;
        if (larger != nullptr) buffer = larger;
    }
    ::inflateEnd(&stream);
    *out = buffer;
    *outSize = filled;
    return status == Z_STREAM_END ? 0 : failed(status == Z_MEM_ERROR);
}

std::string wordsOf(unsigned error) {
    if (error == kZlibFailed) return "its compressed data is damaged or too long";
    return lodepng_error_text(error);
}

[[noreturn]] void fail(const std::string& path, unsigned error) {
    if (error == kOutOfMemory) throw std::bad_alloc();
    throw SceneError("damaged PNG: " + wordsOf(error), {path, 0});
}

/// lodepng leaves two bytes a sample, the high one first.
std::vector<std::uint16_t> wide(std::span<const unsigned char> bytes) {
    std::vector<std::uint16_t> samples(bytes.size() / 2);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i] = static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
    }
    return samples;
}

}  // namespace

Image readPng(std::span<const std::uint8_t> bytes, const std::string& path,
              const ImageLimits& limits) {
    lodepng::State state;
    unsigned width = 0;
    unsigned height = 0;
    unsigned error = lodepng_inspect(&width, &height, &state, bytes.data(), bytes.size());
    if (error == 0 || error == kNoPixels) checkSize(width, height, path, limits);
    if (error != 0) fail(path, error);

    const LodePNGColorMode& color = state.info_png.color;
    const bool grey = color.colortype == LCT_GREY || color.colortype == LCT_GREY_ALPHA;
    state.info_raw.colortype = grey ? LCT_GREY : LCT_RGB;
    state.info_raw.bitdepth = color.bitdepth == 16 ? 16 : 8;
    state.decoder.read_text_chunks = 0;
    bool outOfMemory = false;
    state.decoder.zlibsettings.custom_zlib = inflateBounded;
    state.decoder.zlibsettings.custom_context = &outOfMemory;
    state.decoder.zlibsettings.max_output_size =
        filteredSize(width, height, lodepng_get_bpp(&color));

    std::vector<unsigned char> raw;
    error = lodepng::decode(raw, width, height, state, bytes.data(), bytes.size());
    if (error != 0) fail(path, outOfMemory ? kOutOfMemory : error);
    Image image{static_cast<int>(width), static_cast<int>(height), grey ? 1 : 3, {}};
    if (state.info_raw.bitdepth == 16) {
        image.samples = wide(raw);
    } else {
        image.samples = std::move(raw);
    }
    return image;
}

}  // namespace rt
