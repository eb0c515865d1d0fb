#pragma once

#include "render/files/descriptor.h"

#include <sys/types.h>

#include <optional>
#include <string>

namespace vitrine::app {

/// Unix stream socket in the file system, for its owner only. Its mode is 0600, and connections of another user
/// (SO_PEERCRED) are closed.
class Listener {
public:
    /// Listens at `path`. Replaces the socket of a server that has ended. Throws Failure: ErrorKind::usage if a server
    /// is running there or the path is too long, ErrorKind::file if anything else is there or it cannot be made.
    explicit Listener(std::string path);
    /// Removes the socket, unless something else has taken its place.
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    /// Returns the descriptor to poll: readable while a client is waiting.
    [[nodiscard]] int descriptor() const { return socket_.get(); }
    /// Accepts a waiting client as a nonblocking socket, if there is one. Connections of other users are closed.
    [[nodiscard]] std::optional<render::Descriptor> accept() const;

private:
    std::string path_;
    render::Descriptor socket_;
    dev_t device_ = 0;
    ino_t inode_ = 0;
};

}  // namespace vitrine::app
