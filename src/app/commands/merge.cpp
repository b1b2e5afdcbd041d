// Shards of a picture become the picture: the file that one run would have written.
#include "picture_part.h"
#include "rt/app/aov.h"
#include "rt/app/commands.h"
#include "rt/app/progress.h"
#include "rt/core/diagnostics.h"
#include "rt/core/error.h"
#include "rt/core/input_file.h"
#include "rt/output/atomic_file.h"
#include "rt/render/renderer.h"
#include "scene_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>

namespace rt {
namespace {

struct NamedPart {
    std::string path;
    std::uint64_t hash;  ///< of its bytes
    PicturePart part;
};

std::string sizeOf(const PicturePart& part) {
    return std::to_string(part.width) + "x" + std::to_string(part.height);
}

/// What tells two parts apart that belong to different pictures; "" if nothing does.
std::string difference(const PicturePart& a, const PicturePart& b) {
    const auto is = [](const std::string& mine, const std::string& other) {
        return mine + ", where the first part's is " + other;
    };
    if (a.seed != b.seed)
        return "its seed is " + is(std::to_string(b.seed), std::to_string(a.seed));
    if (a.width != b.width || a.height != b.height) {
        return "the image's size is " + is(sizeOf(b), sizeOf(a));
    }
    if (a.shard.count != b.shard.count) {
        return "the number of shards is " +
               is(std::to_string(b.shard.count), std::to_string(a.shard.count));
    }
    const auto corners = [](const Tile& t) { return std::array{t.x0, t.y0, t.x1, t.y1}; };
    if (corners(a.area) != corners(b.area)) return "its --crop is not that of the first part";
    if (a.sceneHash != b.sceneHash) {
        return "it is of another scene, other options, or another version of the program than the "
               "first part";
    }
    if (a.planes.size() != b.planes.size()) return "its --aov is not that of the first part";
    for (std::size_t i = 0; i < a.planes.size(); ++i) {
        if (a.planes[i].name != b.planes[i].name) return "its --aov is not that of the first part";
    }
    return "";
}

void add(NamedPart read, std::map<int, NamedPart>& parts, Diagnostics& diagnostics) {
    if (!parts.empty()) {
        const std::string other = difference(parts.begin()->second.part, read.part);
        if (!other.empty()) throw SceneError(other, {read.path, 0});
    }
    const auto [place, isNew] = parts.try_emplace(read.part.shard.index, std::move(read));
    if (isNew) return;
    const NamedPart& known = place->second;
    const std::string shard = "shard " + std::to_string(read.part.shard.index);
    if (known.hash != read.hash) {
        throw SceneError(shard + " is also in " + known.path + ", with other content",
                         {read.path, 0});
    }
    diagnostics.warn("double-shard", {read.path, 0},
                     shard + " is also in " + known.path + ", with the same bytes");
}

std::map<int, NamedPart> readParts(const std::vector<std::string>& paths,
                                   Diagnostics& diagnostics) {
    std::map<int, NamedPart> parts;
    for (const std::string& path : paths) {
        const std::vector<std::uint8_t> bytes = InputFile(path).readAll();
        PicturePart part = decodePart(bytes, path);
        std::uint64_t hash = 0;
        for (std::size_t i = bytes.size() - sizeof(hash); i < bytes.size(); ++i) {
            hash = hash << 8 | bytes[i];
        }
        add({path, hash, std::move(part)}, parts, diagnostics);
    }
    return parts;
}

void requireAll(const std::map<int, NamedPart>& parts) {
    const int count = parts.begin()->second.part.shard.count;
    std::string missing;
    for (int i = 1; i <= count; ++i) {
        if (parts.contains(i)) continue;
        missing += (missing.empty() ? " " : ", ") + std::to_string(i);
    }
    if (missing.empty()) return;
    throw SceneError("missing of " + std::to_string(count) + " shards:" + missing);
}

/// Tiles come in the order in which one run has them: sums are rounded alike.
class Merged {
  public:
    explicit Merged(const std::map<int, NamedPart>& parts)
        : head_(parts.begin()->second.part), film_(head_.area) {
        image_ = {head_.area.width(), head_.area.height(), {}};
        image_.planes = head_.planes;
        for (ImagePlane& plane : image_.planes) {
            plane.values.resize(film_.pixels.size() * plane.channels.size());
        }
        std::map<int, std::size_t> next;
        const std::size_t tiles = tilesOf(head_.area).size();
        for (std::size_t i = 0; i < tiles; ++i) {
            const int shard = head_.shard.ownerOf(i);
            place(parts.at(shard).part.tiles[next[shard]++]);
        }
        for (const PixelState& pixel : film_.pixels) image_.pixels.push_back(pixel.mean());
    }

    ImageMetadata metadata() {
        ImageMetadata metadata;
        metadata.scene = head_.scene;
        metadata.seed = head_.seed;
        if (head_.planned) {
            metadata.samplesPerPixel = head_.samplesPerPixel;
            metadata.error = head_.error;
            return metadata;
        }
        std::uint64_t samples = 0;
        for (const PixelState& pixel : film_.pixels) samples += pixel.samples;
        metadata.samplesPerPixel =
            static_cast<double>(samples) / static_cast<double>(film_.pixels.size());
        const std::optional<UniformError> error = uniformError(film_);
        if (!error) return metadata;
        const double squared = error->rmse * error->rmse + head_.causticError;
        metadata.error =
            std::sqrt(squared) + cutBound_ / std::max(1.0, static_cast<double>(cameraRays_));
        for (ImagePlane& plane : image_.planes) {
            if (plane.name != namesOf({Aov::kError})[0]) continue;
            std::vector<double> errors = error->squared;
            for (double& one : errors) one += head_.causticError;
            plane = planesOf({Aov::kError}, {film_, errors, {}}, head_.area)[0];
        }
        return metadata;
    }

    const PixelImage& image() const { return image_; }
    const ImageSettings& settings() const { return head_.settings; }

  private:
    void place(const PartTile& from) {
        cutBound_ += from.cutBound;
        cameraRays_ += from.cameraRays;
        std::size_t index = 0;
        for (int y = from.tile.y0; y < from.tile.y1; ++y) {
            for (int x = from.tile.x0; x < from.tile.x1; ++x, ++index) {
                const std::size_t to = film_.offset(x, y);
                film_.pixels[to] = from.pixels[index];
                for (std::size_t p = 0; p < image_.planes.size(); ++p) {
                    const std::size_t channels = image_.planes[p].channels.size();
                    std::copy_n(&from.planes[p][index * channels], channels,
                                &image_.planes[p].values[to * channels]);
                }
            }
        }
    }

    const PicturePart& head_;
    Film film_;
    PixelImage image_;
    double cutBound_ = 0.0;
    std::uint64_t cameraRays_ = 0;
};

}  // namespace

int mergeCommand(const MergeOptions& options) {
    Diagnostics diagnostics;
    refuseOverwriting(options.output, options.parts);
    const std::map<int, NamedPart> parts = readParts(options.parts, diagnostics);
    requireAll(parts);
    Merged merged(parts);
    const ImageMetadata metadata = merged.metadata();
    const PixelImage& image = merged.image();
    checkImageOutput(options.output, image.width, image.height, merged.settings(),
                     namesOf(image.planes));
    const std::string warning = writeImage(options.output, image, merged.settings(), metadata);
    if (!warning.empty()) std::fprintf(stderr, "warning: %s\n", warning.c_str());
    for (const std::string& line : warningLines(diagnostics)) {
        std::fprintf(stderr, "%s\n", line.c_str());
    }
    const std::string error =
        metadata.error ? ", estimated error " + errorText(*metadata.error) : "";
    std::fprintf(stderr, "Merged %zu shards into %s%s\n", parts.size(), options.output.c_str(),
                 error.c_str());
    return 0;
}

}  // namespace rt
