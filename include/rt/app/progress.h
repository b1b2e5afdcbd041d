// What the user sees while images are rendered.
#pragma once

#include "rt/app/options.h"

#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace rt {

/// Where progress goes, and what that place can show.
struct ProgressOutput {
    std::function<void(const std::string&)> write;
    std::function<double()> now;   ///< seconds, from any origin, never backwards
    std::function<int()> columns;  ///< of the terminal, at this moment
    bool terminal = false;         ///< lines can be redrawn
    bool colors = false;
};

/// True if messages to this descriptor may be coloured: with kAuto on a terminal that is not
/// "dumb", unless NO_COLOR is set and not empty (no-color.org).
bool wantsColors(ColorMode mode, int descriptor);

/// Standard error, written in whole lines.
ProgressOutput standardError(ColorMode mode);

/// What is told about an image when it is done.
struct RenderSummary {
    std::string output;
    double seconds = 0.0;
    std::optional<double> error;  ///< the estimated RMSE
    /// What of it is by photons: by chance, and by the width of their kernel.
    struct Photons {
        double noise;
        double bias;
    };
    std::optional<Photons> photons{};
};

/// Whole percents: a bar with the error so far and the time left on a terminal, one line for each
/// percent elsewhere.
/// All members may be called from any thread.
class Progress {
  public:
    /// A quiet one says nothing but messages.
    Progress(ProgressOutput output, bool quiet);

    /// "Threads: 2", once, before anything else.
    void begin(int threads);

    /// The clock of the time left starts, and the percents anew.
    void startImage();

    /// The share of the image that is done, in [0,1]; what lies behind the largest so far, and
    /// NaN, is passed over. Cheap where nothing visible changes.
    void update(double fraction);

    /// The estimated RMSE so far, which the bar shows from its next drawing on.
    void estimate(double error);

    /// A line of its own, above the bar.
    void message(const std::string& line);

    /// 100 %, then "Render Complete!", the file, the time and the error.
    void finish(const RenderSummary& summary);

    /// Ends the bar's line, for an image that is given up.
    void abandon();

  private:
    void advance(double fraction);
    void draw(double seconds);
    void endBar();
    std::string bar(double secondsLeft, int columns) const;

    ProgressOutput output_;
    bool quiet_;
    std::mutex mutex_;
    double start_ = 0.0;
    double drawn_ = 0.0;
    double fraction_ = 0.0;
    int percent_ = -1;
    std::optional<double> error_;
    bool barShown_ = false;
};

/// "2.31 s", "4 min 7 s", "2 h 5 min".
std::string durationText(double seconds);

/// An estimated error for messages: three significant digits.
std::string errorText(double error);

}  // namespace rt
