#pragma once

#include "app/serve/connection.h"
#include "app/serve/json_rpc.h"
#include "app/serve/listener.h"
#include "app/serve/service.h"

#include <chrono>
#include <deque>
#include <functional>
#include <list>
#include <string>

namespace vitrine::app {

/// Orderly stop of a server.
struct ServerStop {
    std::function<bool()> isAsked;
    int descriptor = -1;  ///< Readable once it is.
};

/// Server that handles the requests of all connections, one after the other, in turn. Between the steps of a long
/// request it accepts, reads and sends. A request is canceled by `cancel` on its own connection, by closing that, or by
/// a signal.
class Server {
public:
    static constexpr std::size_t mostConnections = 16;
    /// Most waiting requests of one connection; further ones are not read yet.
    static constexpr std::size_t mostWaiting = 64;

    /// Both must outlive the server. If all places are taken, a new connection replaces one that sent nothing for
    /// `mayIdle` seconds.
    Server(const Listener& listener, Service& service, std::chrono::duration<double> mayIdle, ServerStop stop)
        : listener_(listener), service_(service), mayIdle_(mayIdle), stop_(std::move(stop))
    {
    }
    /// Runs until the stop is asked for.
    void run();

private:
    struct Client {
        Connection connection;
        int number = 0;  ///< Number for the log, from 1.
        std::deque<RpcRequest> waiting = {};
        std::size_t waitingBytes = 0;
        bool wantsEvents = false;
        std::chrono::steady_clock::time_point heard = std::chrono::steady_clock::now();  ///< Time of its last line.
    };
    /// Request that is being handled, and its client.
    struct Current {
        Client& client;
        const RpcRequest& request;
        bool canceled = false;
        std::chrono::steady_clock::time_point told = {};  ///< Time of its last progress event.
    };

    /// Accepts, receives and sends as much as possible. `wait`: waits until there is something to do.
    void exchange(bool wait);
    void acceptAll();
    /// Drops the connection that was silent for longest, if it was for `mayIdle`. Returns false if there is none.
    bool endIdle();
    void takeIn(Client&);
    void takeRequest(Client&, RpcRequest);
    void serve(Client&);
    void answer(Client&, const RpcRequest&, const std::string& line);
    /// Handles requests about the connection itself. Returns whether `request` was one.
    bool served(Client&, const RpcRequest&);
    void cancel(Client&, const RpcRequest&);
    void watch(double part, const std::string& doing);
    void tellProgress(const std::string& event, render::Json params);
    /// Tells all clients but this one (null: all) what was changed.
    void tellChanges(const Client* by);
    /// Removes ended connections, except for the one that is being served.
    void removeEnded();
    /// Returns whether more of the client's requests may be read.
    [[nodiscard]] static bool mayAsk(const Client&);
    /// Returns whether the client's next request may be served: it must read its answers.
    [[nodiscard]] static bool isNext(const Client&);

    const Listener& listener_;
    Service& service_;
    std::chrono::duration<double> mayIdle_;
    ServerStop stop_;
    std::list<Client> clients_;  ///< A list, because its elements stay in place.
    Current* current_ = nullptr;
    int lastNumber_ = 0;
};

}  // namespace vitrine::app
