#pragma once

#include "render/files/descriptor.h"

#include <sys/types.h>

#include <optional>
#include <string>

namespace vitrine::app {

/// A Unix stream socket in the file system that only its owner can connect to: its mode is 0600, and whoever connects
/// all the same is asked for his user (SO_PEERCRED) and turned away unless it is ours.
class Listener {
public:
    /// Listens at `path`. A socket that a dead server left there is replaced. Throws Failure (Blame::usage) when a
    /// server is alive there or the path is too long, Blame::file when something else lies there or it cannot be made.
    explicit Listener(std::string path);
    /// Removes the socket, unless something else has taken its place.
    ~Listener();
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    /// To poll: readable while somebody waits.
    [[nodiscard]] int descriptor() const { return socket_.get(); }
    /// Whoever waits, nonblocking; nothing where nobody does. Strangers are closed.
    [[nodiscard]] std::optional<render::Descriptor> accept() const;

private:
    std::string path_;
    render::Descriptor socket_;
    dev_t device_ = 0;
    ino_t inode_ = 0;
};

}  // namespace vitrine::app
