#include "rt/compile/mesh_file.h"

#include "mesh_builder.h"
#include "obj_reader.h"
#include "rt/core/input_file.h"
#include "text_blocks.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace rt {
namespace {

// A triangle of an OBJ is some 40 bytes of text or more, and 120 of memory while its mesh is built.
constexpr std::uint64_t kMemoryPerTextByte = 3;

// As much as is looked at before a file is taken for text.
constexpr std::size_t kSniffed = 4096;

std::string gibibytes(std::uint64_t bytes) {
    const std::uint64_t tenths = bytes / ((std::uint64_t{1} << 30) / 10);
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GiB";
}

void checkMemory(const InputFile& file, std::uint64_t limit) {
    if (file.size() <= limit / kMemoryPerTextByte) return;
    const std::uint64_t need = std::min(file.size(), ~std::uint64_t{0} / kMemoryPerTextByte);
    throw LimitError("loading this mesh would need about " + gibibytes(kMemoryPerTextByte * need) +
                         " of memory; the limit for one mesh is " + gibibytes(limit),
                     {file.path(), 0});
}

void checkIsText(std::string_view start, const std::string& path) {
    for (const char c : start.substr(0, kSniffed)) {
        const unsigned char byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 || (byte >= '\t' && byte <= '\r')) continue;
        throw SceneError("not an OBJ: it holds binary data", {path, 0});
    }
}

std::size_t byteOrderMark(std::string_view start) {
    return start.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0;
}

}  // namespace

TriangleMesh loadObj(const std::string& path, const MeshOptions& options,
                     Diagnostics& diagnostics) {
    InputFile file(path);
    checkMemory(file, options.memoryLimit);
    MeshBuilder builder;
    ObjReader reader(path, builder);
    TextBlocks blocks(file);
    TextBlocks::Block block;
    bool isFirst = true;
    while (blocks.next(block)) {
        const std::string_view text(block.begin, block.end);
        if (isFirst) checkIsText(text, path);
        reader.read(block.begin + (isFirst ? byteOrderMark(text) : 0), block.end);
        isFirst = false;
    }
    reader.finish(diagnostics);
    return builder.finish(options, {path, 0}, diagnostics);
}

TriangleMesh meshFromPolygons(std::span<const Vec3> vertices, std::span<const Index> corners,
                              std::span<const Index> faceSizes, const MeshOptions& options,
                              const SourceLocation& where, Diagnostics& diagnostics) {
    MeshBuilder builder;
    builder.positions.assign(vertices.begin(), vertices.end());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3& p = vertices[i];
        if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
        throw SceneError("vertex " + std::to_string(i) + " must be finite", where);
    }
    std::vector<PolygonCorner> face;
    std::size_t first = 0;
    for (std::size_t f = 0; f < faceSizes.size(); ++f) {
        if (faceSizes[f] > corners.size() - first) {
            throw SceneError("face " + std::to_string(f) + " has more corners than there are",
                             where);
        }
        face.clear();
        for (const Index corner : corners.subspan(first, faceSizes[f])) {
            if (corner >= vertices.size()) {
                throw SceneError("face " + std::to_string(f) + ": vertex " +
                                     std::to_string(corner) + " of " +
                                     std::to_string(vertices.size()) + ", counted from 0",
                                 where);
            }
            face.push_back({corner, kNone, kNone});
        }
        first += faceSizes[f];
        if (face.size() >= 3) {
            builder.addFace(face, where);
        } else {
            builder.skipFace();
        }
    }
    if (first != corners.size()) throw SceneError("there are corners of no face", where);
    return builder.finish(options, where, diagnostics);
}

}  // namespace rt
