#include "golden_report.h"

#include "flip.h"
#include "image_difference.h"
#include "rt/core/diagnostics.h"
#include "rt/core/text.h"
#include "rt/output/atomic_file.h"
#include "rt/output/image_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace rt {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>Golden images</title>
<style>
body { font-family: sans-serif; margin: 2em; background: #fff; color: #222; }
h2 { font-size: 1.1em; margin: 1.6em 0 0.3em; }
.failed { color: #b00020; }
.passed { color: #1b6e2c; }
figure { display: inline-block; margin: 0.4em 0.8em 0.4em 0; vertical-align: top; }
figcaption { font-size: 0.85em; color: #555; }
img { border: 1px solid #ccc; image-rendering: pixelated; min-width: 20em; max-width: 100%; }
</style>
</head>
<body>
<h1>Golden images</h1>
)";

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : printable(text)) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    }
    return result;
}

PixelImage absoluteDifference(const GoldenPair& pair, double factor) {
    PixelImage image = pair.picture;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            image.pixels[i][c] =
                factor * std::fabs(pair.picture.pixels[i][c] - pair.reference.pixels[i][c]);
        }
    }
    return image;
}

/// 0 to 1 as black, red, yellow, white.
PixelImage heatMap(const std::vector<double>& values, int width, int height) {
    PixelImage image{width, height, {}};
    for (const double value : values) {
        image.pixels.push_back(
            glm::clamp(Color(3.0 * value, 3.0 * value - 1.0, 3.0 * value - 2.0), 0.0, 1.0));
    }
    return image;
}

/// The largest power of two that leaves the largest difference at most 1.
double brighteningFor(double largest) {
    constexpr int kMostDoublings = 8;
    const double doublings = largest > 0.0 ? std::floor(-std::log2(std::min(largest, 1.0))) : 0.0;
    return std::exp2(std::min(doublings, static_cast<double>(kMostDoublings)));
}

class Page {
  public:
    explicit Page(const std::string& folder) : folder_(folder), text_(kHead) {}

    void add(const GoldenEntry& entry) {
        ++number_;
        const std::string kind = entry.passed ? "passed" : "failed";
        text_ += "<h2 class=\"" + kind + "\">" + escaped(entry.name) + "</h2>\n<p>" +
                 escaped(entry.scene) + ": <span class=\"" + kind + "\">" + escaped(entry.verdict) +
                 "</span></p>\n";
        if (entry.alone) figure("picture", "the picture", *entry.alone);
        if (entry.pair) addPair(*entry.pair);
    }

    void write(const std::string& summary) {
        text_ += "<p>" + escaped(summary) + "</p>\n</body>\n</html>\n";
        writeFile(folder_ + "/index.html",
                  {reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size()});
    }

  private:
    void addPair(const GoldenPair& pair) {
        const ImageDifference d = differenceOf(pair.picture, pair.reference);
        const std::vector<double> flips = flipMap(pair.picture, pair.reference);
        double flip = 0.0;
        for (const double value : flips) flip += value / static_cast<double>(flips.size());
        text_ += "<p>RMSE " + fixed(d.rmse, 6) + ", mean " + fixed(d.meanAbsolute, 6) + ", max " +
                 fixed(d.maxAbsolute, 4) + " at " + std::to_string(d.maxX) + "," +
                 std::to_string(d.maxY) + ", over 4/255 " + fixed(100.0 * d.shareOver, 2) +
                 " %, FLIP " + fixed(flip, 5) + "</p>\n";
        const double factor = brighteningFor(d.maxAbsolute);
        figure("picture", "the picture", pair.picture);
        figure("reference", "its reference", pair.reference);
        figure("difference", "their difference, times " + fixed(factor, 0),
               absoluteDifference(pair, factor));
        figure("flip", "FLIP: black is 0, white is 1",
               heatMap(flips, pair.picture.width, pair.picture.height));
    }

    void figure(const std::string& kind, const std::string& caption, const PixelImage& image) {
        const std::string file = std::to_string(number_) + "_" + kind + ".png";
        writeImage(folder_ + "/" + file, image, {}, {});
        text_ += "<figure><a href=\"" + file + "\"><img src=\"" + file + "\" alt=\"" +
                 escaped(caption) + "\"></a><figcaption>" + escaped(caption) +
                 "</figcaption></figure>\n";
    }

    std::string folder_;
    std::string text_;
    int number_ = 0;
};

}  // namespace

void writeGoldenReport(const std::string& folder, const std::vector<GoldenEntry>& entries) {
    Page page(folder);
    for (const bool passed : {false, true}) {
        for (const GoldenEntry& entry : entries) {
            if (entry.passed == passed) page.add(entry);
        }
    }
    const auto failed = std::count_if(entries.begin(), entries.end(),
                                      [](const GoldenEntry& entry) { return !entry.passed; });
    page.write(std::to_string(entries.size() - static_cast<std::size_t>(failed)) + " passed, " +
               std::to_string(failed) + " failed.");
}

}  // namespace rt
