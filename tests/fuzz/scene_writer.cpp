#include "scene_writer.h"

#include <cstdio>

namespace rt::fuzz {
namespace {

constexpr const char* kOddValues[] = {
    "0",   "-1", "1e-300", "1e300", "0/0",  "math.huge", "-math.huge", "nil",  "'word'",
    "'3'", "{}", "true",   "1e15",  "2^53", "-0.0",      "print",      "n[1]", "m[1]",
};
constexpr const char* kAxes[] = {"'x'", "'y'", "'z'", "'Z'"};
constexpr std::size_t kMostStatements = 64;

// The calls go through `try`, so that one that fails leaves the rest to be tried.
constexpr const char* kPrologue =
    "local n, m, l = {}, {}, {}\n"
    "local function try(f, ...) local ok, v = pcall(f, ...) if ok then return v end end\n"
    "n[1] = gr.node('root')\n"
    "m[1] = gr.material({0.6, 0.5, 0.4}, {0.3, 0.3, 0.3}, 20)\n"
    "l[1] = gr.light({3, 5, 6}, {0.8, 0.8, 0.8}, {1, 0, 0})\n";

}  // namespace

std::uint8_t SceneWriter::byte() {
    return next_ < bytes_.size() ? bytes_[next_++] : std::uint8_t{0};
}

std::string SceneWriter::oneOf(std::span<const char* const> words) {
    return words[below(words.size())];
}

std::string SceneWriter::number(double low, double high) {
    const std::uint8_t choice = byte();
    if (choice >= 240) return oneOf(kOddValues);
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", low + (high - low) * (choice / 239.0));
    return text;
}

std::string SceneWriter::vector(double low, double high) {
    const std::string x = number(low, high);
    const std::string y = number(low, high);
    return "{" + x + ", " + y + ", " + number(low, high) + "}";
}

/// Of whatever the nodes are: sheets, groups and the whole scene, too.
std::string SceneWriter::combined() {
    static constexpr const char* kCalls[] = {"gr.union", "gr.intersection", "gr.difference"};
    std::string text = oneOf(kCalls) + ", 's'";
    const std::size_t count = 2 + below(2);
    for (std::size_t i = 0; i < count; ++i) text += ", " + name('n');
    return text;
}

std::string SceneWriter::node() {
    switch (below(23)) {
        case 22: {
            std::string rows;
            const std::size_t columns = 2 + below(3);
            for (std::size_t j = 0; j < 2 + below(2); ++j) {
                rows += "{";
                for (std::size_t i = 0; i < columns; ++i) rows += number(0, 1) + ", ";
                rows += "}, ";
            }
            return "gr.height_field, 's', {" + rows + "}, {base = " + number(-1, 0) + "}";
        }
        case 21: {
            static constexpr const char* kTerms[] = {"xx", "yy", "zz", "xy", "yz",
                                                     "zx", "x",  "y",  "z",  "c"};
            std::string terms;
            const std::size_t count = 1 + below(6);
            for (std::size_t i = 0; i < count; ++i) {
                terms += oneOf(kTerms) + " = " + number(-2, 2) + ", ";
            }
            const std::string low = vector(-3, 0);
            return "gr.quadric, 's', {" + terms + "}, " + low + ", " + vector(0, 3);
        }
        case 19:
        case 20:
            return combined();
        case 0:
            return "gr.node, 'group'";
        case 1:
            return "gr.joint, 'joint', " + vector(-90, 90) + ", " + vector(-90, 90);
        case 2:
            return "gr.sphere, 's'";
        case 3:
            return "gr.cube, 's'";
        case 4:
            return "gr.cylinder, 's'";
        case 5:
            return "gr.cone, 's'";
        case 6: {
            const std::string radius = number(0, 2);
            return "gr.torus, 's', " + radius + ", " + number(0, 2);
        }
        case 7: {
            const std::string centre = vector(-3, 3);
            return "gr.nh_sphere, 's', " + centre + ", " + number(0, 2);
        }
        case 8: {
            const std::string corner = vector(-3, 3);
            return "gr.nh_box, 's', " + corner + ", " +
                   (below(2) == 0 ? number(0, 3) : vector(0, 3));
        }
        case 9:
        case 10: {
            const std::string kind = below(2) == 0 ? "gr.nh_cylinder" : "gr.nh_cone";
            const std::string base = vector(-3, 3);
            const std::string height = number(0, 3);
            return kind + ", 's', " + base + ", " + height + ", " + number(0, 2);
        }
        case 11: {
            const std::string centre = vector(-3, 3);
            const std::string radius = number(0, 2);
            return "gr.nh_torus, 's', " + centre + ", " + radius + ", " + number(0, 2);
        }
        case 12: {
            static constexpr const char* kUnit[] = {"gr.hemisphere, 's'", "gr.disc, 's'",
                                                    "gr.quad, 's'", "gr.plane, 's'"};
            return oneOf(kUnit);
        }
        case 13: {
            const std::string base = vector(-3, 3);
            const std::string height = number(0, 3);
            const std::string lower = number(0, 2);
            return "gr.nh_frustum, 's', " + base + ", " + height + ", " + lower + ", " +
                   number(0, 2);
        }
        case 14: {
            const std::string centre = vector(-3, 3);
            return "gr.nh_hemisphere, 's', " + centre + ", " + number(0, 2);
        }
        case 15: {
            const std::string centre = vector(-3, 3);
            const std::string normal = vector(-1, 1);
            return below(2) == 0
                       ? "gr.nh_plane, 's', " + centre + ", " + normal
                       : "gr.nh_disc, 's', " + centre + ", " + normal + ", " + number(0, 2);
        }
        case 16: {
            const std::string corner = vector(-3, 3);
            const std::string u = vector(-2, 2);
            return "gr.nh_quad, 's', " + corner + ", " + u + ", " + vector(-2, 2);
        }
        default: {
            std::string corners = vector(-2, 2);
            const std::size_t count = 2 + below(4);
            for (std::size_t i = 0; i < count; ++i) corners += ", " + vector(-2, 2);
            std::string faces = "{0, 1, 2}";
            if (count > 2) faces += ", {1, " + number(0, 3) + ", 3, 0}";
            return "gr.mesh, 's', {" + corners + "}, {" + faces + "}";
        }
    }
}

std::string SceneWriter::appearance() {
    const std::string diffuse = vector(0, 1);
    const std::string specular = vector(0, 1);
    return "gr.material, " + diffuse + ", " + specular + ", " + number(0, 100);
}

std::string SceneWriter::change() {
    const std::string of = ", " + name('n');
    switch (below(12)) {
        case 11:
            return "gr.spin" + of + ", '" + "xyz"[below(3)] + "', " + number(-720, 720);
        case 9:
            return "gr.move" + of + ", " + number(-2, 2) + ", " + number(-2, 2) + ", 0";
        case 0:
            return "gr.translate" + of + ", " + number(-3, 3) + ", " + number(-3, 3) + ", 0";
        case 1: {
            const std::string factor = number(0.1, 3);
            return "gr.scale" + of + ", " + factor + ", " + factor + ", " + number(-2, 2);
        }
        case 2:
            return "gr.rotate" + of + ", " + oneOf(kAxes) + ", " + number(-180, 180);
        case 3:
            return "gr.set_material" + of + ", " + name('m');
        case 4:
            return "gr.set_reflection" + of + ", " + number(0, 1);
        case 5:
            return "gr.set_refraction" + of + ", " + number(1, 2) + ", " + number(0, 1);
        case 6:
            return "gr.set_fresnel" + of + ", true";
        case 7:
            return "gr.set_absorption" + of + ", " + vector(0, 2);
        case 8:
            return "gr.set_texture" + of + ", try(" + (below(4) ? pattern() : painting()) + ")";
        default:
            return "gr.add_child" + of + ", " + name('n') + ", " + name('m');
    }
}

std::string SceneWriter::render() {
    const std::string eye = "{" + number(-1, 1) + ", " + number(-1, 1) + ", " + number(2, 9) + "}";
    const std::string ambient = vector(0, 0.5);
    const std::string focal =
        below(4) == 0 ? "try(gr.focal, " + number(1, 9) + ", 0.1, " + number(0, 0.5) + ")" : "nil";
    const std::string scene = number(10, 90) + ", " + ambient + ", l, " + focal + ")\n";
    const std::string options = below(4) == 3 ? "gr.options{caustics = true}\n" : "";
    return options + "try(gr.render, n[1], 'x.png', 6, 5, " + eye + ", {0, 0, -1}, {0, 1, 0}, " +
           scene;
}

std::string SceneWriter::statement() {
    switch (below(8)) {
        case 0:
        case 1: {
            const std::string to = name('n');
            const std::string appearance = name('m');
            return "try(gr.add_child, n[1], " + to + ", " + appearance + ")\n";
        }
        case 2: {
            const std::string to = name('n');
            return to + " = try(" + node() + ") or " + to + "\n";
        }
        case 3: {
            const std::string to = name('m');
            return to + " = try(" + appearance() + ") or " + to + "\n";
        }
        case 4: {
            const std::string to = name('l');
            if (below(2) == 0) return to + " = try(" + namedLight() + ") or " + to + "\n";
            const std::string place = vector(-9, 9);
            const std::string intensity = vector(0, 1);
            const std::string falloff = vector(0, 1);
            return to + " = try(gr.light, " + place + ", " + intensity + ", " + falloff + ", " +
                   number(0, 2) + ", " + number(0, 0.3) + ") or " + to + "\n";
        }
        case 5:
            return below(8) == 0 ? "try(gr.background, " + vector(0, 1) + ")\n"
                                 : "try(" + change() + ")\n";
        default:
            return "try(" + change() + ")\n";
    }
}

std::string SceneWriter::painting() {
    return "gr.texture, function(u, v) return u * " + number(-1, 9) + ", v, " + number(0, 1) +
           " end, {0.1, 0.2, 0.3}, 5" + (below(2) ? ", " + std::to_string(1 + below(40)) : "");
}

std::string SceneWriter::pattern() {
    static constexpr const char* kCalls[] = {"gr.checker", "gr.stripes", "gr.gradient",
                                             "gr.noise",   "gr.marble",  "gr.wood"};
    const std::size_t kind = below(6);
    const std::string first = vector(0, 1);
    const std::string second = vector(0, 1);
    std::string fields = "first = " + first + ", second = " + second + ", size = " + number(0, 2);
    const bool hasDirection = kind != 0 && kind != 3;
    if (hasDirection && below(2) == 0) fields += ", direction = " + vector(-1, 1);
    if (kind > 3 && below(2) == 0) fields += ", turbulence = " + number(0, 4);
    if (kind > 2 && below(2) == 0) fields += ", octaves = " + std::to_string(1 + below(16));
    return kCalls[kind] + std::string(", {") + fields + "}";
}

std::string SceneWriter::namedLight() {
    const std::string first = vector(-9, 9);
    const std::string second = vector(-2, 2);
    const std::string tail = "colour = " + vector(0, 1) + ", brightness = " + number(0, 0.3);
    switch (below(3)) {
        case 0: {
            const std::string inner = number(0, 40);
            return "gr.spot_light, {position = " + first + ", direction = " + second +
                   ", inner = " + inner + ", outer = " + number(30, 180) +
                   ", radius = " + number(0, 2) + ", " + tail + "}";
        }
        case 1:
            return "gr.sun_light, {direction = " + second + ", angle = " + number(0, 20) + ", " +
                   tail + "}";
        default: {
            const std::string v = vector(-2, 2);
            return "gr.rectangle_light, {corner = " + first + ", u = " + second + ", v = " + v +
                   ", falloff = " + vector(0, 1) + ", " + tail + "}";
        }
    }
}

std::string SceneWriter::script() {
    std::string text = kPrologue;
    for (std::size_t i = 0; i < kMostStatements && next_ < bytes_.size(); ++i) text += statement();
    return text + render();
}

}  // namespace rt::fuzz
