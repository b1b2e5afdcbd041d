// The plugin's three functions. No exception and no C++ type crosses them.
#include "rt/image/oiio_abi.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// More channels than any image has that a texture can be made of.
constexpr int kMostChannels = 64;

struct TooLarge {};

void say(const std::string& words, char* error, std::size_t errorSize) {
    if (errorSize == 0) return;
    const std::size_t length = std::min(words.size(), errorSize - 1);
    std::memcpy(error, words.data(), length);
    error[length] = '\0';
}

/// Runs `action`, which returns nothing, and tells how it ended.
template <typename Action>
int guarded(Action action, char* error, std::size_t errorSize) {
    try {
        action();
        return kRtOiioDone;
    } catch (const TooLarge&) {
        return kRtOiioTooLarge;
    } catch (const std::exception& problem) {
        say(problem.what(), error, errorSize);
    } catch (...) {
        say("unknown problem", error, errorSize);
    }
    return kRtOiioFailed;
}

void setLimits() {
    OIIO::attribute("try_all_readers", 0);
    OIIO::attribute("limits:channels", kMostChannels);
}

[[noreturn]] void failWith(const std::string& words, const std::string& otherwise) {
    throw std::runtime_error(words.empty() ? otherwise : words);
}

struct SampleType {
    RtOiioStorage storage;
    OIIO::TypeDesc type;
    std::size_t size;
};

SampleType sampleType(int storage) {
    if (storage == kRtOiioU8) return {kRtOiioU8, OIIO::TypeDesc::UINT8, 1};
    if (storage == kRtOiioU16) return {kRtOiioU16, OIIO::TypeDesc::UINT16, 2};
    return {kRtOiioFloat, OIIO::TypeDesc::FLOAT, 4};
}

/// What a file's samples are kept as.
SampleType keptType(const OIIO::ImageSpec& spec) {
    if (spec.format == OIIO::TypeDesc::UINT8) return sampleType(kRtOiioU8);
    if (spec.format == OIIO::TypeDesc::UINT16) return sampleType(kRtOiioU16);
    return sampleType(kRtOiioFloat);
}

void checkSpec(const OIIO::ImageSpec& spec, std::uint64_t maxPixels) {
    if (spec.width < 1 || spec.height < 1) throw std::runtime_error("the image has no pixels");
    if (spec.depth > 1) throw std::runtime_error("volumes are not images");
    if (spec.deep) throw std::runtime_error("deep images have no single colour in a pixel");
    if (spec.nchannels < 1) throw std::runtime_error("the image has no channels");
    // Not every one of the library's readers looks at its limit.
    if (spec.nchannels > kMostChannels) {
        throw std::runtime_error("the image has " + std::to_string(spec.nchannels) + " channels; " +
                                 std::to_string(kMostChannels) + " are allowed");
    }
    if (spec.channelindex("RY") >= 0) {
        throw std::runtime_error("luminance and chroma are not read; save it as RGB");
    }
    const std::uint64_t pixels =
        static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    if (pixels > maxPixels) throw TooLarge{};
}

void readImage(const char* path, const char* format, std::uint64_t maxPixels, RtOiioImage& image) {
    setLimits();
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(format, false);
    if (!input) failWith(OIIO::geterror(), "OpenImageIO was built without this format");
    // Colours as they are stored, not multiplied by the transparency that is then dropped.
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1;
    OIIO::ImageSpec spec;
    if (!input->open(path, spec, config)) failWith(input->geterror(), "damaged file");
    image.width = spec.width;
    image.height = spec.height;
    checkSpec(spec, maxPixels);

    const SampleType kept = keptType(spec);
    image.channels = spec.nchannels < 3 ? 1 : 3;
    image.storage = kept.storage;
    const std::size_t bytes = static_cast<std::size_t>(spec.width) *
                              static_cast<std::size_t>(spec.height) *
                              static_cast<std::size_t>(image.channels) * kept.size;
    image.samples = std::malloc(bytes);
    if (image.samples == nullptr) throw std::bad_alloc();
    if (!input->read_image(0, 0, 0, image.channels, kept.type, image.samples)) {
        failWith(input->geterror(), "damaged file");
    }
}

/// OpenImageIO stores the current time unless it finds one. Equal images are to be equal files, so
/// it finds an empty one, or in a TIFF one of a type that it passes over without a tag.
void leaveOutTime(OIIO::ImageSpec& spec, const std::string& format) {
    if (format == "tiff") {
        spec.attribute("DateTime", 0);
    } else {
        spec.attribute("DateTime", "");
    }
}

void writeImage(const char* format, const RtOiioImage& image, const RtOiioEntry* entries,
                std::size_t entryCount, std::vector<unsigned char>& bytes) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) failWith(OIIO::geterror(), "OpenImageIO was built without this format");
    const SampleType kept = sampleType(image.storage);
    OIIO::ImageSpec spec(image.width, image.height, image.channels, kept.type);
    if (image.names) spec.channelnames.assign(image.names, image.names + image.channels);
    for (std::size_t i = 0; i < entryCount; ++i)
        spec.attribute(entries[i].keyword, entries[i].text);
    leaveOutTime(spec, format);
    OIIO::Filesystem::IOVecOutput memory;
    if (!output->supports("ioproxy") || !output->set_ioproxy(&memory)) {
        throw std::runtime_error("this format cannot be written into memory");
    }
    if (!output->open(std::string("memory.") + format, spec) ||
        !output->write_image(kept.type, image.samples) || !output->close()) {
        failWith(output->geterror(), "writing failed");
    }
    bytes = memory.buffer();
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) int rtOiioRead(const char* path, const char* format,
                                                      std::uint64_t maxPixels, RtOiioImage* image,
                                                      char* error, std::size_t errorSize) {
    *image = {};
    return guarded([&] { readImage(path, format, maxPixels, *image); }, error, errorSize);
}

__attribute__((visibility("default"))) int rtOiioWrite(const char* format, const RtOiioImage* image,
                                                       const RtOiioEntry* entries,
                                                       std::size_t entryCount, void** bytes,
                                                       std::size_t* count, char* error,
                                                       std::size_t errorSize) {
    *bytes = nullptr;
    *count = 0;
    return guarded(
        [&] {
            std::vector<unsigned char> encoded;
            writeImage(format, *image, entries, entryCount, encoded);
            *bytes = std::malloc(encoded.size() + 1);
            if (*bytes == nullptr) throw std::bad_alloc();
            std::memcpy(*bytes, encoded.data(), encoded.size());
            *count = encoded.size();
        },
        error, errorSize);
}

__attribute__((visibility("default"))) void rtOiioFree(void* memory) {
    std::free(memory);
}
}
