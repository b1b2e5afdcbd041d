// The words of one question, in order.
#pragma once

#include "rt/core/transform.h"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

namespace rt {

class Words {
  public:
    explicit Words(const std::string& line) : words_(line) {}

    /// Throws std::invalid_argument, as all here do, where there is none.
    std::string word() {
        std::string word;
        if (!(words_ >> word)) throw std::invalid_argument("too few words");
        return word;
    }
    /// Decimal or C hex float.
    double number() {
        const std::string word = this->word();
        char* end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0' || !std::isfinite(value)) {
            throw std::invalid_argument("not a finite number: " + word);
        }
        return value;
    }
    Vec3 vec() {
        const double x = number();
        const double y = number();
        const double z = number();
        return Vec3(x, y, z);
    }
    /// A whole number, not above `most`.
    Index count(const char* what, Index least, Index most) {
        const double value = number();
        if (value >= least && value <= most && value == std::floor(value)) {
            return static_cast<Index>(value);
        }
        throw std::invalid_argument(std::string(what) + ": a whole number from " +
                                    std::to_string(least) + " to " + std::to_string(most) +
                                    " is needed, got " + std::to_string(value));
    }
    /// 12 numbers, row by row.
    Affine map() {
        Affine map;
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) map.linear[column][row] = number();
            map.translation[row] = number();
        }
        return map;
    }
    void expectEnd() {
        std::string word;
        if (words_ >> word) throw std::invalid_argument("more than was expected: " + word);
    }

  private:
    std::istringstream words_;
};

}  // namespace rt
