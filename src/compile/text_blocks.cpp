#include "text_blocks.h"

#include <algorithm>

namespace rt {
namespace {

constexpr std::size_t kBlockSize = std::size_t{1} << 20;

}  // namespace

/// The position after the last line end in the buffer that surely is one, or begin_.
std::size_t TextBlocks::lastLineEnd() const {
    for (std::size_t i = end_; i > begin_; --i) {
        const char c = buffer_[i - 1];
        // The LF of a CR LF may be still to come.
        if (c != '\n' && !(c == '\r' && i < end_)) continue;
        std::size_t before = i - 1;
        if (c == '\n' && before > begin_ && buffer_[before - 1] == '\r') --before;
        const bool goesOn = before > begin_ && buffer_[before - 1] == '\\';
        if (!goesOn) return i;
    }
    return begin_;
}

/// Moves what is left to the front and reads on, into a larger buffer if there is little room.
void TextBlocks::refill() {
    std::copy(buffer_.data() + begin_, buffer_.data() + end_, buffer_.data());
    end_ -= begin_;
    begin_ = 0;
    buffer_.resize(std::max(buffer_.size(), 2 * end_ + kBlockSize));
    const std::size_t room = buffer_.size() - 1 - end_;
    const std::size_t got = file_.read(buffer_.data() + end_, room);
    ended_ = got < room;
    end_ += got;
}

bool TextBlocks::next(Block& block) {
    if (begin_ > 0) buffer_[begin_] = covered_;
    std::size_t lineEnd = begin_;
    while (!ended_) {
        refill();
        lineEnd = ended_ ? end_ : lastLineEnd();
        if (lineEnd > begin_) break;
    }
    if (lineEnd == begin_) return false;
    covered_ = buffer_[lineEnd];
    buffer_[lineEnd] = '\n';
    block = {buffer_.data() + begin_, buffer_.data() + lineEnd};
    begin_ = lineEnd;
    return true;
}

}  // namespace rt
