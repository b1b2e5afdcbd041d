#include "checkpoint_keeper.h"

#include "rt/core/error.h"
#include "rt/core/input_file.h"
#include "rt/output/atomic_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

namespace rt {
namespace {

/// Seconds between checkpoints, with --resume: what a killed render loses.
constexpr double kEvery = 60.0;

bool isThere(const std::string& file) {
    return ::access(file.c_str(), F_OK) == 0;
}

std::chrono::system_clock::time_point changeOf(const struct stat& status) {
    return std::chrono::system_clock::time_point(
        std::chrono::seconds(status.st_ctim.tv_sec) +
        std::chrono::duration_cast<std::chrono::system_clock::duration>(
            std::chrono::nanoseconds(status.st_ctim.tv_nsec)));
}

}  // namespace

CheckpointKeeper::CheckpointKeeper(const Options& options, const std::string& output,
                                   std::vector<std::string> filesRead, Time began,
                                   std::function<std::vector<Trait>()> traits)
    : options_(options),
      file_(checkpointName(output)),
      filesRead_(std::move(filesRead)),
      began_(began),
      makeTraits_(std::move(traits)) {}

std::string CheckpointKeeper::open() {
    if (options_.resume == Resume::kNo && !(options_.checkpointEvery.value_or(0.0) > 0.0)) {
        return "";
    }
    refuseOverwriting(file_, filesRead_);
    checkWritable(file_);
    traits_ = makeTraits_();
    if (options_.resume == Resume::kNo || !isThere(file_)) return "";
    const std::vector<std::uint8_t> bytes = InputFile(file_).readAll();
    const CheckpointVerdict verdict = decodeCheckpoint(bytes, *traits_, log_);
    using Kind = CheckpointVerdict::Kind;
    if (verdict.kind == Kind::kFits) {
        isOurs_ = goesOn_ = true;
        return "";
    }
    if (verdict.kind == Kind::kOther) {
        throw SceneError(
            "the checkpoint " + verdict.why + "; remove it, or render without --resume",
            {file_, 0});
    }
    if (options_.resume == Resume::kRequired)
        throw SceneError("the checkpoint " + verdict.why + "; remove it", {file_, 0});
    isOurs_ = isCheckpoint(bytes);
    return "the checkpoint " + file_ + " " + verdict.why + "; the render starts anew";
}

void CheckpointKeeper::listen(RenderListener& listener) {
    listener.log = &log_;
    listener.onCheckpoint = [this] { save(); };
    listener.checkpointEvery =
        options_.checkpointEvery.value_or(options_.resume == Resume::kNo ? 0.0 : kEvery);
}

/// A render is worth more than its checkpoint: whatever fails is told at the end.
void CheckpointKeeper::save() {
    saved_ = false;
    problem_.clear();
    try {
        saveOrThrow();
        saved_ = true;
    } catch (const Error& error) {
        problem_ = error.what();
    } catch (const std::bad_alloc&) {
        problem_ = "the system has no memory left";
    }
}

void CheckpointKeeper::saveOrThrow() {
    if (!traits_) {
        refuseOverwriting(file_, filesRead_);
        refuseChangedFiles();
        traits_ = makeTraits_();
    }
    const std::vector<std::uint8_t> bytes = encodeCheckpoint(*traits_, log_);
    if (options_.resume == Resume::kNo && isThere(file_) && isLessThanThere(bytes.size())) return;
    static_cast<void>(writeFile(file_, bytes));
    isOurs_ = true;
}

/// What is in them now need not be what was rendered.
void CheckpointKeeper::refuseChangedFiles() const {
    for (const std::string& file : filesRead_) {
        struct stat status {};
        if (::stat(file.c_str(), &status) == 0 && changeOf(status) <= began_) continue;
        throw SceneError("has changed since it was read", {file, 0});
    }
}

/// Of the same picture, the longer log is further. What nobody asked for must not cost what was
/// kept before, nor a file that is none of the program's.
bool CheckpointKeeper::isLessThanThere(std::size_t bytes) const {
    const std::vector<std::uint8_t> there = InputFile(file_).readAll();
    if (!there.empty() && !isCheckpoint(there)) {
        throw SceneError("is not a checkpoint, and is left alone", {file_, 0});
    }
    RenderLog log;
    return there.size() > bytes &&
           decodeCheckpoint(there, *traits_, log).kind == CheckpointVerdict::Kind::kFits;
}

std::string CheckpointKeeper::finish() {
    if (!isOurs_) return "";
    if (::unlink(file_.c_str()) == 0 || errno == ENOENT) return "";
    return file_ + " cannot be removed: " + std::strerror(errno);
}

}  // namespace rt
