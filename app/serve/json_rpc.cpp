#include "app/serve/json_rpc.h"

#include <cctype>
#include <new>

namespace vitrine::app {
namespace {

using render::Json;

std::string lineOf(const Json& json)
{
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string errorLine(const Json& id, int code, const std::string& message, const Json& data)
{
    Json error{{"code", code}, {"message", message}};
    if (!data.is_null()) error["data"] = data;
    return lineOf(Json{{"jsonrpc", "2.0"}, {"id", id}, {"error", error}});
}

std::string kindName(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::check: return "check";
    case ErrorKind::usage: return "usage";
    case ErrorKind::openGl: return "openGl";
    case ErrorKind::shader: return "shader";
    case ErrorKind::file: break;
    }
    return "file";
}

/// Parser that finds the id of a refused request: the first member "id" of the outermost object, as far as the text is
/// JSON. Ignores everything else.
class IdSeeker final : public nlohmann::json_sax<Json> {
public:
    [[nodiscard]] const Json& id() const { return id_; }

    bool null() override { return true; }
    bool boolean(bool) override { return plain(nullptr); }
    bool number_integer(number_integer_t x) override { return plain(x); }
    bool number_unsigned(number_unsigned_t x) override { return plain(x); }
    bool number_float(number_float_t x, const string_t&) override { return plain(x); }
    bool string(string_t& x) override { return plain(x.find('\0') == std::string::npos ? Json(x) : Json()); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override
    {
        isNext_ = false;
        return ++depth_ < rpcLimits.depth;
    }
    bool start_array(std::size_t) override { return start_object(0) && depth_ > 1; }
    bool end_object() override { return --depth_ > 0; }
    bool end_array() override { return --depth_ > 0; }
    bool key(string_t& name) override
    {
        isNext_ = depth_ == 1 && name == "id";
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

private:
    bool plain(Json value)
    {
        if (isNext_) id_ = std::move(value);
        return !isNext_;
    }

    Json id_;
    std::size_t depth_ = 0;
    bool isNext_ = false;
};

/// Returns the id in a line that is no valid request, so that the client can assign the error; null if there is none.
Json idIn(const std::string& line)
{
    IdSeeker seeker;
    (void)Json::sax_parse(line, &seeker);
    return seeker.id();
}

/// Converts the root to a request. Throws RpcFailure if it is none.
RpcRequest requestOf(Json& root)
{
    if (root.is_array())
        throw RpcFailure(RpcCode::request, "Batches are not taken; send one request a line, without brackets.");
    if (!root.is_object()) throw RpcFailure(RpcCode::request, "A request is an object with jsonrpc, method and id.");
    RpcRequest request;
    request.wantsAnswer = root.contains("id");
    if (request.wantsAnswer) {
        const Json& id = root["id"];
        if (!id.is_string() && !id.is_number() && !id.is_null())
            throw RpcFailure(RpcCode::request, "id: give a text or a number.");
        request.id = id;
    }
    const auto refuse = [&](const std::string& message) { return RpcFailure(RpcCode::request, message, request.id); };
    for (const auto& [key, value] : root.items())
        if (key != "jsonrpc" && key != "id" && key != "method" && key != "params")
            throw refuse("A request has no \"" + key + "\"; it has jsonrpc, id, method and params.");
    if (!root.contains("jsonrpc") || root["jsonrpc"] != "2.0")
        throw refuse("jsonrpc: this service speaks version \"2.0\" only.");
    if (!root.contains("method") || !root["method"].is_string()) throw refuse("method: give a name, such as \"list\".");
    request.method = root["method"].get<std::string>();
    if (!root.contains("params")) return request;
    if (!root["params"].is_object())
        throw RpcFailure(RpcCode::params, "params: give an object; here they go by name.", request.id);
    request.params = std::move(root["params"]);
    return request;
}

}  // namespace

RpcRequest parseRequest(const std::string& line)
{
    const std::size_t bytes = line.size();
    try {
        render::JsonDocument document = render::parseJson(line, "The request", rpcLimits);
        RpcRequest request = requestOf(document.root());
        request.bytes = bytes;
        return request;
    } catch (const Failure& failure) {
        throw RpcFailure(RpcCode::parse, failure.what(), idIn(line));
    }
}

std::string answerLine(const Json& id, const Json& result)
{
    return lineOf(Json{{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
}

std::string errorLine(const Json& id, RpcCode code, const std::string& message)
{
    return errorLine(id, static_cast<int>(code), message, nullptr);
}

std::string errorLine(const Json& id, const std::exception& error)
{
    if (const auto* refused = dynamic_cast<const RpcFailure*>(&error))
        return errorLine(id, refused->code(), refused->what());
    if (const auto* failure = dynamic_cast<const Failure*>(&error)) {
        const int code = failure->kind() == ErrorKind::usage
                             ? static_cast<int>(RpcCode::params)
                             : static_cast<int>(RpcCode::ofFailure) - failure->exitCode();
        return errorLine(id, code, withoutDashes(failure->what()),
                         Json{{"kind", kindName(failure->kind())}, {"exitCode", failure->exitCode()}});
    }
    if (dynamic_cast<const std::bad_alloc*>(&error))
        return errorLine(id, RpcCode::params,
                         "There was not enough memory for this; ask for a smaller size, or fewer samples or views.");
    return errorLine(id, RpcCode::internal, error.what());
}

std::string eventLine(const std::string& method, const Json& params)
{
    return lineOf(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
}

std::string withoutDashes(const std::string& message)
{
    std::string text;
    bool quoted = false;  // Inside of `backquotes`.
    bool option = false;  // Inside of an option's name.
    for (std::size_t i = 0; i < message.size(); ++i) {
        const char c = message[i];
        if (c == '`') quoted = !quoted;
        const bool starts = !quoted && (i == 0 || message[i - 1] == ' ') && message.compare(i, 2, "--") == 0 &&
                            i + 2 < message.size() && std::islower(static_cast<unsigned char>(message[i + 2])) != 0;
        if (starts) {
            option = true;
            ++i;
            continue;
        }
        option = option && (std::islower(static_cast<unsigned char>(c)) != 0 || c == '-');
        text += option && c == '-' ? '_' : c;
    }
    return text;
}

}  // namespace vitrine::app
