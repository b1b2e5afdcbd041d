// What the program can be asked to do: options in, exit code out.
#pragma once

#include "rt/app/options.h"

namespace rt {

/// Every scene, every frame, every render of its script. A scene that fails does not stop the
/// others; the exit code is the first failure's.
int renderCommand(const Options& options);

/// Two images: their difference, and exit code 10 where it is over the tolerance.
int compareCommand(const CompareOptions& options);

/// Every scene of a folder, rendered and held against its image; exit code 10 where one differs.
int goldenCommand(const Options& options);

/// Shards become the picture that they are of.
int mergeCommand(const MergeOptions& options);

/// A document about the program, on standard output.
int printCommand(const Options& options);

int helpCommand();
int versionCommand();

}  // namespace rt
