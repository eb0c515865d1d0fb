#pragma once

#include "app/serve/connection.h"
#include "app/serve/json_rpc.h"
#include "app/serve/listener.h"
#include "app/serve/service.h"

#include <chrono>
#include <deque>
#include <list>
#include <string>

namespace vitrine::app {

/// Serves whoever connects, one request after the other, in turn. Between the steps of a long one it goes on to accept,
/// read and send, so that it can be canceled: by `cancel` on its own connection, by closing that, or by a signal.
class Server {
public:
    static constexpr std::size_t mostConnections = 16;
    /// Of one connection, waiting; what lies beyond is not read yet.
    static constexpr std::size_t mostWaiting = 64;

    /// Both must outlive it. While all places are taken, a connection that sent nothing for `mayIdle` gives way to a
    /// new one.
    Server(const Listener& listener, Service& service, std::chrono::duration<double> mayIdle)
        : listener_(listener), service_(service), mayIdle_(mayIdle)
    {
    }
    /// Until `StopSignal::stopped()`.
    void run();

private:
    struct Client {
        Connection connection;
        int number = 0;  ///< For the log, from 1.
        std::deque<RpcRequest> waiting = {};
        std::size_t waitingBytes = 0;
        bool wantsEvents = false;
        std::chrono::steady_clock::time_point heard = std::chrono::steady_clock::now();  ///< Its last line came then.
    };
    /// What is being served, and for whom.
    struct Current {
        Client& client;
        const RpcRequest& request;
        bool canceled = false;
        std::chrono::steady_clock::time_point told = {};  ///< Of the last event about it.
    };

    /// Waits until there is something to do, or looks whether there is; takes in and sends what can be.
    void exchange(bool wait);
    void acceptAll();
    /// Ends the connection that was silent for longest, at least for `mayIdle`; false: there is none.
    bool endIdle();
    void takeIn(Client&);
    void takeRequest(Client&, RpcRequest);
    void serve(Client&);
    void answer(Client&, const RpcRequest&, const std::string& line);
    /// What is about connections and not the service's: true when `request` was that.
    bool served(Client&, const RpcRequest&);
    void cancel(Client&, const RpcRequest&);
    void watch(double part, const std::string& doing);
    void tellProgress(const std::string& event, render::Json params);
    void tellChanges(const Client& by);
    /// But for the one that is being served.
    void removeEnded();
    /// Whether more may be read of what it asks for.
    [[nodiscard]] static bool mayAsk(const Client&);
    /// Whether its next request is to be served: only who reads its answers gets more.
    [[nodiscard]] static bool isNext(const Client&);

    const Listener& listener_;
    Service& service_;
    std::chrono::duration<double> mayIdle_;
    std::list<Client> clients_;  ///< Keep their place.
    Current* current_ = nullptr;
    int lastNumber_ = 0;
};

}  // namespace vitrine::app
