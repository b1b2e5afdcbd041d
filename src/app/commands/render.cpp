// script -> description -> compiled scene -> tiles -> film -> file.
#include "../preview/preview_server.h"
#include "batch.h"
#include "interrupts.h"
#include "rt/app/commands.h"
#include "rt/core/error.h"
#include "run_console.h"
#include "watcher.h"

#include <string>
#include <vector>

namespace rt {
namespace {

/// Runs once, and shows what came of it until somebody closes the page or a signal comes.
int shown(Batch& batch, RunConsole& console, PreviewBoard& board) {
    board.beginRound();
    const int code = batch.run();
    board.endRound();
    if (Interrupts::exitCode() == 0) {
        console.tell("The preview stays until Ctrl-C, or Close on the page");
        board.waitForStop();
    }
    return code;
}

/// Runs again whenever a file changes, until a signal ends it.
int watched(Batch& batch, RunConsole& console, PreviewBoard* board) {
    Watcher watcher;
    console.add(watcher);
    while (true) {
        watcher.beginRound();
        if (board) board->beginRound();
        batch.run();
        if (Interrupts::exitCode() != 0) return Interrupts::exitCode();
        watcher.endRound();
        if (board) board->endRound();
        if (!watcher.isStale()) {
            const std::size_t files = watcher.fileCount();
            console.tell("Watching " + std::to_string(files) + (files == 1 ? " file" : " files") +
                         "; renders again when one changes; Ctrl-C ends");
        }
        const std::vector<std::string> changed = watcher.changes();
        console.tell("Changed: " + printable(changed.front(), 300) +
                     (changed.size() > 1 ? ", ..." : ""));
        batch.forget(changed);
    }
}

}  // namespace

int renderCommand(const Options& options) {
    requireDefaultScene(options);
    Interrupts::handle();
    RunConsole console(options);
    Batch batch(options, console);
    if (!options.preview) return options.watch ? watched(batch, console, nullptr) : batch.run();
    PreviewServer server(options.previewPort, options.watch);
    console.add(server.board());
    console.show("Preview: " + server.address());
    return options.watch ? watched(batch, console, &server.board())
                         : shown(batch, console, server.board());
}

}  // namespace rt
