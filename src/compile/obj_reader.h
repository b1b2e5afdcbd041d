// The statements of an OBJ file, handed to a MeshBuilder.
#pragma once

#include "mesh_builder.h"
#include "obj_cursor.h"
#include "rt/core/diagnostics.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rt {

/// Reads blocks of whole lines in order, then `finish`.
class ObjReader {
  public:
    ObjReader(const std::string& path, MeshBuilder& mesh)
        : file_{path, 0}, cursor_(path), mesh_(mesh) {}

    /// A file's last block may end within a line; the others may not.
    void read(const char* begin, const char* end);
    /// Adds the faces that named later vertices; warns of what was ignored.
    void finish(Diagnostics& diagnostics);

  private:
    /// A face with a corner that was not there yet.
    struct LateFace {
        std::size_t firstCorner;
        std::size_t cornerCount;
        int line;
    };
    struct Ignored {
        std::vector<std::string> words;
        SourceLocation first;
        std::size_t count = 0;
    };

    void readStatement();
    void readPosition();
    void readUv();
    void readNormal();
    void readFace();
    void readOther();
    PolygonCorner readCorner();
    Index resolve(std::int64_t index, std::size_t count, const char* what);
    void checkLate(const PolygonCorner& corner, int line) const;

    SourceLocation file_;
    ObjCursor cursor_;
    MeshBuilder& mesh_;
    std::vector<PolygonCorner> face_;
    bool faceIsLate_ = false;
    std::vector<LateFace> lateFaces_;
    std::vector<PolygonCorner> lateCorners_;
    Ignored known_;
    Ignored unknown_;
    bool sawGeometry_ = false;
};

}  // namespace rt
