// Reading position in the text of an OBJ file: blanks, line ends, numbers.
#pragma once

#include "rt/core/error.h"

#include <cstdint>
#include <string>

namespace rt {

/// Walks over one block of text after another. Within a line only; nextLine() goes on.
class ObjCursor {
  public:
    explicit ObjCursor(std::string path) : path_(std::move(path)) {}

    /// *end must be '\n'.
    void enter(const char* begin, const char* end) {
        at_ = begin;
        end_ = end;
    }
    bool atBlockEnd() const { return at_ >= end_; }
    /// Counted from 1; the largest int for all lines beyond.
    int line() const;
    SourceLocation where() const { return {path_, line()}; }

    /// The next character; '\n' at the end of the block.
    char peek() const { return *at_; }
    /// Another character of the same line; `ahead` may go one past its end.
    char peekAt(std::size_t ahead) const { return at_[ahead]; }
    void advance(std::size_t count = 1) { at_ += count; }

    static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    /// What may follow a word: a blank, a line end, or the backslash before one.
    static bool endsWord(char c) {
        return c == ' ' || c == '\t' || isLineEnd(c) || c == '\\' || c == '\v' || c == '\f';
    }

    /// Over blanks and continued line ends.
    void skipBlanks();
    /// After skipBlanks: nothing more but a comment.
    bool atEndOfStatement() const { return isLineEnd(*at_) || *at_ == '#'; }
    /// Past the end of the line; past the continued lines too if `continued`.
    void nextLine(bool continued);

    /// A finite decimal number after blanks; SceneError for anything else. `what` names it.
    double number(const char* what);
    /// Digits with an optional '-', at most 9e18 in size; SceneError naming the word otherwise.
    std::int64_t integer();

    /// The characters from here to the next that ends a word, made printable and short.
    std::string word() const;
    [[noreturn]] void fail(const std::string& message) const;

  private:
    void endLine();

    std::string path_;
    const char* at_ = nullptr;
    const char* end_ = nullptr;
    std::int64_t line_ = 1;
};

}  // namespace rt
