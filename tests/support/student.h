// Student's t-test of one mean: Student, The Probable Error of a Mean, Biometrika 6, 1908.
#pragma once

#include <cstddef>
#include <vector>

namespace rt::test {

/// Mean of independent numbers, and the standard error of that mean (0 where all are equal).
struct SampleMean {
    double mean = 0.0;
    double standardError = 0.0;
    std::size_t count = 0;
};

/// Needs at least two numbers.
SampleMean sampleMean(const std::vector<double>& numbers);

/// Probability that Student's t with `freedom` >= 1 degrees of freedom is farther from 0 than t, on
/// either side; to 1e-10.
double studentTail(double t, int freedom);

/// The t >= 0 that is exceeded, on either side, with this probability (1e-9 .. 1); to 1e-9
/// relative.
double studentQuantile(double probability, int freedom);

}  // namespace rt::test
