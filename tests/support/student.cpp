#include "student.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rt::test {

SampleMean sampleMean(const std::vector<double>& numbers) {
    if (numbers.size() < 2) throw std::logic_error("a standard error needs two numbers");
    SampleMean result;
    result.count = numbers.size();
    const auto n = static_cast<double>(numbers.size());
    // About the first number, so that equal ones leave exactly nothing.
    double sum = 0.0;
    for (const double x : numbers) sum += x - numbers.front();
    const double offset = sum / n;
    result.mean = numbers.front() + offset;
    double squares = 0.0;
    for (const double x : numbers) {
        const double d = x - numbers.front() - offset;
        squares += d * d;
    }
    result.standardError = std::sqrt(squares / (n - 1.0) / n);
    return result;
}

/// With t = sqrt(freedom) tan(a) the density becomes cos(a)^(freedom - 1), which is smooth.
double studentTail(double t, int freedom) {
    constexpr int kSteps = 4096;
    const double half = 0.5 * std::acos(-1.0);
    const double from = std::atan(std::fabs(t) / std::sqrt(static_cast<double>(freedom)));
    const auto integral = [&](double a, double b) {
        const double step = (b - a) / kSteps;
        double sum = 0.0;
        for (int i = 0; i <= kSteps; ++i) {
            const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
            sum += weight * std::pow(std::max(std::cos(a + i * step), 0.0), freedom - 1);
        }
        return sum * step / 3.0;
    };
    return integral(from, half) / integral(0.0, half);
}

double studentQuantile(double probability, int freedom) {
    double low = 0.0;
    double high = 1.0;
    while (studentTail(high, freedom) > probability) high *= 2.0;
    while (high - low > 1e-10 * high) {
        const double middle = 0.5 * (low + high);
        (studentTail(middle, freedom) > probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace rt::test
