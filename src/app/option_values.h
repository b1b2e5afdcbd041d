// Values of options, from text to number: strict, and the same in every locale.
#pragma once

#include "rt/app/options.h"

#include <cstdint>
#include <string>

namespace rt {

/// All of these throw UsageError "FLAG TEXT: what would be right".
std::int64_t wholeIn(const std::string& flag, const std::string& text, std::int64_t min,
                     std::int64_t max);
double numberFrom(const std::string& flag, const std::string& text, double min);
/// A whole number of bytes with K, M or G (powers of 1024) after it.
std::size_t bytesFrom(const std::string& flag, const std::string& text);
/// WxH.
ImageSize sizeFrom(const std::string& flag, const std::string& text);
/// x0,y0,x1,y1.
Crop cropFrom(const std::string& flag, const std::string& text);
/// x,y, both at least 0.
PixelPlace pixelFrom(const std::string& flag, const std::string& text);
/// A-B, or A alone.
FrameRange framesFrom(const std::string& flag, const std::string& text);
/// i/n, 1 <= i <= n.
Shard shardFrom(const std::string& flag, const std::string& text);
/// Names, separated by commas.
std::vector<Aov> aovsFrom(const std::string& flag, const std::string& text);
/// name=value.
std::pair<std::string, std::string> parameterFrom(const std::string& flag, const std::string& text);
/// One of the words.
std::size_t wordFrom(const std::string& flag, const std::string& text,
                     const std::vector<std::string>& words);

/// Stores the text as the row's kind says, after its own check.
void storeShared(const OptionRow& row, const std::string& text, RenderOptions& options);

[[noreturn]] void refuseValue(const std::string& flag, const std::string& text,
                              const std::string& right);

}  // namespace rt
