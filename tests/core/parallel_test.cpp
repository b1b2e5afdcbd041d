#include "rt/core/parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

using namespace rt;

TEST_CASE("every index is worked on exactly once, for any number of threads") {
    for (const int threads : {0, 1, 2, 7, 64}) {
        std::vector<std::atomic<int>> seen(1000);
        std::atomic<bool> threadInRange{true};
        forEachIndex(seen.size(), threads, [&](std::size_t index, int thread) {
            ++seen[index];
            if (thread < 0 || thread >= std::max(threads, 1)) threadInRange = false;
        });
        for (const auto& count : seen) CHECK(count == 1);
        CHECK(threadInRange);
    }
}

TEST_CASE("an exception in a worker comes back to the caller, and the rest is left") {
    for (const int threads : {1, 4}) {
        std::atomic<int> done{0};
        CHECK_THROWS_WITH_AS(forEachIndex(1000000, threads,
                                          [&](std::size_t index, int) {
                                              if (index == 10)
                                                  throw std::runtime_error("the tenth");
                                              ++done;
                                          }),
                             "the tenth", std::runtime_error);
        CHECK(done < 1000000);
    }
}

TEST_CASE("no work needs no threads") {
    forEachIndex(0, 8, [](std::size_t, int) { FAIL("called"); });
    CHECK(availableThreads() >= 1);
}
