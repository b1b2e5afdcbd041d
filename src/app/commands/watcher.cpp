#include "watcher.h"

#include "interrupts.h"

#include <filesystem>
#include <system_error>
#include <utility>

namespace rt {
namespace {

/// How long the end may wait for the thread.
constexpr double kSliceSeconds = 0.1;

}  // namespace

Watcher::Watcher() : thread_([this] { look(); }) {}

Watcher::~Watcher() {
    ending_ = true;
    thread_.join();
}

void Watcher::look() {
    while (!ending_) {
        std::vector<std::string> files = files_.wait(kSliceSeconds);
        if (files.empty()) continue;
        const std::lock_guard lock(mutex_);
        changes_.insert(changes_.end(), files.begin(), files.end());
        stale_ = true;
        Interrupts::stopRender();
        changed_.notify_all();
    }
}

void Watcher::beginRound() {
    files_.begin();
    const std::lock_guard lock(mutex_);
    if (!stale_) Interrupts::allowRender();
}

void Watcher::endRound() {
    files_.end();
}

std::vector<std::string> Watcher::changes() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stale_.load(); });
    stale_ = false;
    return std::exchange(changes_, {});
}

void Watcher::ranScript(const std::string& scene, const ScriptFiles& files) {
    // By its own name, too: a link may come to lead elsewhere, and a file that is missing has no
    // other.
    std::error_code failed;
    const auto named = std::filesystem::absolute(scene, failed).lexically_normal();
    files_.add({failed ? scene : named.string()});
    files_.add(files.read);
    files_.add(files.absent);
}

void Watcher::startsImage(const std::string& output, const PreparedScene&) {
    std::error_code failed;
    const auto path = std::filesystem::weakly_canonical(output, failed);
    if (!failed) files_.ignore(path.string());
}

}  // namespace rt
