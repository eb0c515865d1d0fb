#include "render/files/number_text.h"
#include "render/files/strict_json.h"

#include <algorithm>
#include <cmath>

namespace vitrine::render {
namespace {

/// Returns a string in quotes.
std::string quoted(const std::string& text, bool ascii)
{
    return Json(text).dump(-1, ' ', ascii);  // Throws type_error for invalid UTF-8.
}

/// JSON formatter. The library's own one puts each number of an array on its own line, names no key in its errors, and
/// writes null for numbers that are not finite.
class JsonWriter {
public:
    void write(const Json& json, int depth)
    {
        switch (json.type()) {
        case Json::value_t::object: writeObject(json, depth); break;
        case Json::value_t::array: writeArray(json, depth); break;
        case Json::value_t::string: writeString(json.get_ref<const std::string&>()); break;
        case Json::value_t::number_float: writeNumber(json.get<double>()); break;
        default: out += json.dump(); break;
        }
    }

    std::string out;

private:
    [[noreturn]] void fail(const std::string& problem) const
    {
        throw Failure(Blame::file, "Cannot write JSON: " + (path_.empty() ? "the value" : path_) + " " + problem);
    }

    void newline(int depth) { out += '\n' + std::string(2 * static_cast<std::size_t>(depth), ' '); }

    void writeObject(const Json& json, int depth)
    {
        if (json.empty()) {
            out += "{}";
            return;
        }
        const std::size_t parent = path_.size();
        out += '{';
        for (auto entry = json.begin(); entry != json.end(); ++entry) {
            if (entry != json.begin()) out += ',';
            newline(depth + 1);
            path_ += (parent == 0 ? "" : ".") + entry.key();
            writeString(entry.key());
            out += ": ";
            write(*entry, depth + 1);
            path_.resize(parent);
        }
        newline(depth);
        out += '}';
    }

    void writeArray(const Json& json, int depth)
    {
        const bool oneLine = std::all_of(json.begin(), json.end(), [](const Json& x) { return x.is_number(); });
        const std::size_t parent = path_.size();
        out += '[';
        for (std::size_t i = 0; i < json.size(); ++i) {
            if (i > 0) out += oneLine ? ", " : ",";
            if (!oneLine) newline(depth + 1);
            path_ += '[' + std::to_string(i) + ']';
            write(json[i], depth + 1);
            path_.resize(parent);
        }
        if (!oneLine) newline(depth);
        out += ']';
    }

    void writeNumber(double x)
    {
        if (!std::isfinite(x)) fail("is not a finite number; reset it.");
        const std::string text = shortestNumber(x);
        out += text;
        if (text.find_first_of(".e") == std::string::npos) out += ".0";
    }

    void writeString(const std::string& text)
    {
        try {
            out += quoted(text, false);
        } catch (const Json::type_error&) {
            fail("holds text that is not UTF-8; retype it.");
        }
    }

    std::string path_;
};

}  // namespace

std::string writeJson(const Json& json)
{
    JsonWriter writer;
    writer.write(json, 0);
    return std::move(writer.out) + '\n';
}

std::string asciiJson(std::string_view utf8Json)
{
    const auto isAscii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
    std::string out;
    for (auto at = utf8Json.begin(); at != utf8Json.end();) {
        const auto beyond = std::find_if_not(at, utf8Json.end(), isAscii);
        out.append(at, beyond);
        at = std::find_if(beyond, utf8Json.end(), isAscii);
        try {
            const std::string escaped = quoted(std::string(beyond, at), true);
            out.append(escaped, 1, escaped.size() - 2);
        } catch (const Json::type_error&) {
            throw Failure(Blame::file, "Cannot write JSON: the text is not UTF-8.");
        }
    }
    return out;
}

}  // namespace vitrine::render
