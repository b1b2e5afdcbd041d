#include "picture_part.h"

#include "output_names.h"
#include "rt/core/error.h"
#include "rt/core/packed_bytes.h"
#include "scene_hash.h"

#include <algorithm>
#include <string_view>

namespace rt {
namespace {

constexpr std::string_view kMagic = "RTPART2\n";
constexpr std::string_view kAnyMagic = "RTPART";
constexpr std::size_t kChecksumBytes = 8;

std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
    return Fingerprint().add(bytes).value();
}

void writeHead(PackedWriter& to, const PicturePart& part) {
    to.number(part.sceneHash);
    to.number(part.seed);
    for (const int value :
         {part.width, part.height, part.area.x0, part.area.y0, part.area.x1, part.area.y1,
          part.shard.index, part.shard.count, part.settings.bits,
          part.settings.transfer == Transfer::kSrgb ? 1 : 0, part.planned ? 1 : 0}) {
        to.word(value);
    }
    to.real(part.samplesPerPixel);
    to.word(part.error ? 1 : 0);
    to.real(part.error.value_or(0.0));
    to.real(part.causticError);
    to.text(part.scene);
    to.word(static_cast<int>(part.planes.size()));
    for (const ImagePlane& plane : part.planes) {
        to.text(plane.name);
        to.word(static_cast<int>(plane.channels.size()));
        for (const std::string& channel : plane.channels) to.text(channel);
    }
}

ImagePlane readPlane(PackedReader& from) {
    ImagePlane plane;
    plane.name = from.text();
    const int channels = from.word();
    if (channels < 1 || channels > 3) throw DamagedBytes{};
    for (int i = 0; i < channels; ++i) plane.channels.push_back(from.text());
    return plane;
}

void readHead(PackedReader& from, PicturePart& part) {
    part.sceneHash = from.number<std::uint64_t>();
    part.seed = from.number<std::uint64_t>();
    int transfer = 0;
    int planned = 0;
    for (int* const value :
         {&part.width, &part.height, &part.area.x0, &part.area.y0, &part.area.x1, &part.area.y1,
          &part.shard.index, &part.shard.count, &part.settings.bits, &transfer, &planned}) {
        *value = from.word();
    }
    part.settings.transfer = transfer == 1 ? Transfer::kSrgb : Transfer::kRaw;
    part.planned = planned == 1;
    part.samplesPerPixel = from.real();
    const bool known = from.word() == 1;
    const double error = from.real();
    if (known) part.error = error;
    part.causticError = from.real();
    part.scene = from.text();
    const int planes = from.word();
    for (int i = 0; i < planes; ++i) part.planes.push_back(readPlane(from));
}

bool isSensible(const PicturePart& part) {
    const Tile& area = part.area;
    return 0 <= area.x0 && area.x0 < area.x1 && area.x1 <= part.width && 0 <= area.y0 &&
           area.y0 < area.y1 && area.y1 <= part.height && 1 <= part.shard.index &&
           part.shard.index <= part.shard.count && part.shard.count <= kMostShards &&
           (part.settings.bits == 8 || part.settings.bits == 16);
}

std::size_t bytesOf(const Tile& tile, std::size_t channels) {
    const auto pixels =
        static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
    return 16 + pixels * (56 + 4 * channels);
}

PartTile readTile(PackedReader& from, const Tile& place, const std::vector<ImagePlane>& planes) {
    PartTile tile;
    tile.tile = place;
    tile.cutBound = from.real();
    tile.cameraRays = from.number<std::uint64_t>();
    tile.pixels.resize(static_cast<std::size_t>(place.width()) *
                       static_cast<std::size_t>(place.height()));
    for (PixelState& pixel : tile.pixels) {
        pixel.sum = from.color();
        pixel.half = from.color();
        pixel.samples = from.number<std::uint64_t>();
    }
    for (const ImagePlane& plane : planes) {
        tile.planes.emplace_back(tile.pixels.size() * plane.channels.size());
        for (float& value : tile.planes.back()) value = from.single();
    }
    return tile;
}

/// Before anything large is allocated: whether the tiles take what is left.
void readTiles(PackedReader& from, PicturePart& part) {
    if (!isSensible(part)) throw DamagedBytes{};
    const auto across = [](int length) { return (length - 1) / kTileSize + 1; };
    const double most =
        (static_cast<double>(from.left() / bytesOf({0, 0, 1, 1}, 0)) + 1.0) * part.shard.count;
    if (1.0 * across(part.area.width()) * across(part.area.height()) > most) throw DamagedBytes{};
    std::size_t channels = 0;
    for (const ImagePlane& plane : part.planes) channels += plane.channels.size();
    const std::vector<Tile> tiles = tilesOf(part.area);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (part.shard.owns(i)) expected += bytesOf(tiles[i], channels);
    }
    if (expected != from.left()) throw DamagedBytes{};
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (part.shard.owns(i)) part.tiles.push_back(readTile(from, tiles[i], part.planes));
    }
}

}  // namespace

std::vector<std::uint8_t> encodePart(const PicturePart& part) {
    PackedWriter to;
    to.bytes().assign(kMagic.begin(), kMagic.end());
    writeHead(to, part);
    for (const PartTile& tile : part.tiles) {
        to.real(tile.cutBound);
        to.number(tile.cameraRays);
        for (const PixelState& pixel : tile.pixels) {
            to.color(pixel.sum);
            to.color(pixel.half);
            to.number(pixel.samples);
        }
        for (const std::vector<float>& values : tile.planes) {
            for (const float value : values) to.real(value);
        }
    }
    to.number(checksum(to.bytes()));
    return std::move(to.bytes());
}

PicturePart decodePart(const std::vector<std::uint8_t>& bytes, const std::string& path) {
    const std::string_view start(reinterpret_cast<const char*>(bytes.data()),
                                 std::min(bytes.size(), kMagic.size()));
    if (start.substr(0, kAnyMagic.size()) != kAnyMagic) {
        throw SceneError("not a part of a picture, as --shard writes them", {path, 0});
    }
    if (start != kMagic) {
        throw SceneError("a part of a picture by another version of this program", {path, 0});
    }
    PicturePart part;
    try {
        if (bytes.size() < kMagic.size() + kChecksumBytes) throw DamagedBytes{};
        const auto all = std::span(bytes);
        const auto body = all.first(bytes.size() - kChecksumBytes);
        if (PackedReader(all.last(kChecksumBytes)).number<std::uint64_t>() != checksum(body)) {
            throw DamagedBytes{};
        }
        PackedReader from(body.subspan(kMagic.size()));
        readHead(from, part);
        readTiles(from, part);
    } catch (const DamagedBytes&) {
        throw SceneError("the part is damaged; render its shard again", {path, 0});
    }
    return part;
}

std::string partName(const std::string& output, const Shard& shard) {
    constexpr std::string_view kExtension = ".part";
    if (output.ends_with(kExtension)) return output;
    return splitExtension(output).first + "." + std::to_string(shard.index) + "-of-" +
           std::to_string(shard.count) + std::string(kExtension);
}

}  // namespace rt
