// What the fuzzers found worth keeping, and what once crashed, without a fuzzer.
#include "targets.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

using namespace rt::fuzz;

namespace {

std::vector<std::filesystem::path> corpusOf(const std::string& target) {
    const std::filesystem::path folder = std::filesystem::path("tests/fuzz/corpus") / target;
    REQUIRE_MESSAGE(std::filesystem::is_directory(folder), "run from the top folder");
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<std::uint8_t> bytesOf(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_CASE("The fuzzers' corpora run clean") {
    for (const Target& target : targets()) {
        const auto files = corpusOf(target.name);
        CHECK(!files.empty());
        for (const auto& file : files) {
            CAPTURE(file.string());
            target.run(bytesOf(file));
        }
    }
}

TEST_CASE("Corpora with bytes changed run clean") {
    std::mt19937 random(1);
    const auto below = [&](std::size_t n) { return random() % n; };
    for (const Target& target : targets()) {
        const auto files = corpusOf(target.name);
        for (int round = 0; round < 60; ++round) {
            std::vector<std::uint8_t> bytes = bytesOf(files[below(files.size())]);
            for (std::size_t i = 0; i < 4 && !bytes.empty(); ++i) {
                bytes[below(bytes.size())] = static_cast<std::uint8_t>(below(256));
            }
            if (below(3) == 0) bytes.resize(bytes.size() - below(bytes.size() + 1));
            target.run(bytes);
        }
    }
}

}  // namespace
