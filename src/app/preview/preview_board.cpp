#include "preview_board.h"

#include "../commands/interrupts.h"
#include "preview_maps.h"
#include "preview_page.inc"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

namespace rt {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostMessages = 100;

PreviewAnswer refusal(int status, const char* words) {
    return {status, "text/plain; charset=utf-8", std::string(words) + "\n"};
}

PreviewAnswer json(const Json& value) {
    return {200, "application/json", value.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

PreviewAnswer page(const std::string& token) {
    constexpr const char* kMark = "{{token}}";
    std::string text = kPreviewPage;
    text.replace(text.find(kMark), std::strlen(kMark), token);
    return {200, "text/html; charset=utf-8", text};
}

std::optional<int> wholeNumber(const char* text) {
    if (text == nullptr) return std::nullopt;
    int value = 0;
    const char* const end = text + std::strlen(text);
    const auto [stop, problem] = std::from_chars(text, end, value);
    if (problem != std::errc() || stop != end) return std::nullopt;
    return value;
}

}  // namespace

PreviewBoard::PreviewBoard(int port, std::string token, bool watching)
    : port_(port), token_(std::move(token)), watching_(watching) {}

bool PreviewBoard::isOurHost(const char* host) const {
    if (host == nullptr) return false;
    const std::string port = ":" + std::to_string(port_);
    return host == "127.0.0.1" + port || host == "localhost" + port;
}

PreviewAnswer PreviewBoard::answer(const RtPreviewRequest& request) {
    if (!isOurHost(request.host)) return refusal(403, "This page is for 127.0.0.1 only.");
    if (request.origin && request.origin != "http://" + std::string(request.host)) {
        return refusal(403, "This is not for other pages.");
    }
    const std::string path = request.path;
    const std::string method = request.method;
    if (path == "/stop") {
        if (method != "POST") return refusal(405, "Stopping needs POST.");
        return stop(request);
    }
    if (method != "GET" && method != "HEAD") return refusal(405, "Only GET and HEAD.");
    if (path == "/") return page(token_);
    if (path == "/status.json") return status();
    if (path == "/map.png") return map(request.map ? request.map : "image");
    if (path == "/pixel.json") return pixel(request);
    return refusal(404, "There is no such page.");
}

PreviewAnswer PreviewBoard::status() {
    const std::lock_guard lock(mutex_);
    if (running_) wantsSnapshot_ = true;
    Json all = {{"running", running_},
                {"watching", watching_},
                {"output", output_},
                {"share", share_},
                {"version", version_},
                {"x0", snapshot_.area.x0},
                {"y0", snapshot_.area.y0},
                {"width", snapshot_.area.width()},
                {"height", snapshot_.area.height()},
                {"mostSamples", mostSamples(snapshot_)},
                {"largestError", largestError(snapshot_)},
                {"messages", messages_}};
    all["error"] = error_ ? Json(*error_) : Json();
    const double elapsed =
        running_ ? std::chrono::duration<double>(Clock::now() - start_).count() : seconds_;
    all["seconds"] = elapsed;
    const bool known = running_ && share_ > 0.0;
    all["secondsLeft"] = known ? Json(elapsed * (1.0 - share_) / share_) : Json();
    return json(all);
}

PreviewAnswer PreviewBoard::map(const std::string& name) const {
    RenderSnapshot snapshot;
    ImageSettings settings;
    {
        const std::lock_guard lock(mutex_);
        if (version_ == 0) return refusal(404, "There is no image yet.");
        snapshot = snapshot_;
        settings = settings_;
    }
    std::vector<std::uint8_t> bytes;
    if (name == "image") {
        bytes = picturePng(snapshot, settings);
    } else if (name == "samples") {
        bytes = samplesPng(snapshot);
    } else if (name == "error") {
        bytes = errorPng(snapshot);
    } else {
        return refusal(404, "There is no such map.");
    }
    return {200, "image/png", std::string(bytes.begin(), bytes.end())};
}

PreviewAnswer PreviewBoard::pixel(const RtPreviewRequest& request) const {
    const std::optional<int> x = wholeNumber(request.x);
    const std::optional<int> y = wholeNumber(request.y);
    const std::lock_guard lock(mutex_);
    const Tile& area = snapshot_.area;
    if (!x || !y || *x < area.x0 || *x >= area.x1 || *y < area.y0 || *y >= area.y1) {
        return refusal(404, "There is no such pixel.");
    }
    const std::size_t index = area.offset(*x, *y);
    const glm::vec3& mean = snapshot_.means[index];
    Json all = {{"x", *x},
                {"y", *y},
                {"value", {mean.x, mean.y, mean.z}},
                {"samples", snapshot_.samples[index]}};
    all["error"] = snapshot_.errors.empty() ? Json() : Json(snapshot_.errors[index]);
    return json(all);
}

PreviewAnswer PreviewBoard::stop(const RtPreviewRequest& request) {
    if (request.token == nullptr || token_ != request.token) {
        return refusal(403, "Stopping needs the token of the page.");
    }
    const std::lock_guard lock(mutex_);
    stopAsked_ = true;
    if (running_) Interrupts::stopRender();
    changed_.notify_all();
    return {200, "text/plain; charset=utf-8", "Stopping.\n"};
}

void PreviewBoard::beginRound() {
    const std::lock_guard lock(mutex_);
    running_ = true;
    stopAsked_ = false;
    messages_.clear();
    share_ = 0.0;
    error_.reset();
    start_ = Clock::now();
}

void PreviewBoard::endRound() {
    const std::lock_guard lock(mutex_);
    running_ = false;
}

void PreviewBoard::waitForStop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopAsked_; });
}

void PreviewBoard::startsImage(const std::string& output, const PreparedScene& prepared) {
    const std::lock_guard lock(mutex_);
    output_ = output;
    settings_.transfer =
        prepared.options.transfer.value_or("raw") == "srgb" ? Transfer::kSrgb : Transfer::kRaw;
    share_ = 0.0;
    error_.reset();
    start_ = Clock::now();
    snapshot_.errors.clear();
}

void PreviewBoard::savedImage(const Picture& picture) {
    const std::lock_guard lock(mutex_);
    seconds_ = picture.stats.renderSeconds;
    if (picture.stats.errorEstimate) error_ = picture.stats.errorEstimate;
    if (!picture.cancelled) share_ = 1.0;
}

void PreviewBoard::said(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (messages_.size() < kMostMessages) messages_.push_back(line);
}

void PreviewBoard::listen(RenderListener& listener) {
    listener.onProgress = [this, next = std::move(listener.onProgress)](double share) {
        {
            const std::lock_guard lock(mutex_);
            share_ = std::max(share_, share);
        }
        if (next) next(share);
    };
    listener.onEstimate = [this, next = std::move(listener.onEstimate)](double error) {
        {
            const std::lock_guard lock(mutex_);
            error_ = error;
        }
        if (next) next(error);
    };
    listener.onSnapshot = [this](RenderSnapshot snapshot) { show(std::move(snapshot)); };
    listener.wantsSnapshot = &wantsSnapshot_;
}

void PreviewBoard::show(RenderSnapshot snapshot) {
    wantsSnapshot_ = false;
    const std::lock_guard lock(mutex_);
    const bool sameSize = snapshot.means.size() == snapshot_.errors.size();
    if (snapshot.errors.empty() && sameSize) snapshot.errors = std::move(snapshot_.errors);
    snapshot_ = std::move(snapshot);
    ++version_;
}

}  // namespace rt
