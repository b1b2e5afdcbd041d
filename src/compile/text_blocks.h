// A text file in blocks of whole logical lines.
#pragma once

#include "rt/core/input_file.h"

#include <cstddef>
#include <vector>

namespace rt {

/// A line ends in LF, CR LF or CR; one whose last character is a backslash goes on in the next.
class TextBlocks {
  public:
    explicit TextBlocks(InputFile& file) : file_(file) {}

    struct Block {
        const char* begin;
        const char* end;  ///< *end is readable, and '\n'
    };

    /// The next block, which ends where a logical line ends, or at the end of the file. False when
    /// there is none left. The block lives until the next call.
    bool next(Block& block);

  private:
    std::size_t lastLineEnd() const;
    void refill();

    InputFile& file_;
    std::vector<char> buffer_;
    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    bool ended_ = false;
    char covered_ = 0;  ///< what the '\n' at the last block's end hides
};

}  // namespace rt
