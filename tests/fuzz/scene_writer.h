// Scripts out of bytes: a grammar of the scene language, for the fuzzer and for random scenes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rt::fuzz {

/// Reads choices from bytes, zeros after their end, and writes a script of gr.* calls: nodes,
/// transforms, edges of the graph, appearances, lights, lenses, backgrounds, renders. One value in
/// sixteen is odd: zero, negative, huge, tiny, not finite, of another type, or missing. A call that
/// fails does not stop the rest.
class SceneWriter {
  public:
    explicit SceneWriter(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    std::string script();

  private:
    std::uint8_t byte();
    std::size_t below(std::size_t count) { return byte() % count; }
    std::string oneOf(std::span<const char* const> words);

    std::string number(double low, double high);
    std::string vector(double low, double high);
    std::string name(char kind) { return kind + ("[" + std::to_string(1 + below(8)) + "]"); }
    std::string node();
    std::string combined();
    std::string appearance();
    std::string statement();
    std::string change();
    std::string namedLight();
    std::string painting();
    std::string pattern();
    std::string render();

    std::span<const std::uint8_t> bytes_;
    std::size_t next_ = 0;
};

}  // namespace rt::fuzz
