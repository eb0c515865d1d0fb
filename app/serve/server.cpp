#include "app/serve/server.h"

#include "app/serve/params.h"
#include "render/failure.h"

#include <CLI/CLI.hpp>

#include <poll.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <vector>

namespace vitrine::app {
namespace {

using render::Json;
using std::chrono::steady_clock;

/// Least time between two progress events of a request.
constexpr std::chrono::milliseconds progressPause{100};
/// Largest time of a wait while a dropped connection has to be removed.
constexpr int dropWaitMilliseconds = 500;

const std::string tooLong = "A line has more than " + std::to_string(Connection::mostLineBytes) +
                            " bytes; it was left out. Send less at once, or name a file.";

}  // namespace

void Server::run()
{
    while (!stop_.isAsked()) {
        for (Client& client : clients_) takeIn(client);
        removeEnded();
        exchange(std::none_of(clients_.begin(), clients_.end(), isNext));
        for (auto client = clients_.begin(); client != clients_.end() && !stop_.isAsked(); ++client)
            if (isNext(*client)) serve(*client);
    }
    for (Client& client : clients_)
        client.connection.drop(errorLine(nullptr, RpcCode::dropped, "The server was stopped."));
}

bool Server::mayAsk(const Client& client)
{
    return client.waiting.size() < mostWaiting && client.waitingBytes < Connection::mostLineBytes &&
           client.connection.keepsUp() && !client.connection.dropped();
}

bool Server::isNext(const Client& client)
{
    return !client.waiting.empty() && client.connection.keepsUp();
}

void Server::exchange(bool wait)
{
    // A request that is being handled keeps the scene state that it began with. Poll skips -1.
    const int changed = current_ ? -1 : service_.changedDescriptor();
    std::vector<pollfd> polled{
        {stop_.descriptor, POLLIN, 0}, {listener_.descriptor(), POLLIN, 0}, {changed, POLLIN, 0}};
    const std::size_t first = polled.size();
    std::vector<Client*> clients;
    bool anyDropped = false;
    for (Client& client : clients_) {
        const Connection& connection = client.connection;
        anyDropped = anyDropped || connection.dropped();
        // A closed connection with nothing left to read would end every poll at once.
        if (connection.hungUp() && (connection.inputEnded() || !mayAsk(client))) continue;
        int events = connection.hasUnsent() ? POLLOUT : 0;
        if (!connection.inputEnded() && (mayAsk(client) || connection.dropped())) events |= POLLIN;
        polled.push_back({connection.descriptor(), static_cast<short>(events), 0});
        clients.push_back(&client);
    }
    const int limit = !wait ? 0 : anyDropped ? dropWaitMilliseconds : -1;
    if (::poll(polled.data(), polled.size(), limit) < 0) return;
    for (std::size_t i = 0; i < clients.size(); ++i) {
        const short events = polled[first + i].revents;
        Client& client = *clients[i];
        if ((events & (POLLHUP | POLLERR)) != 0) client.connection.hangUp();
        if ((events & POLLOUT) != 0) client.connection.flush();
        if ((events & (POLLIN | POLLHUP)) != 0 && (mayAsk(client) || client.connection.dropped()))
            client.connection.receive();
    }
    for (Client& client : clients_) takeIn(client);
    removeEnded();
    if ((polled[1].revents & POLLIN) != 0) acceptAll();
    if ((polled[2].revents & POLLIN) == 0) return;
    service_.refresh();
    tellChanges(nullptr);
}

void Server::acceptAll()
{
    // Limited, so that a flood of connections does not block the others.
    for (std::size_t i = 0; i < mostConnections; ++i) {
        std::optional<render::Descriptor> socket = listener_.accept();
        if (!socket) return;
        Client client{Connection(std::move(*socket))};
        client.number = ++lastNumber_;
        const auto open = std::count_if(clients_.begin(), clients_.end(),
                                        [](const Client& other) { return !other.connection.dropped(); });
        if (open >= static_cast<std::ptrdiff_t>(mostConnections) && !endIdle()) {
            client.connection.send(errorLine(nullptr, RpcCode::dropped,
                                             "There are " + std::to_string(mostConnections) +
                                                 " connections already; close one and try again."));
            std::fprintf(stderr, "vitrine: connection %d was one too many.\n", client.number);
            continue;
        }
        clients_.push_back(std::move(client));
    }
}

bool Server::endIdle()
{
    Client* silent = nullptr;
    for (Client& client : clients_) {
        const bool busy = !client.waiting.empty() || (current_ && &client == &current_->client);
        if (!busy && !client.connection.dropped() && (!silent || client.heard < silent->heard)) silent = &client;
    }
    if (!silent || steady_clock::now() - silent->heard < mayIdle_) return false;
    silent->connection.drop(
        errorLine(nullptr, RpcCode::dropped,
                  "Nothing came on this connection for a while, and another one needs its place: it "
                  "ends here. Connect again."));
    std::fprintf(stderr, "vitrine: connection %d was idle and gave way to another one.\n", silent->number);
    return true;
}

void Server::takeIn(Client& client)
{
    Connection& connection = client.connection;
    while (mayAsk(client)) {
        std::optional<ReceivedLine> line = connection.takeLine();
        if (!line) return;
        client.heard = steady_clock::now();
        if (line->kind == ReceivedLine::Kind::tooLong) {
            connection.send(errorLine(nullptr, RpcCode::request, tooLong));
        } else if (line->kind == ReceivedLine::Kind::unfinished) {
            connection.send(errorLine(nullptr, RpcCode::parse, "The last line has no end; a request ends with one."));
        } else {
            try {
                takeRequest(client, parseRequest(std::move(line->text)));
            } catch (const RpcFailure& failure) {
                connection.send(errorLine(failure.id(), failure));
            } catch (const std::exception& error) {  // Such as a lack of memory.
                connection.send(errorLine(nullptr, error));
            }
        }
    }
}

void Server::takeRequest(Client& client, RpcRequest request)
{
    if (request.method == "cancel") {  // Handled at once, because its request is running or waiting.
        served(client, request);
        return;
    }
    client.waitingBytes += request.bytes;
    client.waiting.push_back(std::move(request));
}

void Server::answer(Client& client, const RpcRequest& request, const std::string& line)
{
    if (request.wantsAnswer) client.connection.send(line);
}

void Server::serve(Client& client)
{
    const RpcRequest request = std::move(client.waiting.front());
    client.waiting.pop_front();
    client.waitingBytes -= request.bytes;
    if (client.connection.dropped() || served(client, request)) return;
    Current current{client, request};
    current_ = &current;
    std::string how = "done";
    try {
        service_.refresh();
        tellChanges(nullptr);
        const Json result = service_.answer(request.method, request.params,
                                            [this](double part, const std::string& doing) { watch(part, doing); });
        answer(client, request, answerLine(request.id, result) + service_.takeBytes());
    } catch (const std::exception& error) {
        const auto* refused = dynamic_cast<const RpcFailure*>(&error);
        how = refused && refused->code() == RpcCode::canceled ? "canceled" : "failed";
        answer(client, request, errorLine(request.id, error));
    }
    if (current.told != steady_clock::time_point()) tellProgress("finished", Json{{"how", how}});
    current_ = nullptr;
    tellChanges(&client);
}

bool Server::served(Client& client, const RpcRequest& request)
{
    if (request.method != "events" && request.method != "cancel") return false;
    try {
        if (request.method == "cancel") {
            cancel(client, request);
            return true;
        }
        CLI::App options;
        bool off = false;
        options.add_flag("--off", off);
        readParams(options, "events", request.params);
        client.wantsEvents = !off;
        answer(client, request, answerLine(request.id, Json{{"events", client.wantsEvents}}));
    } catch (const Failure& failure) {
        answer(client, request, errorLine(request.id, failure));
    }
    return true;
}

void Server::cancel(Client& client, const RpcRequest& request)
{
    const Json* id = request.params.contains("id") ? &request.params["id"] : nullptr;
    if (request.params.size() != (id ? 1U : 0U))
        throw Failure(ErrorKind::usage, "cancel takes id, of a request of this connection, or nothing: all of them.");
    int count = 0;
    if (current_ && &current_->client == &client && !current_->canceled && (!id || current_->request.id == *id)) {
        current_->canceled = true;
        ++count;
    }
    std::deque<RpcRequest> kept;
    for (RpcRequest& waiting : client.waiting) {
        if (id && waiting.id != *id) {
            kept.push_back(std::move(waiting));
            continue;
        }
        ++count;
        client.waitingBytes -= waiting.bytes;
        answer(client, waiting, errorLine(waiting.id, RpcCode::canceled, waiting.method + " was canceled."));
    }
    client.waiting = std::move(kept);
    answer(client, request, answerLine(request.id, Json{{"canceled", count}}));
}

void Server::watch(double part, const std::string& doing)
{
    const auto now = steady_clock::now();
    if (current_->told == steady_clock::time_point() || now - current_->told >= progressPause) {
        tellProgress("progress", Json{{"part", part}, {"doing", doing}});
        current_->told = now;
    }
    exchange(false);
    const Connection& connection = current_->client.connection;
    if (!current_->canceled && !connection.hungUp() && !connection.dropped() && !stop_.isAsked()) return;
    throw RpcFailure(RpcCode::canceled,
                     current_->request.method + (stop_.isAsked() ? ": the server was stopped." : " was canceled."));
}

void Server::tellProgress(const std::string& event, Json params)
{
    for (Client& client : clients_) {
        if (!client.wantsEvents) continue;
        const bool own = &client == &current_->client;
        Json told{{"method", current_->request.method}, {"own", own}};
        told["id"] = own ? current_->request.id : Json(nullptr);
        told.update(params);
        client.connection.send(eventLine(event, told));
    }
}

void Server::tellChanges(const Client* by)
{
    for (const Json& change : service_.takeChanges())
        for (Client& client : clients_)
            if (client.wantsEvents && &client != by) client.connection.send(eventLine("changed", change));
}

void Server::removeEnded()
{
    clients_.remove_if([this](const Client& client) {
        const Connection& connection = client.connection;
        if (current_ && &client == &current_->client) return false;
        if (connection.over() && connection.hasUnsent())
            std::fprintf(stderr, "vitrine: connection %d was dropped: it did not read.\n", client.number);
        if (connection.dropped()) return connection.over();
        return connection.inputEnded() && client.waiting.empty() && !connection.hasUnsent();
    });
}

}  // namespace vitrine::app
