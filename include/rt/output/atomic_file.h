// Files that are written whole or not at all, whatever happens in between: a full disk, a signal,
// kill -9, a second process with the same output.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// Writes `bytes` as the file `path`; "-" is stdout.
///
/// A regular file is replaced by rename(2) of a synced temporary file in the same folder, which is
/// made if missing; the old file's mode is kept, else it is 0666 less the umask. Of a symbolic link
/// the target is replaced and the link stays. A device, a FIFO or an open descriptor
/// (/dev/stdout) is written directly and never replaced; a terminal is refused.
///
/// Returns "" or a sentence to warn with, when the file system could not replace at once and the
/// file was overwritten in place. Throws OutputError with the reason of the system; the older file
/// is then untouched. Throws UsageError for a terminal.
std::string writeFile(const std::string& path, std::span<const std::uint8_t> bytes);

/// Removes the temporary file of a write that goes on, if any: for a signal handler that is about
/// to end the process.
void abandonWrite() noexcept;

/// Throws as `writeFile` would, as far as can be known before there is anything to write: makes
/// missing folders, tries the folder, respects a file that is write protected or immutable.
void checkWritable(const std::string& path);

/// True if `path` is stdout, or exists and is neither a regular file nor a folder: its name says
/// nothing about the format wanted.
bool isStream(const std::string& path);

/// Throws UsageError if `output` is one of the files that the run reads, under whatever name.
void refuseOverwriting(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace rt
