#include "rt/app/progress.h"

#include "rt/core/diagnostics.h"
#include "rt/core/text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace rt {
namespace {

// The time left is redrawn this often though the percent stays.
constexpr double kRedrawSeconds = 0.25;

constexpr int kLongestBar = 60;
constexpr int kShortestBar = 8;
constexpr int kUsualColumns = 80;

constexpr const char* kEraseLine = "\r\x1b[K";
constexpr const char* kGreen = "\x1b[32m";
constexpr const char* kBoldGreen = "\x1b[1;32m";
constexpr const char* kPlain = "\x1b[0m";

/// One write for each text, so that lines of several processes do not mix.
void writeToStandardError(const std::string& text) {
    std::size_t done = 0;
    while (done < text.size()) {
        const ssize_t count = ::write(STDERR_FILENO, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return;
        done += static_cast<std::size_t>(count);
    }
}

double steadySeconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

int terminalColumns() {
    winsize size{};
    const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return known ? size.ws_col : kUsualColumns;
}

bool isCapableTerminal(int descriptor) {
    const char* term = std::getenv("TERM");
    return ::isatty(descriptor) == 1 && term && std::string(term) != "dumb";
}

std::string twoDigits(std::int64_t value) {
    return (value < 10 ? "0" : "") + std::to_string(value);
}

/// "0:07", "12:34", "3:05:09".
std::string clockText(double seconds) {
    constexpr double kMost = 1e9;
    const auto whole = static_cast<std::int64_t>(std::ceil(std::min(seconds, kMost)));
    const std::string minutesSeconds =
        std::to_string(whole / 60 % 60) + ":" + twoDigits(whole % 60);
    if (whole < 3600) return minutesSeconds;
    return std::to_string(whole / 3600) + ":" + twoDigits(whole / 60 % 60) + ":" +
           twoDigits(whole % 60);
}

}  // namespace

std::string errorText(double error) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), error, std::chars_format::general, 3);
    return std::string(text.data(), end.ptr);
}

bool wantsColors(ColorMode mode, int descriptor) {
    if (mode != ColorMode::kAuto) return mode == ColorMode::kAlways;
    const char* refused = std::getenv("NO_COLOR");
    return isCapableTerminal(descriptor) && !(refused && *refused);
}

ProgressOutput standardError(ColorMode mode) {
    return {writeToStandardError, steadySeconds, terminalColumns, isCapableTerminal(STDERR_FILENO),
            wantsColors(mode, STDERR_FILENO)};
}

std::string durationText(double seconds) {
    // Rounding must not show 60 of anything.
    if (seconds < 59.995) return fixed(seconds, 2) + " s";
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 3600) {
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    }
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

Progress::Progress(ProgressOutput output, bool quiet)
    : output_(std::move(output)), quiet_(quiet), start_(output_.now()) {}

void Progress::begin(int threads) {
    const std::lock_guard lock(mutex_);
    if (!quiet_) output_.write("Threads: " + std::to_string(threads) + "\n");
}

void Progress::startImage() {
    const std::lock_guard lock(mutex_);
    start_ = output_.now();
    fraction_ = 0.0;
    percent_ = -1;
    error_.reset();
}

void Progress::update(double fraction) {
    const std::lock_guard lock(mutex_);
    if (!quiet_) advance(fraction);
}

void Progress::estimate(double error) {
    const std::lock_guard lock(mutex_);
    error_ = error;
}

void Progress::message(const std::string& line) {
    const std::lock_guard lock(mutex_);
    output_.write((barShown_ ? kEraseLine : "") + line + "\n");
    if (barShown_) draw(output_.now());
}

void Progress::finish(const RenderSummary& summary) {
    const std::lock_guard lock(mutex_);
    if (quiet_) return;
    advance(1.0);
    endBar();
    const std::string done = output_.colors ? std::string(kBoldGreen) + "Render Complete!" + kPlain
                                            : std::string("Render Complete!");
    const std::string error =
        summary.error ? ", estimated error " + errorText(*summary.error) : std::string();
    const std::string photons = summary.photons
                                    ? " (photons: noise " + errorText(summary.photons->noise) +
                                          ", bias " + errorText(summary.photons->bias) + ")"
                                    : std::string();
    const std::string name = summary.output == "-" ? "standard output" : printable(summary.output);
    output_.write(done + " " + name + " in " + durationText(summary.seconds) + error + photons +
                  "\n");
}

void Progress::abandon() {
    const std::lock_guard lock(mutex_);
    endBar();
}

void Progress::advance(double fraction) {
    if (fraction > fraction_) fraction_ = std::min(fraction, 1.0);
    const int percent = static_cast<int>(std::floor(fraction_ * 100.0));
    const bool further = percent > percent_;
    percent_ = percent;
    if (!output_.terminal) {
        if (further) output_.write(std::to_string(percent) + " %\n");
        return;
    }
    const double now = output_.now();
    if (further || now - drawn_ >= kRedrawSeconds) draw(now);
}

void Progress::draw(double seconds) {
    drawn_ = seconds;
    const double elapsed = seconds - start_;
    const double left = fraction_ > 0.0 ? elapsed * (1.0 - fraction_) / fraction_ : -1.0;
    output_.write(kEraseLine + bar(left, output_.columns()));
    barShown_ = true;
}

void Progress::endBar() {
    if (barShown_) output_.write("\n");
    barShown_ = false;
}

std::string Progress::bar(double secondsLeft, int columns) const {
    const std::string number = std::to_string(percent_) + " %";
    const std::string percent =
        std::string(5 - std::min<std::size_t>(number.size(), 5), ' ') + number;
    const std::string time = secondsLeft >= 0.0 ? "  " + clockText(secondsLeft) + " left" : "";
    const std::string error = error_ ? "  error " + errorText(*error_) : "";
    // What there is no room for goes: the error first, then the bar, then the time.
    std::string texts = percent + error + time;
    const auto lengthBeside = [&] {
        // The last column stays free: writing into it wraps on some terminals.
        return std::min(columns - 1 - static_cast<int>(texts.size()) - 3, kLongestBar);
    };
    if (lengthBeside() < kShortestBar) texts = percent + time;
    const int length = lengthBeside();
    if (length < kShortestBar) return static_cast<int>(texts.size()) < columns ? texts : percent;
    const int filled = static_cast<int>(std::floor(fraction_ * length));
    const std::string done(static_cast<std::size_t>(filled), '=');
    const std::string rest(static_cast<std::size_t>(length - filled), ' ');
    const std::string shown = output_.colors ? kGreen + done + kPlain : done;
    return "[" + shown + rest + "] " + texts;
}

}  // namespace rt
