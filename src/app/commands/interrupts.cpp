#include "interrupts.h"

#include "rt/output/atomic_file.h"

#include <signal.h>
#include <unistd.h>

namespace rt {
namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> deferring{false};
std::atomic<bool> pausing{false};
std::atomic<bool> snapshotAsked{false};
std::atomic<bool> signalled{false};
std::atomic<bool> stopFlag{false};
std::atomic<int> firstSignal{0};

extern "C" void onSignal(int signal) {
    if (!deferring.load() || signalled.exchange(true)) {
        abandonWrite();
        _exit(128 + signal);
    }
    firstSignal.store(signal);
    stopFlag.store(true);
}

extern "C" void onSnapshotSignal(int) {
    if (!pausing.load()) return;
    snapshotAsked.store(true);
    stopFlag.store(true);
}

/// A reader that goes is an error of the write. Not ignored, which programs that a script starts
/// would inherit.
extern "C" void onBrokenPipe(int) {}

}  // namespace

void Interrupts::handle() {
    struct sigaction action = {};
    action.sa_handler = &onSignal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (const int signal : kSignals) sigaction(signal, &action, nullptr);
    action.sa_handler = &onSnapshotSignal;
    sigaction(SIGUSR1, &action, nullptr);
    signal(SIGPIPE, &onBrokenPipe);
}

Interrupts::Deferred::Deferred(bool pauses) {
    deferring.store(true);
    pausing.store(pauses);
}

/// What has been asked for stays deferred until the image is saved.
Interrupts::Deferred::~Deferred() {
    pausing.store(false);
    deferring.store(signalled.load());
}

const std::atomic<bool>& Interrupts::requested() {
    return stopFlag;
}

void Interrupts::stopRender() {
    stopFlag.store(true);
}

void Interrupts::allowRender() {
    stopFlag.store(false);
    if (firstSignal.load() != 0) stopFlag.store(true);
}

bool Interrupts::isSnapshotAsked() {
    return snapshotAsked.load();
}

bool Interrupts::takeSnapshotRequest() {
    if (!snapshotAsked.exchange(false)) return false;
    allowRender();
    return !stopFlag.load();
}

int Interrupts::exitCode() {
    const int signal = firstSignal.load();
    return signal ? 128 + signal : 0;
}

}  // namespace rt
