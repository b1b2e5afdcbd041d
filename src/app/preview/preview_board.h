// What --preview shows: the state of the run, and the answers to a browser's requests.
#pragma once

#include "../commands/run_follower.h"
#include "rt/app/preview_abi.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// An HTTP answer.
struct PreviewAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body;
};

/// Follows a run on its threads, and answers on the server's.
///
/// Requests that name another host than this machine's loopback address and port are refused, so
/// that no page of the web can reach it through a name of its own (DNS rebinding). What changes
/// something needs POST and the token, which only the page itself holds.
class PreviewBoard : public RunFollower {
  public:
    PreviewBoard(int port, std::string token, bool watching);

    PreviewAnswer answer(const RtPreviewRequest& request);

    void beginRound();
    void endRound();
    /// Waits until somebody asks for the end.
    void waitForStop();

    void startsImage(const std::string& output, const PreparedScene& prepared) override;
    void savedImage(const Picture& picture) override;
    void said(const std::string& line) override;
    void listen(RenderListener& listener) override;

  private:
    using Clock = std::chrono::steady_clock;

    PreviewAnswer status();
    PreviewAnswer map(const std::string& name) const;
    PreviewAnswer pixel(const RtPreviewRequest& request) const;
    PreviewAnswer stop(const RtPreviewRequest& request);
    void show(RenderSnapshot snapshot);
    bool isOurHost(const char* host) const;

    const int port_;
    const std::string token_;
    const bool watching_;

    std::atomic<bool> wantsSnapshot_{false};
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool running_ = false;
    bool stopAsked_ = false;
    std::string output_;
    ImageSettings settings_;
    double share_ = 0.0;
    std::optional<double> error_;
    Clock::time_point start_;
    double seconds_ = 0.0;  ///< of the image that is done
    std::vector<std::string> messages_;
    std::uint64_t version_ = 0;  ///< of the snapshot; 0: there is none
    RenderSnapshot snapshot_;    ///< its errors are the last that were known
};

}  // namespace rt
