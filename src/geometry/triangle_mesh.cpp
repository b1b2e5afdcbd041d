#include "rt/geometry/triangle_mesh.h"

namespace rt {

Bounds TriangleMesh::bounds() const {
    Bounds box;
    for (const Corners& corners : triangles) {
        for (const Index corner : corners) box.unite(positions[corner]);
    }
    return box;
}

}  // namespace rt
