// The way from a browser to the board: a socket on the loopback address, and the plugin's server.
#pragma once

#include "preview_board.h"

#include <memory>
#include <string>

namespace rt {

class PreviewServer {
  public:
    /// Listens on 127.0.0.1 and `port`, 0 for any that is free, and opens the plugin. Throws
    /// OutputError that says what to do.
    PreviewServer(int port, bool watching);
    ~PreviewServer();
    PreviewServer(const PreviewServer&) = delete;
    PreviewServer& operator=(const PreviewServer&) = delete;

    PreviewBoard& board() { return *board_; }
    /// "http://127.0.0.1:8318/".
    std::string address() const;

  private:
    int port_ = 0;
    std::unique_ptr<PreviewBoard> board_;
    void* server_ = nullptr;
    void (*end_)(void*) = nullptr;
};

}  // namespace rt
