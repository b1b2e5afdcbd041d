#include "flip.h"
#include "image_difference.h"
#include "rt/app/commands.h"
#include "rt/core/diagnostics.h"
#include "rt/core/error.h"
#include "rt/core/text.h"

#include <cstdio>

namespace rt {
namespace {

int failComparison(const std::string& reason) {
    std::fprintf(stderr, "compare: %s\n", reason.c_str());
    return static_cast<int>(ExitCode::kComparison);
}

std::string sizeOf(const std::string& path, const PixelImage& image) {
    return printable(path) + " is " + std::to_string(image.width) + "x" +
           std::to_string(image.height);
}

int print(const ImageDifference& difference, double flip) {
    const std::string text = "RMSE        " + shortest(difference.rmse) + "\n" +          //
                             "mean        " + shortest(difference.meanAbsolute) + "\n" +  //
                             "max         " + shortest(difference.maxAbsolute) + " at " +
                             std::to_string(difference.maxX) + "," +
                             std::to_string(difference.maxY) + "\n" + "over 4/255  " +
                             shortest(100.0 * difference.shareOver) + " %\n" +  //
                             "FLIP        " + shortest(flip) + "\n";
    const bool written = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
    return static_cast<int>(written ? ExitCode::kDone : ExitCode::kOutput);
}

int compare(const CompareOptions& options) {
    ComparedImage a = loadForComparison(options.first);
    ComparedImage b = loadForComparison(options.second);
    if (a.image.width != b.image.width || a.image.height != b.image.height) {
        return failComparison("the sizes differ: " + sizeOf(options.first, a.image) + ", " +
                              sizeOf(options.second, b.image));
    }
    for (const auto& [path, compared] : {std::pair(&options.first, &a), {&options.second, &b}}) {
        if (hasNonFinite(compared->image)) {
            return failComparison(printable(*path) + " holds values that are not finite numbers");
        }
    }
    if (a.floats != b.floats) clampValues(a.floats ? a.image : b.image);
    const ImageDifference difference = differenceOf(a.image, b.image);
    const int printed = print(difference, meanFlip(a.image, b.image));
    if (printed != 0) return printed;
    if (!options.tolerance || difference.rmse <= *options.tolerance) return 0;
    return failComparison("the RMSE " + shortest(difference.rmse) + " is above the tolerance " +
                          shortest(*options.tolerance));
}

}  // namespace

int compareCommand(const CompareOptions& options) {
    try {
        return compare(options);
    } catch (const SceneError& error) {
        // A missing or damaged image is a comparison that failed, not a fault of any scene.
        return failComparison(error.what());
    }
}

}  // namespace rt
