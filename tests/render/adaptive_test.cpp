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

}  // namespace

TEST_CASE("halves that agree estimate no error") {
    CHECK(rootMean(squaredErrors(flatFilm(5, 4, 0.3, 8))) == doctest::Approx(0.0));
}

TEST_CASE("the estimate is half of what the halves differ by, pooled over the neighbours") {
    Film film = flatFilm(5, 5, 0.5, 8);
    disagree(film.at(2, 2), 0.2);  // halves at 0.6 and 0.4
    const std::vector<double> errors = squaredErrors(film);
    CHECK(errors[film.offset(2, 2)] == doctest::Approx(0.01 / 9));
    CHECK(errors[film.offset(1, 1)] == doctest::Approx(0.01 / 9));
    CHECK(errors[film.offset(0, 0)] == doctest::Approx(0.0));
    CHECK(errors[film.offset(4, 2)] == doctest::Approx(0.0));
}

TEST_CASE("a corner pools over the four pixels that there are") {
    Film film = flatFilm(5, 5, 0.5, 8);
    disagree(film.at(0, 0), 0.2);
    CHECK(squaredErrors(film)[0] == doctest::Approx(0.01 / 4));
}

TEST_CASE("beyond full nothing can be seen to differ") {
    Film film = flatFilm(3, 3, 5.0, 8);
    disagree(film.at(1, 1), 2.0);
    CHECK(rootMean(squaredErrors(film)) == doctest::Approx(0.0));
}

TEST_CASE("an image that meets the goal and has no contrast gets no more samples") {
    const Film film = flatFilm(6, 6, 0.5, 8);
    for (const std::uint32_t end : nextSamples(film, squaredErrors(film), goalOf(0.01))) {
        CHECK(end == 8);
    }
}

TEST_CASE("samples go where the error is, and a pixel never loses any") {
    Film film = flatFilm(20, 20, 0.5, 8);
    for (int y = 8; y < 12; ++y) {
        for (int x = 8; x < 12; ++x) disagree(film.at(x, y), 0.4);
    }
    const auto ends = nextSamples(film, squaredErrors(film), goalOf(0.005));
    CHECK(ends[film.offset(10, 10)] == 16);
    CHECK(ends[film.offset(0, 0)] == 8);
    for (const std::uint32_t end : ends) CHECK((end == 8 || end == 16));
}

TEST_CASE("contrast to the neighbours puts a pixel in doubt although its halves agree") {
    Film film = flatFilm(20, 20, 0.2, 8);
    disagree(film.at(3, 3), 0.4);  // something to gain at all
    film.at(15, 15).sum = Color(8.0);
    film.at(15, 15).half = Color(4.0);
    const auto ends = nextSamples(film, squaredErrors(film), goalOf(0.001));
    CHECK(ends[film.offset(15, 15)] == 16);
    CHECK(ends[film.offset(14, 16)] == 16);
    CHECK(ends[film.offset(10, 4)] == 8);
}

TEST_CASE("no pixel gets more than the most, and then there is nothing left to do") {
    Film film = flatFilm(4, 4, 0.5, 64);
    for (PixelState& pixel : film.pixels) disagree(pixel, 0.9);
    AdaptiveGoal goal = goalOf(1e-6);
    goal.maxSamples = 100;
    for (const std::uint32_t end : nextSamples(film, squaredErrors(film), goal)) CHECK(end == 64);
    goal.maxSamples = 128;
    for (const std::uint32_t end : nextSamples(film, squaredErrors(film), goal)) CHECK(end == 128);
}
