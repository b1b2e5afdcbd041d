// A picture of what stands on a floor, z upwards, from a little above.
#pragma once

#include "optics_shot.h"

#include <string>
#include <utility>

namespace rt::test {

/// `side` x `side` pixels, of which what lies about the origin takes the middle.
inline Shot floorShot(std::string body, int side = 48) {
    Shot shot;
    shot.body = std::move(body);
    shot.eye = {0.0, -7.0, 2.3};
    shot.view = {0.0, 7.0, -1.8};
    shot.up = {0.0, 0.0, 1.0};
    shot.fov = 36.0;
    shot.width = shot.height = side;
    return shot;
}

}  // namespace rt::test
