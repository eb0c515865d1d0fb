#include "app/serve/listener.h"

#include "render/failure.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace vitrine::app {
namespace {

using render::Descriptor;

Failure fileFailure(const std::string& path, const std::string& problem)
{
    return {ErrorKind::file, "The socket " + path + ": " + problem};
}

sockaddr_un addressOf(const std::string& path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.empty() || path.size() >= sizeof address.sun_path)
        throw Failure(ErrorKind::usage, "The socket " + path + ": a socket's path has 1 to " +
                                            std::to_string(sizeof address.sun_path - 1) + " bytes, and this one has " +
                                            std::to_string(path.size()) + "; choose a shorter one.");
    std::memcpy(address.sun_path, path.data(), path.size());
    return address;
}

/// Locks the folder while the path is checked and bound, so that two servers that start at once do not collide.
Descriptor lockedFolder(const std::string& path)
{
    const std::filesystem::path parent = std::filesystem::path(path).parent_path();
    const std::string folder = parent.empty() ? "." : parent.string();
    Descriptor lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!lock.open())
        throw fileFailure(path, "its folder cannot be opened (" + std::string(std::strerror(errno)) +
                                    "); make it, or choose another.");
    if (::flock(lock.get(), LOCK_EX) != 0)
        throw fileFailure(path, "its folder cannot be locked (" + std::string(std::strerror(errno)) + ").");
    return lock;
}

/// Removes the socket of a server that has ended. Throws Failure if anything else is there.
void removeStale(const std::string& path, const sockaddr_un& address)
{
    struct stat found {};
    if (::lstat(path.c_str(), &found) != 0) return;  // Nothing is there, or `bind` will report the error.
    if (!S_ISSOCK(found.st_mode))
        throw fileFailure(path, "there is a file that is not a socket; it was left alone. Choose another path.");
    const Descriptor trial(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    if (::connect(trial.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 || errno == EAGAIN)
        throw Failure(ErrorKind::usage,
                      "The socket " + path + ": another server answers there; stop it first, or choose another path.");
    if (errno != ECONNREFUSED)
        throw fileFailure(path, "it cannot be found out whether a server answers there (" +
                                    std::string(std::strerror(errno)) + "); choose another path.");
    if (::unlink(path.c_str()) != 0)
        throw fileFailure(path, "what a server left there cannot be removed (" + std::string(std::strerror(errno)) +
                                    "); choose another path.");
}

}  // namespace

Listener::Listener(std::string path) : path_(std::move(path))
{
    const sockaddr_un address = addressOf(path_);
    const Descriptor lock = lockedFolder(path_);
    removeStale(path_, address);
    socket_ = Descriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const mode_t before = ::umask(0177);  // The socket must never be accessible to others.
    const bool bound =
        socket_.open() && ::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    const int error = errno;
    ::umask(before);
    if (!bound)
        throw fileFailure(path_, "no socket can be made there (" + std::string(std::strerror(error)) +
                                     "); choose a folder that you may write to.");
    struct stat made {};
    if (::lstat(path_.c_str(), &made) != 0 || ::listen(socket_.get(), SOMAXCONN) != 0) {
        const int why = errno;
        ::unlink(path_.c_str());
        throw fileFailure(path_, "the socket cannot be used (" + std::string(std::strerror(why)) + ").");
    }
    device_ = made.st_dev;
    inode_ = made.st_ino;
}

Listener::~Listener()
{
    struct stat now {};
    if (::lstat(path_.c_str(), &now) == 0 && now.st_dev == device_ && now.st_ino == inode_) ::unlink(path_.c_str());
}

std::optional<Descriptor> Listener::accept() const
{
    while (true) {
        Descriptor client(::accept4(socket_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
        if (!client.open()) {
            if (errno == EINTR || errno == ECONNABORTED) continue;
            return std::nullopt;
        }
        ucred peer{};
        socklen_t size = sizeof peer;
        if (::getsockopt(client.get(), SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 && peer.uid == ::geteuid())
            return client;
        std::fprintf(stderr, "vitrine: user %lu was turned away at %s.\n", static_cast<unsigned long>(peer.uid),
                     path_.c_str());
    }
}

}  // namespace vitrine::app
