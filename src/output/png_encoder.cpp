#include "rt/core/error.h"

#include <lodepng.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <new>

#include "encoders.h"

namespace rt {
namespace {

/// zlib in place of lodepng's own compressor, which takes five times as long. Run lengths alone
/// after the Paeth filter: rendered images hold noise, in which a search for longer matches finds
/// nothing, and flat areas, which are runs. Signature and result codes are lodepng's.
unsigned deflateRuns(unsigned char** out, std::size_t* outSize, const unsigned char* in,
                     std::size_t inSize, const LodePNGCompressSettings*) {
    constexpr unsigned kOutOfMemory = 83;
    constexpr unsigned kFailed = 111;
    constexpr int kLargestWindow = 15;
    constexpr int kMemoryLevel = 8;
    z_stream stream{};
    if (deflateInit2(&stream, 1, Z_DEFLATED, kLargestWindow, kMemoryLevel, Z_RLE) != Z_OK) {
        return kOutOfMemory;
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
    if (result == Z_MEM_ERROR) return kOutOfMemory;
    return result == Z_STREAM_END ? 0 : kFailed;
}

void refuse(unsigned error) {
    if (error == 0) return;
    if (error == 83) throw std::bad_alloc();
    throw OutputError(std::string("the image cannot be encoded as PNG: ") +
                      lodepng_error_text(error));
}

bool isAscii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= 32 && c < 127; });
}

/// tEXt is Latin-1, so what is not plain ASCII goes into iTXt, which is UTF-8.
void addText(LodePNGInfo& info, const ImageMetadata& metadata) {
    for (const auto& [keyword, text] : metadataEntries(metadata)) {
        refuse(isAscii(text) ? lodepng_add_text(&info, keyword.c_str(), text.c_str())
                             : lodepng_add_itext(&info, keyword.c_str(), "", "", text.c_str()));
    }
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
    state.encoder.text_compression = 0;
    state.encoder.zlibsettings.custom_zlib = deflateRuns;
    if (settings.transfer == Transfer::kSrgb) {
        state.info_png.srgb_defined = 1;
        state.info_png.srgb_intent = 0;
    }
    addText(state.info_png, metadata);
    const std::vector<std::uint8_t> raw = settings.bits == 16
                                              ? bigEndian(quantized16(image, settings.transfer))
                                              : quantized8(image, settings.transfer);
    std::vector<std::uint8_t> bytes;
    refuse(lodepng::encode(bytes, raw, static_cast<unsigned>(image.width),
                           static_cast<unsigned>(image.height), state));
    return bytes;
}

}  // namespace rt
