#include "rt/render/adaptive.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace rt;

namespace {

/// A film whose pixels have `samples` samples of mean `value` each.
Film flatFilm(int width, int height, double value, std::uint64_t samples) {
    Film film(Tile{0, 0, width, height});
    for (PixelState& pixel : film.pixels) {
        pixel.samples = samples;
        pixel.sum = Color(value * static_cast<double>(samples));
        pixel.half = Color(value * static_cast<double>(samples / 2));
    }
    return film;
}

/// Moves the halves of a pixel apart by `difference`, its mean staying what it is.
void disagree(PixelState& pixel, double difference) {
    pixel.half += Color(0.5 * difference * static_cast<double>(pixel.samples / 2));
}

AdaptiveGoal goalOf(double target) {
    AdaptiveGoal goal;
    goal.squaredTarget = target * target;
    return goal;
}

double estimate(Film& film) {
    Adaptive adaptive(film, nullptr, {});
    adaptive.update();
    return std::sqrt(adaptive.squaredError());
}

std::vector<std::uint32_t> nextSamples(Film& film, const AdaptiveGoal& goal) {
    Adaptive adaptive(film, nullptr, {});
    adaptive.update();
    return adaptive.next(goal).pixels;
}

/// Probes of one surface, colour(x, y) at each corner.
template <class Colour>
Lattice latticeOf(int width, int height, Colour&& colour) {
    Lattice lattice(Tile{0, 0, width, height});
    for (int y = 0; y <= height; ++y) {
        for (int x = 0; x <= width; ++x) {
            Probe& probe = lattice.probes[lattice.offset(x, y)];
            probe.samples = 2;
            probe.sum = glm::vec3(static_cast<float>(2.0 * colour(x, y)));
            probe.half = 0.5F * probe.sum;
        }
    }
    return lattice;
}

}  // namespace

TEST_CASE("halves that agree estimate no error") {
    Film film = flatFilm(5, 4, 0.3, 8);
    CHECK(estimate(film) == doctest::Approx(0.0));
}

TEST_CASE("the estimate is half of what the halves differ by, pooled over the neighbours") {
    Film film = flatFilm(5, 5, 0.5, 8);
    disagree(film.at(2, 2), 0.2);  // halves at 0.6 and 0.4
    Adaptive adaptive(film, nullptr, {});
    adaptive.update();
    CHECK(adaptive.squaredErrorAt(film.offset(2, 2)) == doctest::Approx(0.01 / 9));
    CHECK(adaptive.squaredErrorAt(film.offset(1, 1)) == doctest::Approx(0.01 / 9));
    CHECK(adaptive.squaredErrorAt(film.offset(0, 0)) == doctest::Approx(0.0));
    CHECK(adaptive.squaredErrorAt(film.offset(4, 2)) == doctest::Approx(0.0));
}

TEST_CASE("a corner of the image pools over the four pixels that there are") {
    Film film = flatFilm(5, 5, 0.5, 8);
    disagree(film.at(0, 0), 0.2);
    Adaptive adaptive(film, nullptr, {});
    adaptive.update();
    CHECK(adaptive.squaredErrorAt(0) == doctest::Approx(0.01 / 4));
}

TEST_CASE("beyond full nothing can be seen to differ") {
    Film film = flatFilm(3, 3, 5.0, 8);
    disagree(film.at(1, 1), 2.0);
    CHECK(estimate(film) == doctest::Approx(0.0));
}

TEST_CASE("an image that meets the goal and has no contrast gets no more samples") {
    Film film = flatFilm(6, 6, 0.5, 8);
    for (const std::uint32_t end : nextSamples(film, goalOf(0.01))) CHECK(end == 8);
}

TEST_CASE("samples go where the error is, and a pixel never loses any") {
    Film film = flatFilm(20, 20, 0.5, 8);
    for (int y = 8; y < 12; ++y) {
        for (int x = 8; x < 12; ++x) disagree(film.at(x, y), 0.4);
    }
    const auto ends = nextSamples(film, goalOf(0.005));
    CHECK(ends[film.offset(10, 10)] > 8);
    CHECK(ends[film.offset(0, 0)] == 8);
    for (const std::uint32_t end : ends) CHECK((end == 8 || end == 16 || end == 32));
}

TEST_CASE("contrast to the neighbours puts a pixel in doubt although its halves agree") {
    Film film = flatFilm(20, 20, 0.2, 8);
    disagree(film.at(3, 3), 0.4);  // something to gain at all
    film.at(15, 15).sum = Color(8.0);
    film.at(15, 15).half = Color(4.0);
    const auto ends = nextSamples(film, goalOf(0.001));
    CHECK(ends[film.offset(15, 15)] > 8);
    CHECK(ends[film.offset(14, 16)] > 8);
    CHECK(ends[film.offset(10, 4)] == 8);
}

TEST_CASE("no pixel gets more than the most, and then there is nothing left to do") {
    Film film = flatFilm(4, 4, 0.5, 64);
    for (PixelState& pixel : film.pixels) disagree(pixel, 0.9);
    AdaptiveGoal goal = goalOf(1e-6);
    goal.maxSamples = 100;
    for (const std::uint32_t end : nextSamples(film, goal)) CHECK(end == 64);
    goal.maxSamples = 128;
    for (const std::uint32_t end : nextSamples(film, goal)) CHECK(end == 128);
}

TEST_CASE("a smooth pixel is the mean over its square, to the third order") {
    // f = 0.3 + 0.02 x + 0.01 y + 0.003 x^2 + 0.002 x y + 0.001 y^2, whose mean over a pixel is
    // known.
    const auto f = [](double x, double y) {
        return 0.3 + 0.02 * x + 0.01 * y + 0.003 * x * x + 0.002 * x * y + 0.001 * y * y;
    };
    const Lattice lattice = latticeOf(6, 5, f);
    Film film(Tile{0, 0, 6, 5});
    Adaptive adaptive(film, &lattice, {});
    adaptive.classify(1.0, {});
    adaptive.update();
    adaptive.settle();
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 6; ++x) {
            const double mean = f(x + 0.5, y + 0.5) + (0.003 + 0.001) / 12.0;
            CHECK(film.at(x, y).mean().x == doctest::Approx(mean).epsilon(1e-6));
        }
    }
}

TEST_CASE("pixels are sampled where surfaces, sharp shadows, detail or folds come between") {
    const auto grey = [](double, double) { return 0.5; };
    const auto sampledNear = [&](auto&& change) {
        Lattice lattice = latticeOf(8, 8, grey);
        change(lattice);
        Film film(Tile{0, 0, 8, 8});
        Adaptive adaptive(film, &lattice, {});
        adaptive.classify(1.0, {});
        const AdaptivePass pass = adaptive.first(4);
        CHECK(pass.pixels[film.offset(0, 0)] <= 1);
        return pass.pixels[film.offset(4, 4)] == 4;
    };
    CHECK_FALSE(sampledNear([](Lattice&) {}));
    CHECK(sampledNear([](Lattice& l) { l.probes[l.offset(4, 4)].surfaces = 9; }));
    CHECK(sampledNear([](Lattice& l) { l.probes[l.offset(5, 5)].marks |= kProbeDetail; }));
    CHECK(sampledNear([](Lattice& l) {
        l.probes[l.offset(5, 4)].lit = 2;
        l.probes[l.offset(4, 5)].dark = 2;
    }));
    CHECK(sampledNear([](Lattice& l) {
        for (Probe& probe : l.probes) {
            probe.marks |= kProbeHit;
            probe.normal = glm::vec3(0, 0, 1);
        }
        l.probes[l.offset(5, 5)].normal = glm::vec3(0, 0.6F, 0.8F);
    }));
}

TEST_CASE("an uncertain corner's variance counts a sixteenth in each smooth pixel around it") {
    Lattice lattice = latticeOf(8, 8, [](double, double) { return 0.5; });
    Probe& probe = lattice.probes[lattice.offset(4, 4)];
    probe.marks |= kProbeUncertain;
    probe.half = glm::vec3(0.4F);
    probe.sum = glm::vec3(1.0F);  // halves at 0.4 and 0.6: variance 0.01
    Film film(Tile{0, 0, 8, 8});
    Adaptive adaptive(film, &lattice, {});
    adaptive.classify(1.0, {});
    adaptive.update();
    CHECK(adaptive.squaredErrorAt(film.offset(4, 4)) == doctest::Approx(0.01 / 16).epsilon(0.01));
    CHECK(adaptive.squaredErrorAt(film.offset(3, 3)) == doctest::Approx(0.01 / 16).epsilon(0.01));
    const AdaptivePass pass = adaptive.next(goalOf(0.001));
    CHECK(pass.corners[lattice.offset(4, 4)] > 2);
    CHECK(pass.corners[lattice.offset(2, 2)] <= 2);
}

TEST_CASE("an error is known only where corners were classified and pixels have two halves") {
    Film single = flatFilm(4, 4, 0.5, 1);
    CHECK_FALSE(Adaptive(single, nullptr, {}).knowsError());
    Film halves = flatFilm(4, 4, 0.5, 2);
    CHECK(Adaptive(halves, nullptr, {}).knowsError());
    halves.at(2, 1).samples = 1;
    CHECK_FALSE(Adaptive(halves, nullptr, {}).knowsError());

    const Lattice lattice = latticeOf(4, 4, [](double, double) { return 0.5; });
    Film film(Tile{0, 0, 4, 4});
    Adaptive adaptive(film, &lattice, {});
    CHECK_FALSE(adaptive.knowsError());
    adaptive.classify(1.0, {});
    CHECK(adaptive.knowsError());
}

TEST_CASE("a render that stopped while it looked through corners keeps what it saw") {
    Lattice lattice = latticeOf(4, 4, [](double x, double) { return 0.1 * x; });
    for (int x = 0; x <= 4; ++x) {
        for (int y = 2; y <= 4; ++y) lattice.probes[lattice.offset(x, y)] = {};
    }
    Film film(Tile{0, 0, 4, 4});
    Adaptive adaptive(film, &lattice, {});
    adaptive.update();
    adaptive.settle();
    CHECK(film.at(2, 0).mean().x == doctest::Approx(0.25));
    CHECK(film.at(2, 1).mean().x == doctest::Approx(0.25));  // from its two upper corners
    CHECK(film.at(2, 2).samples == 0);
}

TEST_CASE("each pixel has its turn in one of sixteen audits") {
    const Lattice lattice = latticeOf(9, 7, [](double, double) { return 0.5; });
    Film film(Tile{0, 0, 9, 7});
    Adaptive adaptive(film, &lattice, {});
    CHECK_FALSE(adaptive.wantsAudit(1e-6));
    adaptive.classify(1.0, {});
    CHECK(adaptive.wantsAudit(1e-6));
    std::vector<int> turns(film.pixels.size());
    for (int round = 0; round < 16; ++round) {
        const std::vector<std::size_t> pixels = adaptive.nextAudit();
        CHECK(pixels.size() < 16);
        for (const std::size_t pixel : pixels) ++turns[pixel];
    }
    for (const int turn : turns) CHECK(turn == 1);
    CHECK(adaptive.nextAudit().empty());
    CHECK_FALSE(adaptive.wantsAudit(1e-6));
}

TEST_CASE(
    "what centres show and corners missed is sampled, counts for all, and its neighbours too") {
    const Lattice lattice = latticeOf(16, 16, [](double, double) { return 0.2; });
    Film film(Tile{0, 0, 16, 16});
    Adaptive adaptive(film, &lattice, {});
    adaptive.classify(1.0, {});
    const std::vector<std::size_t> pixels = adaptive.nextAudit();
    std::vector<Probe> centres(pixels.size());
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const PixelPlace place = film.area.placeOf(pixels[i]);
        const bool inside = place.x > 3 && place.x < 12 && place.y > 3 && place.y < 12;
        if (inside && wrong == 0) wrong = pixels[i];
        centres[i].samples = 2;
        centres[i].sum = glm::vec3(pixels[i] == wrong && wrong != 0 ? 1.6F : 0.4F);
    }
    const AdaptiveGoal goal = goalOf(0.001);
    adaptive.judgeAudit(centres, goal.squaredTarget);
    CHECK(adaptive.wantsAudit(goal.squaredTarget));
    AdaptivePass pass = adaptive.first(goal.firstSamples);
    CHECK(pass.pixels[wrong] == goal.firstSamples);
    CHECK(pass.more == goal.firstSamples);
    // The same where the audit falls between two later passes.
    pass = adaptive.next(goal);
    CHECK(pass.pixels[wrong] == goal.firstSamples);
    film.pixels[wrong] = {Color(4 * 0.7), Color(2 * 0.7), 4};
    adaptive.update();
    // A quarter of 0.6^2 for the missed, of 0.5^2 for each of eight neighbours.
    const double missed = 0.25 * 0.36 / static_cast<double>(pixels.size()) * 15 / 16 * 255 / 256;
    CHECK(adaptive.squaredError() == doctest::Approx(missed + 8 * 0.25 * 0.25 / 256).epsilon(1e-4));
    pass = adaptive.next(goal);
    CHECK(pass.pixels[wrong - 1] == goal.firstSamples);
    CHECK(pass.pixels[wrong + 17] == goal.firstSamples);
    CHECK(pass.pixels[wrong + 2] <= 1);
}

TEST_CASE("corners of a noisy shadow count in sixteen pixels where it is even") {
    Lattice lattice = latticeOf(12, 12, [](double, double) { return 0.5; });
    for (Probe& probe : lattice.probes) {
        probe.marks |= kProbeUncertain;
        probe.half = glm::vec3(0.4F);  // halves at 0.4 and 0.6: variance 0.01
    }
    Film film(Tile{0, 0, 12, 12});
    Adaptive adaptive(film, &lattice, {});
    adaptive.classify(1.0, {});
    adaptive.update();
    CHECK(adaptive.squaredErrorAt(film.offset(6, 6)) == doctest::Approx(0.01 / 16).epsilon(0.01));
    CHECK(adaptive.squaredErrorAt(film.offset(0, 0)) == doctest::Approx(0.01 / 4).epsilon(0.01));
}

TEST_CASE("where a shadow curves more than its noise, sixteen corners are too many") {
    Lattice lattice = latticeOf(12, 12, [](double x, double) { return 0.02 * x * x; });
    for (Probe& probe : lattice.probes) {
        probe.marks |= kProbeUncertain;
        probe.half = 0.5F * probe.sum - glm::vec3(0.01F);  // variance 0.0001
    }
    Film film(Tile{0, 0, 12, 12});
    Adaptive adaptive(film, &lattice, {});
    adaptive.classify(1.0, {});
    adaptive.update();
    CHECK(adaptive.squaredErrorAt(film.offset(6, 6)) == doctest::Approx(0.0001 / 4).epsilon(0.01));
    adaptive.settle();
    const double corners = 0.02 * (36.0 + 49.0) / 2.0;
    CHECK(film.at(6, 6).mean().x == doctest::Approx(corners).epsilon(1e-6));
}
