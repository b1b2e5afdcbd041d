#include "rt/core/error.h"

#include <lodepng.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "encoders.h"

namespace rt {
namespace {

constexpr unsigned kOutOfMemory = 83;

/// zlib in place of lodepng's own compressor, which takes five times as long. Run lengths alone
/// after the Paeth filter: rendered images hold noise, in which a search for longer matches finds
/// nothing, and flat areas, which are runs. Signature and result codes are lodepng's, which keeps
/// to itself why this failed: the settings' context is a bool, whether it was for lack of memory.
unsigned deflateRuns(unsigned char** out, std::size_t* outSize, const unsigned char* in,
                     std::size_t inSize, const LodePNGCompressSettings* settings) {
    constexpr unsigned kFailed = 111;
    constexpr int kLargestWindow = 15;
    constexpr int kMemoryLevel = 8;
    z_stream stream{};
    const auto outOfMemory = [settings] {
        *static_cast<bool*>(const_cast<void*>(settings->custom_context)) = true;
        return kOutOfMemory;
    };
    if (deflateInit2(&stream, 1, Z_DEFLATED, kLargestWindow, kMemoryLevel, Z_RLE) != Z_OK) {
        return outOfMemory();
    }
    const uLong bound = deflateBound(&stream, inSize);
    *out = static_cast<unsigned char*>(std::malloc(bound));
    stream.next_in = const_cast<Bytef*>(in);
    stream.avail_in = static_cast<uInt>(inSize);
    stream.next_out = *out;
    stream.avail_out = static_cast<uInt>(bound);
    const int result = *out ? deflate(&stream, Z_FINISH) : Z_MEM_ERROR;
    *outSize = stream.total_out;
    deflateEnd(&stream);
    if (result == Z_MEM_ERROR) return outOfMemory();
    return result == Z_STREAM_END ? 0 : kFailed;
}

void refuse(unsigned error) {
    if (error == 0) return;
    if (error == kOutOfMemory) throw std::bad_alloc();
    throw OutputError(std::string("the image cannot be encoded as PNG: ") +
                      lodepng_error_text(error));
}

bool isAscii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= 32 && c < 127; });
}

/// A text as a chunk: tEXt is Latin-1, so what is not plain ASCII goes into iTXt, which is UTF-8.
/// lodepng's own calls for texts do not see that memory is missing.
void addText(LodePNGInfo& info, const std::string& keyword, const std::string& text) {
    const bool plain = isAscii(text);
    std::string content = keyword + '\0';
    if (!plain) content.append(4, '\0');  // not compressed; no language, no translated keyword
    content += text;
    constexpr int kBeforeEnd = 2;
    refuse(lodepng_chunk_create(&info.unknown_chunks_data[kBeforeEnd],
                                &info.unknown_chunks_size[kBeforeEnd],
                                static_cast<unsigned>(content.size()), plain ? "tEXt" : "iTXt",
                                reinterpret_cast<const unsigned char*>(content.data())));
}

/// Two bytes for each channel, the higher first, as PNG wants them.
std::vector<std::uint8_t> bigEndian(const std::vector<std::uint16_t>& values) {
    std::vector<std::uint8_t> bytes(values.size() * 2);
    std::uint8_t* next = bytes.data();
    for (const std::uint16_t value : values) {
        *next++ = static_cast<std::uint8_t>(value >> 8);
        *next++ = static_cast<std::uint8_t>(value & 0xff);
    }
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> encodePng(const PixelImage& image, const ImageSettings& settings,
                                    const ImageMetadata& metadata) {
    lodepng::State state;
    for (LodePNGColorMode* mode : {&state.info_raw, &state.info_png.color}) {
        mode->colortype = LCT_RGB;
        mode->bitdepth = static_cast<unsigned>(settings.bits);
    }
    // No palette and no grey: the same kind of file for every image.
    state.encoder.auto_convert = 0;
    state.encoder.filter_palette_zero = 0;
    state.encoder.filter_strategy = LFS_FOUR;
    bool outOfMemory = false;
    state.encoder.zlibsettings.custom_zlib = deflateRuns;
    state.encoder.zlibsettings.custom_context = &outOfMemory;
    if (settings.transfer == Transfer::kSrgb) {
        state.info_png.srgb_defined = 1;
        state.info_png.srgb_intent = 0;
    }
    for (const auto& [keyword, text] : metadataEntries(metadata)) {
        addText(state.info_png, keyword, text);
    }
    const std::vector<std::uint8_t> raw = settings.bits == 16
                                              ? bigEndian(quantized16(image, settings.transfer))
                                              : quantized8(image, settings.transfer);
    std::vector<std::uint8_t> bytes;
    const unsigned error = lodepng::encode(bytes, raw, static_cast<unsigned>(image.width),
                                           static_cast<unsigned>(image.height), state);
    refuse(outOfMemory ? kOutOfMemory : error);
    return bytes;
}

}  // namespace rt
