// The border between the program and the plugin that holds OpenImageIO: plain C, so that the
// program starts, and reads and writes PNG, where OpenImageIO is not installed.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

enum RtOiioStorage : int { kRtOiioU8 = 0, kRtOiioU16 = 1, kRtOiioFloat = 2 };

/// Top row first, channels side by side.
struct RtOiioImage {
    int width;
    int height;
    int channels;
    int storage;  ///< RtOiioStorage
    void* samples;
    const char* const* names;  ///< of the channels, when writing; null: as the format has them
};

struct RtOiioEntry {
    const char* keyword;
    const char* text;
};

/// How a call ended; the text of a failure is in the caller's buffer.
enum RtOiioStatus : int { kRtOiioDone = 0, kRtOiioFailed = 1, kRtOiioTooLarge = 2 };

/// Reads `path` as `format` ("jpeg", "openexr", "hdr", "tiff", "targa", "bmp") and no other, with
/// 1 or 3 channels. `image->samples` is to be given back to rtOiioFree.
using RtOiioRead = int(const char* path, const char* format, std::uint64_t maxPixels,
                       RtOiioImage* image, char* error, std::size_t errorSize);

/// Encodes an image as `format` ("openexr", "hdr", "tiff") into memory: `*bytes`, `*count` long, to
/// be given back to rtOiioFree.
using RtOiioWrite = int(const char* format, const RtOiioImage* image, const RtOiioEntry* entries,
                        std::size_t entryCount, void** bytes, std::size_t* count, char* error,
                        std::size_t errorSize);

using RtOiioFree = void(void* memory);

RtOiioRead rtOiioRead;
RtOiioWrite rtOiioWrite;
RtOiioFree rtOiioFree;
}
