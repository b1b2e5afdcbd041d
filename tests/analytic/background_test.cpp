// What rays see that meet nothing.
#include "optics_shot.h"

#include "rt/output/image_writer.h"

using namespace rt;
using namespace rt::test;

namespace {

/// 8 x 4 texels with a colour of their own each, exact in 8 bits.
Color texel(int column, int row) {
    return Color(column * 30 / 255.0, row * 60 / 255.0, (column + row) % 2);
}

class Sky {
  public:
    Sky() {
        PixelImage image{8, 4, {}};
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 8; ++column) image.pixels.push_back(texel(column, row));
        }
        writeImage(folder_.file("sky.png"), image, {}, {});
    }

    Color at(const Vec3& direction, bool flipV = false) const {
        Shot shot;
        shot.body = "gr.background('sky.png')";
        shot.eye = {3.0, -7.0, 5.0};
        shot.view = direction;
        // Not along the view, wherever that points.
        shot.up = {direction.y, direction.z + 0.1, direction.x + 0.2};
        PictureSettings settings;
        settings.folder = folder_.path().string();
        settings.options.spp = 1;
        settings.options.flipV = flipV;
        return renderScript(shot.script(), settings).at(0, 0);
    }

  private:
    TemporaryFolder folder_;
};

/// The direction at parts of the image from its top left.
Vec3 directionAt(double across, double down) {
    const double longitude = (across - 0.5) * 2.0 * kPi;  // from -z towards +x
    const double latitude = (0.5 - down) * kPi;
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
            -std::cos(latitude) * std::cos(longitude)};
}

void checkColor(const Color& actual, const Color& expected) {
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        CHECK(std::fabs(actual[c] - expected[c]) < 1e-12);
    }
}

}  // namespace

TEST_CASE("a sky's image lies with its middle at -z, its right half at +x, its top row up") {
    const Sky sky;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 8; ++column) {
            CAPTURE(row);
            CAPTURE(column);
            const Vec3 middle = directionAt((column + 0.5) / 8.0, (row + 0.5) / 4.0);
            checkColor(sky.at(middle), texel(column, row));
            // Textures may be flipped; the sky stays where it is.
            checkColor(sky.at(middle, true), texel(column, row));
        }
    }
    // Straight on: between columns 3 and 4, rows 1 and 2.
    checkColor(sky.at({0, 0, -1}), 0.25 * (texel(3, 1) + texel(4, 1) + texel(3, 2) + texel(4, 2)));
    checkColor(sky.at({1, 0, 0}), 0.25 * (texel(5, 1) + texel(6, 1) + texel(5, 2) + texel(6, 2)));
}

TEST_CASE("behind the viewer the sky's image closes: its last column meets its first") {
    const Sky sky;
    checkColor(sky.at({0, 0, 1}), 0.25 * (texel(7, 1) + texel(0, 1) + texel(7, 2) + texel(0, 2)));
    checkColor(sky.at(directionAt(0.25 / 8.0, 0.375)), 0.75 * texel(0, 1) + 0.25 * texel(7, 1));
    checkColor(sky.at(directionAt(7.75 / 8.0, 0.375)), 0.75 * texel(7, 1) + 0.25 * texel(0, 1));
}

TEST_CASE("at a pole the sky shows its first or last row alone") {
    const Sky sky;
    for (const double down : {0.0, 0.01, 0.06, 0.12}) {
        CAPTURE(down);
        for (int column = 0; column < 8; ++column) {
            const double across = (column + 0.5) / 8.0;
            if (down > 0.0) {
                checkColor(sky.at(directionAt(across, down)), texel(column, 0));
                checkColor(sky.at(directionAt(across, 1.0 - down)), texel(column, 3));
            }
        }
    }
    // Straight up the longitude has no meaning, but the green part, the row's, has.
    CHECK(std::fabs(sky.at({0, 1, 0}).y - texel(0, 0).y) < 1e-12);
    CHECK(std::fabs(sky.at({0, -1, 0}).y - texel(0, 3).y) < 1e-12);
}

TEST_CASE("a gradient follows the direction's y, whatever the eye's place and the view's length") {
    for (int i = 0; i < 40; ++i) {
        CAPTURE(i);
        const Vec3 d(std::sin(1.0 * i), std::sin(2.3 * i), std::cos(3.1 * i));
        Shot shot;
        shot.body = "gr.background({0.125, 0.5, 1}, {1, 0.25, 0})";
        shot.eye = {100.0, -50.0, 7.0};
        shot.view = 12.5 * d;
        shot.up = {0.3, 0.2, 1.0};
        const double part = 0.5 + 0.5 * d.y / glm::length(d);
        const Color expected(0.125 + part * 0.875, 0.5 - part * 0.25, 1.0 - part);
        checkColor(shoot(shot).at(0, 0), expected);
    }
}

TEST_CASE("a plain background is its colour to the bit, mirrored and through glass as well") {
    Shot shot;
    shot.body = "gr.background({0.1, 2.7, 1e-9})\n" +
                place("gr.nh_sphere('mirror', {-1, 0, 0}, 0.8)", 0.0, "it:set_reflection(0)") +
                place("gr.nh_sphere('glass', {1, 0, 0}, 0.8)", 0.0, "it:set_refraction(1.5, 0)");
    shot.fov = 30.0;
    shot.width = shot.height = 12;
    const Picture picture = shoot(shot);
    for (const Color& pixel : picture.pixels) CHECK(pixel == Color(0.1, 2.7, 1e-9));
}
