// The t-test that the tests of estimators lean on, against printed tables.
#include "support/student.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace rt::test;

TEST_CASE("Student's quantiles are those of the tables") {
    // Abramowitz and Stegun, Handbook of Mathematical Functions, 1964, table 26.10.
    struct Row {
        int freedom;
        double probability;
        double t;
    };
    for (const Row& row : {Row{1, 0.5, 1.000}, Row{1, 0.05, 12.706}, Row{2, 0.01, 9.925},
                           Row{4, 0.02, 3.747}, Row{10, 0.05, 2.228}, Row{30, 0.01, 2.750},
                           Row{30, 0.001, 3.646}, Row{120, 0.05, 1.980}}) {
        CAPTURE(row.freedom);
        CAPTURE(row.probability);
        CHECK(std::fabs(studentQuantile(row.probability, row.freedom) - row.t) < 6e-4);
    }
    // One degree of freedom is Cauchy's distribution.
    for (const double t : {0.1, 1.0, 7.0, 1e3}) {
        CHECK(std::fabs(studentTail(t, 1) - (1.0 - 2.0 / std::acos(-1.0) * std::atan(t))) < 1e-10);
    }
}

TEST_CASE("a mean's standard error is the scatter of the numbers over the root of their count") {
    const SampleMean some = sampleMean({1.0, 2.0, 4.0, 5.0});
    CHECK(some.mean == 3.0);
    CHECK(some.standardError == doctest::Approx(std::sqrt(10.0 / 3.0 / 4.0)).epsilon(1e-15));
    const SampleMean equal = sampleMean({0.1, 0.1, 0.1});
    CHECK(equal.mean == 0.1);
    CHECK(equal.standardError == 0.0);
}
