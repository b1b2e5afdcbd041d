#include "app/commands/checkpoint.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

using namespace rt;

namespace {

using Kind = CheckpointVerdict::Kind;

const std::vector<Trait> kTraits{{"the program's version", "1.0.0"},
                                 {"the scene's files", "123456"},
                                 {"--spp", "64"},
                                 {"--seed", ""}};

void fill(RenderLog& log) {
    log.rewind();
    log.beginStep();
    TraceCounts counts;
    counts.rays = {1, 2, 3, 4};
    counts.cutPaths = 5;
    counts.cutBound = 0.1;
    counts.nonFinite = 6;
    counts.nonFiniteX = 7;
    counts.nonFiniteY = 8;
    log.add(9, {counts, {10, 11, 12}});
    log.beginStep();
    log.beginStep();
    log.add(0, {{}, {}});
    log.add(1, {{}, {255}});
}

std::vector<std::uint8_t> encoded() {
    RenderLog log;
    fill(log);
    return encodeCheckpoint(kTraits, log);
}

CheckpointVerdict verdictOn(const std::vector<std::uint8_t>& bytes,
                            const std::vector<Trait>& traits = kTraits) {
    RenderLog log;
    return decodeCheckpoint(bytes, traits, log);
}

/// With one trait changed, or added.
std::vector<Trait> traitsWith(const std::string& name, const std::string& value) {
    std::vector<Trait> traits = kTraits;
    const auto found = std::find_if(traits.begin(), traits.end(),
                                    [&](const Trait& trait) { return trait.name == name; });
    if (found == traits.end()) {
        traits.push_back({name, value});
    } else {
        found->value = value;
    }
    return traits;
}

}  // namespace

TEST_CASE("a checkpoint gives back what went in") {
    RenderLog log;
    CHECK(decodeCheckpoint(encoded(), kTraits, log).kind == Kind::kFits);
    CHECK(encodeCheckpoint(kTraits, log) == encoded());
    log.rewind();
    log.beginStep();
    const RenderLog::Part* part = log.find(9);
    REQUIRE(part != nullptr);
    CHECK(part->values == std::vector<std::uint8_t>{10, 11, 12});
    CHECK(part->counts.rays.camera == 1);
    CHECK(part->counts.rays.refraction == 4);
    CHECK(part->counts.cutPaths == 5);
    CHECK(part->counts.cutBound == 0.1);
    CHECK(part->counts.nonFiniteY == 8);
    CHECK(log.find(0) == nullptr);
}

TEST_CASE("a checkpoint's first bytes are those of its layout") {
    const std::vector<std::uint8_t> bytes = encoded();
    const std::string start = "RTCHECK1\n" + std::string("\4\0\0\0\25\0\0\0", 8) +
                              "the program's version" + std::string("\5\0\0\0", 4) + "1.0.0";
    CHECK(std::string(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(start.size())) ==
          start);
}

TEST_CASE("a checkpoint cut short, or with any byte changed, is useless") {
    const std::vector<std::uint8_t> whole = encoded();
    for (std::size_t i = 0; i < whole.size(); ++i) {
        CAPTURE(i);
        std::vector<std::uint8_t> bytes(whole.begin(),
                                        whole.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK(verdictOn(bytes).kind == Kind::kUseless);
        bytes = whole;
        bytes[i] ^= 0x10;
        CHECK(verdictOn(bytes).kind == Kind::kUseless);
    }
    std::vector<std::uint8_t> longer = whole;
    longer.push_back(0);
    CHECK(verdictOn(longer).kind == Kind::kUseless);
}

TEST_CASE("what is no checkpoint is told from one of another version and a damaged one") {
    std::vector<std::uint8_t> bytes = encoded();
    bytes[bytes.size() / 2] ^= 1;
    CHECK(verdictOn(bytes).why == "is damaged");
    bytes = encoded();
    bytes[7] = '2';
    CHECK(isCheckpoint(bytes));
    CHECK(verdictOn(bytes).why == "is of another version of this program");
    CHECK(verdictOn(encoded(), traitsWith("the program's version", "1.1.0")).kind ==
          Kind::kUseless);
    bytes[0] = 'r';
    CHECK(!isCheckpoint(bytes));
    CHECK(verdictOn(bytes).why == "is not a checkpoint");
    CHECK(verdictOn({}).kind == Kind::kUseless);
}

TEST_CASE("a checkpoint of another picture is refused with what differs") {
    const auto why = [](const std::vector<Trait>& traits) {
        const CheckpointVerdict verdict = verdictOn(encoded(), traits);
        CHECK(verdict.kind == Kind::kOther);
        return verdict.why;
    };
    CHECK(why(traitsWith("--spp", "65")) == "is of another picture: --spp was 64, and is 65");
    CHECK(why(traitsWith("--seed", "7")) == "is of another picture: --seed was not set, and is 7");
    CHECK(why(traitsWith("-D x", "7")) == "is of another picture: -D x was not set, and is 7");
    CHECK(why(traitsWith("the scene's files", "9")) ==
          "is of another picture: the scene's files are not the same");
    std::vector<Trait> fewer = kTraits;
    fewer.erase(fewer.begin() + 2);
    CHECK(why(fewer) == "is of another picture: --spp was 64, and is not set");
}

TEST_CASE("a refused checkpoint leaves the log alone") {
    RenderLog log;
    fill(log);
    const std::vector<std::uint8_t> before = encodeCheckpoint(kTraits, log);
    CHECK(decodeCheckpoint(encoded(), traitsWith("--spp", "1"), log).kind == Kind::kOther);
    CHECK(encodeCheckpoint(kTraits, log) == before);
}

TEST_CASE("a checkpoint lies beside its image") {
    CHECK(checkpointName("a/x.png") == "a/x.checkpoint");
    CHECK(checkpointName("x.2-of-4.part") == "x.2-of-4.checkpoint");
    CHECK(checkpointName("x") == "x.checkpoint");
}
