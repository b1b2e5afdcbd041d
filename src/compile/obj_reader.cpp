#include "obj_reader.h"

#include "rt/core/text.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string_view>

namespace rt {
namespace {

constexpr std::size_t kShownWords = 8;

// Statements of the format that a triangle mesh has no use for.
constexpr std::array<std::string_view, 34> kKnownStatements = {
    "g",      "o",          "s",         "mg",    "usemtl", "mtllib",   "usemap",
    "maplib", "l",          "p",         "vp",    "cstype", "deg",      "bmat",
    "step",   "curv",       "curv2",     "surf",  "parm",   "trim",     "hole",
    "scrv",   "sp",         "end",       "con",   "bevel",  "c_interp", "d_interp",
    "lod",    "shadow_obj", "trace_obj", "ctech", "stech",  "call"};

std::string outOfRange(const char* what, std::int64_t index, std::size_t count) {
    return std::string(what) + " " + std::to_string(index) + " of " + std::to_string(count);
}

}  // namespace

void ObjReader::read(const char* begin, const char* end) {
    cursor_.enter(begin, end);
    while (!cursor_.atBlockEnd()) readStatement();
}

void ObjReader::readStatement() {
    cursor_.skipBlanks();
    const char first = cursor_.peek();
    if (ObjCursor::isLineEnd(first)) return cursor_.nextLine(false);
    // A backslash at the end of a comment is part of a sentence or a path.
    if (first == '#') return cursor_.nextLine(false);

    const char second = cursor_.peekAt(1);
    if (first == 'v' && ObjCursor::endsWord(second)) {
        readPosition();
    } else if (first == 'f' && ObjCursor::endsWord(second)) {
        readFace();
    } else if (first == 'v' && second == 'n' && ObjCursor::endsWord(cursor_.peekAt(2))) {
        readNormal();
    } else if (first == 'v' && second == 't' && ObjCursor::endsWord(cursor_.peekAt(2))) {
        readUv();
    } else {
        readOther();
    }
    cursor_.nextLine(true);
}

void ObjReader::readPosition() {
    cursor_.advance(1);
    const double x = cursor_.number("x of a vertex");
    const double y = cursor_.number("y of a vertex");
    const double z = cursor_.number("z of a vertex");
    mesh_.positions.push_back({x, y, z});
}

void ObjReader::readNormal() {
    cursor_.advance(2);
    const double x = cursor_.number("x of a normal");
    const double y = cursor_.number("y of a normal");
    const double z = cursor_.number("z of a normal");
    mesh_.normals.push_back({x, y, z});
}

void ObjReader::readUv() {
    cursor_.advance(2);
    const double u = cursor_.number("u of a texture coordinate");
    cursor_.skipBlanks();
    const double v = cursor_.atEndOfStatement() ? 0.0 : cursor_.number("v of a texture coordinate");
    mesh_.uvs.push_back({u, v});
}

Index ObjReader::resolve(std::int64_t index, std::size_t count, const char* what) {
    const std::int64_t known = static_cast<std::int64_t>(count);
    if (index == 0) cursor_.fail(std::string(what) + " 0: an OBJ counts from 1");
    if (index < -known || index > std::int64_t{kNone} - 2) {
        cursor_.fail(outOfRange(what, index, count));
    }
    if (index < 0) return static_cast<Index>(known + index);
    faceIsLate_ = faceIsLate_ || index > known;
    return static_cast<Index>(index - 1);
}

PolygonCorner ObjReader::readCorner() {
    PolygonCorner corner;
    corner.position = resolve(cursor_.integer(), mesh_.positions.size(), "vertex");
    if (cursor_.peek() != '/') return corner;
    cursor_.advance();
    if (cursor_.peek() != '/') {
        corner.uv = resolve(cursor_.integer(), mesh_.uvs.size(), "texture coordinate");
        if (cursor_.peek() != '/') return corner;
    }
    cursor_.advance();
    corner.normal = resolve(cursor_.integer(), mesh_.normals.size(), "normal");
    if (cursor_.peek() == '/') cursor_.fail("a corner is vertex/texture/normal at most");
    return corner;
}

void ObjReader::readFace() {
    const int line = cursor_.line();
    cursor_.advance(1);
    face_.clear();
    faceIsLate_ = false;
    for (cursor_.skipBlanks(); !cursor_.atEndOfStatement(); cursor_.skipBlanks()) {
        face_.push_back(readCorner());
    }
    if (faceIsLate_) {
        lateFaces_.push_back({lateCorners_.size(), face_.size(), line});
        lateCorners_.insert(lateCorners_.end(), face_.begin(), face_.end());
    } else if (face_.size() >= 3) {
        mesh_.addFace(face_, file_);
    } else if (cursor_.atBlockEnd()) {
        throw SceneError("the file ends within a face", {file_.file, line});
    } else {
        mesh_.skipFace();
    }
    sawGeometry_ = true;
}

void ObjReader::readOther() {
    const std::string word = cursor_.word();
    for (std::size_t i = 0; !ObjCursor::endsWord(cursor_.peekAt(i)); ++i) {
        const unsigned char c = static_cast<unsigned char>(cursor_.peekAt(i));
        if (c < 0x20) cursor_.fail("not an OBJ: a control byte where a statement should be");
    }
    const bool isKnown =
        std::find(kKnownStatements.begin(), kKnownStatements.end(), word) != kKnownStatements.end();
    Ignored& ignored = isKnown ? known_ : unknown_;
    if (ignored.count++ == 0) ignored.first = cursor_.where();
    if (ignored.words.size() < kShownWords &&
        std::find(ignored.words.begin(), ignored.words.end(), word) == ignored.words.end()) {
        ignored.words.push_back(word);
    }
}

void ObjReader::checkLate(const PolygonCorner& corner, int line) const {
    const auto check = [&](Index index, std::size_t count, const char* what) {
        if (index == kNone || index < count) return;
        throw SceneError(outOfRange(what, std::int64_t{index} + 1, count), {file_.file, line});
    };
    check(corner.position, mesh_.positions.size(), "vertex");
    check(corner.uv, mesh_.uvs.size(), "texture coordinate");
    check(corner.normal, mesh_.normals.size(), "normal");
}

void ObjReader::finish(Diagnostics& diagnostics) {
    for (const LateFace& late : lateFaces_) {
        const std::span<const PolygonCorner> face(lateCorners_.data() + late.firstCorner,
                                                  late.cornerCount);
        for (const PolygonCorner& corner : face) checkLate(corner, late.line);
        if (face.size() >= 3) {
            mesh_.addFace(face, file_);
        } else {
            mesh_.skipFace();
        }
    }
    if (unknown_.count > 0 && !sawGeometry_ && mesh_.positions.empty()) {
        throw SceneError("not an OBJ: no vertices, no faces, but \"" + unknown_.words[0] + "\"",
                         unknown_.first);
    }
    if (known_.count > 0) {
        diagnostics.warn(
            "obj-ignored", known_.first,
            "groups, materials and the like are ignored (" + joined(known_.words) + ")");
    }
    if (unknown_.count > 0) {
        diagnostics.warn("obj-unknown", unknown_.first,
                         "statements that no OBJ has are ignored (" + joined(unknown_.words) + ")");
    }
}

}  // namespace rt
