// What is cut for speed: the difference to the whole truth stays below the bound that is reported.
#include "optics_shot.h"

#include <algorithm>
#include <random>

using namespace rt;
using namespace rt::test;

namespace {

double largestDifference(const Color& a, const Color& b) {
    const Color d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

/// Mirrors, glass and lights at random in a room, and a camera anywhere in it.
class RandomRoom {
  public:
    explicit RandomRoom(unsigned seed) : random_(seed) {
        body_ = "gr.background(" + color(2.0) + ", " + color(2.0) + ")\n";
        if (seed % 2 == 0) {
            add("gr.nh_box('room', {-6, -6, -6}, 12)", "it:set_reflection(" + unit() + ")");
        }
        for (int i = 0; i < 9; ++i) {
            const std::string place = text(Vec3(within(-4, 4), within(-4, 4), within(-4, 4)));
            const std::string size = text(within(0.5, 2.0));
            const char* const solids[] = {"gr.nh_sphere('s', ", "gr.nh_box('s', "};
            const std::string calls[] = {
                "it:set_reflection(" + unit() + ")",
                "it:set_refraction(" + text(within(0.7, 2.5)) + ", " + unit() + ")",
                "it:set_refraction(1.5, " + unit() + ")\nit:set_fresnel(true)\nit:set_reflection(" +
                    unit() + ")",
                ""};
            add(solids[random_() % 2] + place + ", " + size + ")", calls[random_() % 4]);
        }
        for (int i = 0; i < 3; ++i) {
            const Vec3 at(within(-5, 5), within(-5, 5), within(-5, 5));
            body_ += "lights[#lights + 1] = gr.light(" + text(at) + ", " + color(1.5) + ", {" +
                     text(within(0.1, 1.0)) + ", " + unit() + ", 0}, " +
                     (i == 0 ? "0" : text(within(0, 2))) + ", " + (i == 1 ? unit() : "0") + ")\n";
        }
    }

    Shot view() {
        Shot shot;
        shot.body = body_;
        shot.eye = {within(-5, 5), within(-5, 5), within(-5, 5)};
        shot.view = {within(-1, 1), within(-1, 1), within(0.1, 1)};
        shot.ambient = Color(0.2);
        shot.fov = 60.0;
        return shot;
    }

  private:
    double within(double low, double high) {
        return low + (high - low) * (static_cast<double>(random_() % 100000) / 100000.0);
    }
    std::string unit() { return text(within(0, 1)); }
    std::string color(double most) {
        return text(Vec3(within(0, most), within(0, most), within(0, most)));
    }
    void add(const std::string& node, const std::string& calls) {
        body_ += "it = " + node + "\n" + calls + "\nroot:add_child(it, gr.material(" + color(1.0) +
                 ", " + color(1.0) + ", " + text(within(0, 20)) + "))\n";
    }

    std::mt19937 random_;
    std::string body_;
};

/// A closed room with mirror balls in it, lit by two lights.
Shot mirrorRoom() {
    Shot shot;
    shot.body = place("gr.nh_box('room', {-5, -5, -5}, 10)", 0.7, "it:set_reflection(0.6)") +
                "lights[1] = gr.light({0, 4, 0}, {0.6, 0.5, 0.4}, {1, 0, 0})\n"
                "lights[2] = gr.light({-3, 0, 4}, {0.2, 0.3, 0.4}, {1, 0, 0})\n";
    for (int i = 0; i < 5; ++i) {
        const Vec3 centre(-3.0 + 1.5 * i, std::sin(2.0 * i), std::cos(3.0 * i) - 1.0);
        shot.body += place("gr.nh_sphere('ball', " + text(centre) + ", 0.8)", 0.2 * i,
                           "it:set_reflection(" + text(0.1 + 0.1 * i) + ")");
    }
    shot.eye = {0.5, 0.2, 4.5};
    shot.fov = 70.0;
    shot.width = 24;
    shot.height = 24;
    shot.ambient = Color(0.1);
    return shot;
}

}  // namespace

TEST_CASE("what the cutoff changes stays below the bound that is reported") {
    const int spp = 4;
    RenderOptions whole;
    whole.reference = true;
    const Picture truth = shoot(mirrorRoom(), spp, whole);
    CHECK(truth.counts.cutPaths == 0);
    CHECK(truth.counts.cutBound == 0.0);
    for (const double cutoff : {0.5, 1.0 / 16, 1.0 / 256, 1.0 / 2048}) {
        CAPTURE(cutoff);
        RenderOptions options;
        options.cutoff = cutoff;
        const Picture cut = shoot(mirrorRoom(), spp, options);
        CHECK(cut.counts.cutPaths > 0);
        double difference = 0.0;
        for (std::size_t i = 0; i < cut.pixels.size(); ++i) {
            difference += largestDifference(cut.pixels[i], truth.pixels[i]);
        }
        difference /= static_cast<double>(cut.pixels.size());
        const double bound = cut.counts.cutBound / static_cast<double>(cut.counts.rays.camera);
        CAPTURE(difference);
        CAPTURE(bound);
        CHECK(difference > 0.0);
        CHECK(difference <= bound);
    }
}

TEST_CASE("sample by sample, what the cutoff changes stays below its bound, in random rooms") {
    int cut = 0;
    for (unsigned seed = 1; seed <= 24; ++seed) {
        RandomRoom room(seed);
        for (int view = 0; view < 12; ++view) {
            const Shot shot = room.view();
            // Few bounces keep the whole tree of paths small; the filters weigh samples
            // differently.
            RenderOptions options;
            options.maxDepth = 7;
            options.cutoff = 0.0;
            options.filter = view % 2 == 0 ? "box" : "mitchell";
            const Picture truth = shoot(shot, 1, options);
            CHECK(truth.counts.cutPaths == 0);
            for (const double cutoff : {0.4, 0.03, 1.0 / 2048}) {
                CAPTURE(seed);
                CAPTURE(view);
                CAPTURE(cutoff);
                options.cutoff = cutoff;
                const Picture picture = shoot(shot, 1, options);
                const double off = largestDifference(picture.at(0, 0), truth.at(0, 0));
                CHECK(off <= picture.counts.cutBound * (1.0 + 1e-12));
                if (picture.counts.cutPaths == 0) continue;
                ++cut;
            }
        }
    }
    CHECK(cut > 200);
}

TEST_CASE("where the sky is all there is the bound is met exactly, under every filter") {
    // Half of a white sky is cut, and a black mirror's own colour stands for it.
    Shot shot;
    shot.body =
        "gr.background({1, 1, 1})\n" +
        place("gr.nh_box('mirror', {-50, -50, -1}, {100, 100, 1})", 0.0, "it:set_reflection(0.5)");
    for (const char* filter : {"box", "gaussian", "mitchell", "blackman-harris"}) {
        CAPTURE(filter);
        RenderOptions options;
        options.filter = filter;
        options.cutoff = 0.9;
        const Picture cut = shoot(shot, 1, options);
        options.cutoff = 0.0;
        const double off = largestDifference(cut.at(0, 0), shoot(shot, 1, options).at(0, 0));
        CHECK(off > 0.0);
        CHECK(off == doctest::Approx(cut.counts.cutBound).epsilon(1e-14));
    }
}

TEST_CASE("colours below zero are within the bound as well") {
    // An own colour of 0.9 stands for a quarter of a sky of -1.
    Shot shot;
    shot.body =
        place("gr.nh_box('mirror', {-50, -50, -1}, {100, 100, 1})", 0.9, "it:set_reflection(0.75)");
    shot.ambient = Color(1.0);
    Shot dark = shot;
    dark.body += "gr.background({-1, -1, -1})\n";
    Shot mirroredDark = shot;
    mirroredDark.ambient = Color(-1.0);
    mirroredDark.body += "gr.background({0.9, 0.9, 0.9})\n";
    for (const Shot& each : {dark, mirroredDark}) {
        RenderOptions options;
        options.cutoff = 1.0;
        const Picture cut = shoot(each, 1, options);
        CHECK(cut.counts.cutPaths == 1);
        CHECK(std::fabs(cut.at(0, 0).x - grey(each)) <= cut.counts.cutBound);
    }
}

TEST_CASE("a sample's rays beyond 4096 are cut, always the same, and booked in the error") {
    Shot shot;
    shot.body = "gr.background({1, 1, 1})\n";
    for (int i = 0; i < 20; ++i) {
        shot.body +=
            place("gr.nh_box('pane', {-500, -500, " + text(-0.2 * i) + "}, {1000, 1000, 0.1})",
                  0.05 * (i % 3), "it:set_refraction(2.4, 0.05)\nit:set_fresnel(true)");
    }
    shot.fov = 20.0;
    shot.width = 2;
    shot.ambient = Color(0.5);
    RenderOptions options;
    options.cutoff = 0.0;
    options.maxDepth = 14;
    const Picture cut = shoot(shot, 2, options);
    options.reference = true;
    const Picture truth = shoot(shot, 2, options);
    CHECK(truth.counts.cutPaths == 0);
    CHECK(truth.counts.rays.reflection + truth.counts.rays.refraction > 4u * 4096u);
    CHECK(cut.counts.cutPaths > 0);
    CHECK(cut.counts.rays.reflection + cut.counts.rays.refraction == 4u * 4096u);
    double off = 0.0;
    for (int x = 0; x < 2; ++x) off += 0.5 * largestDifference(cut.at(x, 0), truth.at(x, 0));
    const double bound = cut.counts.cutBound / 4.0;
    CHECK(off > 0.0);
    CHECK(off <= bound);
    CHECK(cut.errorEstimate.value() >= bound);
    options.reference = std::nullopt;
    CHECK(sameBytes(shoot(shot, 2, options), cut));
}
