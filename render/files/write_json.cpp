#include "render/files/number_text.h"
#include "render/files/strict_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vitrine::render {
namespace {

constexpr std::array<char, 16> hexDigits = {'0', '1', '2', '3', '4', '5', '6', '7',
                                            '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};

void appendUnit(std::string& out, std::uint32_t unit)
{
    out += "\\u";
    for (unsigned shift = 16; shift > 0; shift -= 4) out += hexDigits.at((unit >> (shift - 4)) & 0xFU);
}

/// Decodes the code point at `i` and moves `i` behind it; false when the bytes there are not UTF-8.
bool nextCodePoint(std::string_view text, std::size_t& i, std::uint32_t& point)
{
    const auto byte = [&](std::size_t k) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[k])); };
    const std::uint32_t lead = byte(i);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || i + length > text.size()) return false;
    point = length == 1 ? lead : lead & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length; ++k) {
        if ((byte(i + k) & 0xC0U) != 0x80U) return false;
        point = point << 6U | (byte(i + k) & 0x3FU);
    }
    const bool overlong = (length == 3 && point < 0x800) || (length == 4 && point < 0x10000);
    if (overlong || (point >= 0xD800 && point < 0xE000) || point > 0x10FFFF) return false;
    i += length;
    return true;
}

class Writer {
public:
    explicit Writer(KeyOrder order) : order_(order) {}

    void write(const Json& json, int depth)
    {
        switch (json.type()) {
        case Json::value_t::object: writeObject(json, depth); break;
        case Json::value_t::array: writeArray(json, depth); break;
        case Json::value_t::string: writeString(json.get_ref<const std::string&>()); break;
        case Json::value_t::number_float: writeNumber(json.get<double>()); break;
        case Json::value_t::number_integer: out += std::to_string(json.get<std::int64_t>()); break;
        case Json::value_t::number_unsigned: out += std::to_string(json.get<std::uint64_t>()); break;
        case Json::value_t::boolean: out += json.get<bool>() ? "true" : "false"; break;
        default: out += "null"; break;
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
        using Entry = std::pair<const std::string*, const Json*>;
        std::vector<Entry> entries;
        for (const auto& [key, value] : json.items()) entries.emplace_back(&key, &value);
        if (order_ == KeyOrder::sorted) {
            std::stable_sort(entries.begin(), entries.end(),
                             [](const Entry& a, const Entry& b) { return *a.first < *b.first; });
        }
        const std::size_t parent = path_.size();
        out += '{';
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (i > 0) out += ',';
            newline(depth + 1);
            path_ += (parent == 0 ? "" : ".") + *entries[i].first;
            writeString(*entries[i].first);
            out += ": ";
            write(*entries[i].second, depth + 1);
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
        out += '"';
        for (std::size_t i = 0; i < text.size();) {
            const std::size_t start = i;
            std::uint32_t point = 0;
            if (!nextCodePoint(text, i, point)) fail("holds text that is not UTF-8; retype it.");
            if (point == '"' || point == '\\')
                (out += '\\') += static_cast<char>(point);
            else if (point == '\n')
                out += "\\n";
            else if (point == '\t')
                out += "\\t";
            else if (point < 0x20 || point == 0x7F)
                appendUnit(out, point);
            else
                out.append(text, start, i - start);
        }
        out += '"';
    }

    KeyOrder order_;
    std::string path_;
};

}  // namespace

std::string writeJson(const Json& json, KeyOrder order)
{
    Writer writer(order);
    writer.write(json, 0);
    return std::move(writer.out) + '\n';
}

std::string asciiJson(std::string_view utf8Json)
{
    std::string out;
    for (std::size_t i = 0; i < utf8Json.size();) {
        std::uint32_t point = 0;
        if (!nextCodePoint(utf8Json, i, point)) throw Failure(Blame::file, "Cannot write JSON: the text is not UTF-8.");
        if (point < 0x80) {
            out += static_cast<char>(point);
        } else if (point < 0x10000) {
            appendUnit(out, point);
        } else {
            appendUnit(out, 0xD800 + ((point - 0x10000) >> 10U));
            appendUnit(out, 0xDC00 + ((point - 0x10000) & 0x3FFU));
        }
    }
    return out;
}

}  // namespace vitrine::render
