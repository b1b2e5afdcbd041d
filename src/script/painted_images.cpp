#include "painted_images.h"

#include "arguments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace rt {
namespace {

constexpr int kFirstSide = 32;
constexpr int kMostUnasked = 2048;
constexpr double kClose = 1.0 / 512;

using Texel = std::array<float, 3>;

/// One function on its way through its texels.
class Painter {
  public:
    Painter(lua_State* L, SceneBuilder& builder, int function)
        : L_(L), builder_(builder), in_(L, builder), function_(function) {}

    Color at(double u, double v) {
        const StackGuard guard(L_);
        lua_rawgeti(L_, LUA_REGISTRYINDEX, function_);
        lua_pushnumber(L_, u);
        lua_pushnumber(L_, v);
        protectedCall(L_, 2, 3);
        const int first = lua_gettop(L_) - 2;
        if (in_.isTable(first)) return checked(in_.tuple(first, {"colour"}, Range{}), u, v);
        const double red = channel(first, u, v);
        if (!in_.isGiven(first + 1) && !in_.isGiven(first + 2)) return checked(Color(red), u, v);
        return checked({red, channel(first + 1, u, v), channel(first + 2, u, v)}, u, v);
    }

    std::vector<float> image(int side) {
        const std::size_t count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
        builder_.charge(count * sizeof(Texel));
        std::vector<float> samples;
        samples.reserve(3 * count);
        for (int row = 0; row < side; ++row) {
            for (int column = 0; column < side; ++column) {
                const Color c = at((column + 0.5) / side, 1.0 - (row + 0.5) / side);
                for (int i = 0; i < 3; ++i) samples.push_back(static_cast<float>(c[i]));
            }
        }
        return samples;
    }

  private:
    double channel(int slot, double u, double v) {
        if (in_.isNumber(slot)) return lua_tonumber(L_, slot);
        builder_.fail("the function must give three numbers, a table of them or one number (got " +
                      valueText(L_, slot) + " at " + place(u, v) + ")");
    }

    Color checked(const Color& c, double u, double v) {
        for (int i = 0; i < 3; ++i) {
            if (std::isfinite(static_cast<float>(c[i]))) continue;
            builder_.fail("the function must give finite numbers (got " + numberText(c[i]) +
                          " at " + place(u, v) + ")");
        }
        if (std::min({c.x, c.y, c.z}) >= 0.0) return c;
        builder_.warnOnce("negative-colour", "the function gives negative colours (at " +
                                                 place(u, v) + "), which count as 0");
        return glm::max(c, Color(0.0));
    }

    static std::string place(double u, double v) {
        return "u = " + numberText(u) + ", v = " + numberText(v);
    }

    lua_State* L_;
    SceneBuilder& builder_;
    Arguments in_;
    int function_;
};

/// Texel `index` of a row of n of a coarser image half as fine, before and after the finer one's
/// texel, and how far it lies between them.
struct Between {
    std::size_t before;
    std::size_t after;
    double part;

    Between(int fine, int coarseSide) {
        const double x = (fine + 0.5) / 2.0 - 0.5;
        const double cell = std::floor(x);
        before = static_cast<std::size_t>(std::max(cell, 0.0));
        after = static_cast<std::size_t>(std::min(cell + 1.0, coarseSide - 1.0));
        part = x - cell;
    }
};

/// Whether the coarse image's bilinear values are close to the fine one, of twice as many texels.
bool isClose(const std::vector<float>& coarse, int coarseSide, const std::vector<float>& fine) {
    const std::size_t width = static_cast<std::size_t>(coarseSide);
    for (int row = 0; row < 2 * coarseSide; ++row) {
        const Between down(row, coarseSide);
        for (int column = 0; column < 2 * coarseSide; ++column) {
            const Between across(column, coarseSide);
            const std::size_t texel =
                static_cast<std::size_t>(row) * 2 * width + static_cast<std::size_t>(column);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto value = [&](std::size_t r, std::size_t k) {
                    return static_cast<double>(coarse[3 * (r * width + k) + c]);
                };
                const double above = std::lerp(value(down.before, across.before),
                                               value(down.before, across.after), across.part);
                const double below = std::lerp(value(down.after, across.before),
                                               value(down.after, across.after), across.part);
                const double exact = static_cast<double>(fine[3 * texel + c]);
                const double error = std::fabs(std::lerp(above, below, down.part) - exact);
                if (error > kClose * std::max(exact, 1.0)) return false;
            }
        }
    }
    return true;
}

int neededSide(const SceneBuilder& builder) {
    int pixels = builder.settings().largestSide;
    if (pixels == 0) {
        for (const RenderDesc& render : builder.scene().renders) {
            pixels = std::max({pixels, render.width, render.height});
        }
    }
    int side = kFirstSide;
    while (side < pixels && side < kMostUnasked) side *= 2;
    return side;
}

BakedImage paintedAsNeeded(Painter& painter, int mostSide) {
    BakedImage image{kFirstSide, painter.image(kFirstSide)};
    while (image.side < mostSide) {
        BakedImage finer{2 * image.side, painter.image(2 * image.side)};
        const bool close = isClose(image.samples, image.side, finer.samples);
        image = std::move(finer);
        if (close) break;
    }
    return image;
}

}  // namespace

int keepFunction(lua_State* L, int slot) {
    lua_pushvalue(L, slot);
    return luaL_ref(L, LUA_REGISTRYINDEX);
}

void paintImages(lua_State* L, SceneBuilder& builder) {
    const int mostSide = neededSide(builder);
    // By number: a function may ask for further textures.
    for (std::size_t i = 0; i < builder.paintedImages().size(); ++i) {
        const PaintedImage wanted = builder.paintedImages()[i];
        builder.enterCall("texture", builder.scene().images[wanted.image].where);
        Painter painter(L, builder, wanted.function);
        BakedImage image = wanted.side > 0 ? BakedImage{wanted.side, painter.image(wanted.side)}
                                           : paintedAsNeeded(painter, mostSide);
        builder.setPainting(wanted.image, std::make_shared<const BakedImage>(std::move(image)));
    }
}

}  // namespace rt
