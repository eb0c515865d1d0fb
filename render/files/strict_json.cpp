#include "render/files/strict_json.h"

#include "render/files/byte_order_mark.h"
#include "render/files/json_span.h"
#include "render/files/number_text.h"
#include "render/files/read_file.h"
#include "render/files/text_position.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_set>
#include <vector>

namespace vitrine::render {
namespace {

/// Text that is passed to the library's lexer, with the number of characters read so far. The library's events carry no
/// position.
struct TakenText {
    std::string_view text;
    std::size_t taken = 0;
};

class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(TakenText& source, std::size_t at) : source_(&source), at_(source.text.data() + at) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++()
    {
        ++at_;
        ++source_->taken;
        return *this;
    }
    CountingIterator operator++(int)
    {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return at_ == other.at_; }

private:
    TakenText* source_;
    const char* at_;
};

/// Returns the position of the last character read.
TextPosition positionIn(const TakenText& source)
{
    return positionAt(source.text, source.taken > 0 ? source.taken - 1 : 0);
}

/// Records the position of each value during parsing. The library reports a value when its last character is read.
class SpanRecorder {
public:
    explicit SpanRecorder(const TakenText& source) : source_(source) {}

    void key()
    {
        const auto [begin, end] = token();
        keyBegin_ = begin;
        keyEnd_ = end;
    }
    void value(JsonSpan::Type type)
    {
        const auto [begin, end] = token();
        add({.type = type, .begin = begin, .end = end});
    }
    void open(JsonSpan::Type type)
    {
        value(type);
        open_.push_back({static_cast<std::uint32_t>(spans.size() - 1)});
    }
    void close()
    {
        spans[open_.back().span].end = token().end;
        open_.pop_back();
    }

    std::vector<JsonSpan> spans;

private:
    struct Token {
        std::uint32_t begin, end;
    };
    struct OpenSpan {
        std::uint32_t span;
        std::uint32_t lastChild = JsonSpan::none;
    };

    /// Returns the token that was read last. After a number, the library has also read the next character.
    Token token()
    {
        const std::string_view text = source_.text.substr(0, source_.taken);
        std::size_t begin = end_;
        while (begin < text.size() && isBetweenJsonTokens(text[begin])) ++begin;
        const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
        end_ = text.size();
        if (begin < end_ && (isDigit(text[begin]) || text[begin] == '-') && !isDigit(text[end_ - 1])) --end_;
        return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end_)};
    }
    void add(JsonSpan span)
    {
        span.keyBegin = keyBegin_;
        span.keyEnd = keyEnd_;
        keyBegin_ = keyEnd_ = 0;
        const auto index = static_cast<std::uint32_t>(spans.size());
        if (!open_.empty()) {
            OpenSpan& parent = open_.back();
            span.parent = parent.span;
            (parent.lastChild == JsonSpan::none ? spans[parent.span].firstChild : spans[parent.lastChild].next) = index;
            parent.lastChild = index;
        }
        spans.push_back(span);
    }

    const TakenText& source_;
    std::size_t end_ = 0;  // End of the previous token.
    std::uint32_t keyBegin_ = 0, keyEnd_ = 0;
    std::vector<OpenSpan> open_;
};

/// An object or array that is not complete yet.
struct JsonLevel {
    Json value;  // Contains the children that are complete.
    std::unordered_set<std::string> keys{};
    std::string key{};  // The last key.
};

/// Builds the tree of a text, with the checks of `parseJson`. If requested, it also finds the line of a key path and
/// records the position of every value.
class JsonReader final : public nlohmann::json_sax<Json> {
public:
    /// Text and limits must outlive the reader.
    JsonReader(std::string_view text, const JsonLimits& limits, std::string_view wantedPath = {})
        : source_{text}, limits_(limits), wanted_(wantedPath)
    {
    }

    /// Throws Failure, as `parseJson` does.
    [[nodiscard]] Json read(const std::string& name);
    /// Like `read`, but returns positions instead of values.
    [[nodiscard]] std::vector<JsonSpan> places(const std::string& name);
    /// Line of the longest prefix of the wanted path that exists.
    [[nodiscard]] int wantedLine() const { return wantedLine_; }

    bool null() override { return plain(JsonSpan::Type::null, nullptr); }
    bool boolean(bool x) override { return plain(JsonSpan::Type::boolean, x); }
    bool number_integer(number_integer_t x) override { return plain(JsonSpan::Type::number, x); }
    bool number_unsigned(number_unsigned_t x) override { return plain(JsonSpan::Type::number, x); }
    bool number_float(number_float_t x, const string_t& /*text*/) override { return plain(JsonSpan::Type::number, x); }
    bool binary(binary_t& /*bytes*/) override { return refuse(message("JSON has no binary values")); }
    bool string(string_t& x) override;
    bool start_object(std::size_t /*size*/) override { return open(JsonSpan::Type::object, Json::object()); }
    bool start_array(std::size_t /*size*/) override { return open(JsonSpan::Type::array, Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& x) override;
    bool parse_error(std::size_t position, const std::string& lastToken, const nlohmann::detail::exception& e) override;

private:
    bool refuse(Message why)
    {
        problem_ = std::move(why);
        return false;
    }
    bool count();
    bool plain(JsonSpan::Type type, Json value)
    {
        if (!count()) return false;
        if (recorder_) recorder_->value(type);
        add(std::move(value));
        return true;
    }
    bool open(JsonSpan::Type, Json empty);
    bool close();
    void add(Json value);
    [[nodiscard]] std::string path() const;
    void comparePath();

    TakenText source_;
    SpanRecorder* recorder_ = nullptr;
    const JsonLimits& limits_;
    std::string_view wanted_;
    Json root_;
    std::vector<JsonLevel> levels_;
    std::size_t nodes_ = 0;
    Message problem_;
    bool numberEnded_ = false;  ///< The error is in a number, which ends before the last character read.
    std::size_t longestFound_ = 0;
    int wantedLine_ = 1;
};

Message shortenTo(std::size_t bytes)
{
    return message("{1} bytes; shorten it", bytes);
}

bool JsonReader::string(string_t& x)
{
    if (x.size() > limits_.stringBytes)
        return refuse(message("this string is longer than {1}", shortenTo(limits_.stringBytes)));
    if (x.find('\0') != std::string::npos)
        return refuse(message("this string contains the character U+0000; remove it"));
    return plain(JsonSpan::Type::string, std::move(x));
}

bool JsonReader::key(string_t& x)
{
    if (x.size() > limits_.stringBytes)
        return refuse(message("this key is longer than {1}", shortenTo(limits_.stringBytes)));
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    if (std::any_of(x.begin(), x.end(), isControl))
        return refuse(message("a key contains a control character; remove it"));
    JsonLevel& level = levels_.back();
    level.key = x;
    if (!level.keys.insert(std::move(x)).second)
        return refuse(message("this key appears twice; remove one of the two"));
    if (recorder_) recorder_->key();
    comparePath();
    return true;
}

bool JsonReader::parse_error(std::size_t /*position*/, const std::string& lastToken,
                             const nlohmann::detail::exception& e)
{
    constexpr int outOfRange = 406;
    numberEnded_ = e.id == outOfRange;
    if (numberEnded_) return refuse(message("the number {1} is too large; numbers end at 1.8e308", lastToken));
    // The library's text is "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while ...".
    std::string what = e.what();
    if (const std::size_t colon = what.find(": "); colon != std::string::npos) what.erase(0, colon + 2);
    return refuse(message("this is not valid JSON ({1}); correct it there", what));
}

bool JsonReader::count()
{
    if (!levels_.empty() && levels_.back().value.is_array()) comparePath();
    if (++nodes_ > limits_.nodes) return refuse(message("the file holds more than {1} values", limits_.nodes));
    return true;
}

bool JsonReader::open(JsonSpan::Type type, Json empty)
{
    if (!count()) return false;
    if (levels_.size() >= limits_.depth)
        return refuse(message("objects and arrays are nested more than {1} deep", limits_.depth));
    if (recorder_) recorder_->open(type);
    levels_.push_back({std::move(empty)});
    return true;
}

bool JsonReader::close()
{
    if (recorder_) recorder_->close();
    Json done = std::move(levels_.back().value);
    levels_.pop_back();
    add(std::move(done));
    return true;
}

void JsonReader::add(Json value)
{
    if (levels_.empty()) {
        root_ = std::move(value);
        return;
    }
    JsonLevel& parent = levels_.back();
    if (parent.value.is_array())
        parent.value.get_ref<Json::array_t&>().push_back(std::move(value));
    else  // Keys are unique here; ordered_map's own insertion would compare with every key.
        parent.value.get_ref<Json::object_t&>().emplace_back(parent.key, std::move(value));
}

/// Returns the path of the current position: "values.morph" or "accessors[3].count".
std::string JsonReader::path() const
{
    std::string text;
    for (const JsonLevel& level : levels_) {
        if (level.value.is_array()) {
            text += '[' + std::to_string(level.value.size()) + ']';
        } else if (!level.key.empty()) {
            if (!text.empty()) text += '.';
            text += level.key;
        }
    }
    return text;
}

void JsonReader::comparePath()
{
    if (wanted_.empty()) return;
    const std::string here = path();
    if (here.size() <= longestFound_ || !wanted_.starts_with(here)) return;
    const bool whole = here.size() == wanted_.size();
    if (!whole && wanted_[here.size()] != '.' && wanted_[here.size()] != '[') return;
    longestFound_ = here.size();
    wantedLine_ = positionIn(source_).line;
}

/// Returns whether the bytes are certainly not JSON: they begin with no object or array and contain control characters.
bool isBinary(std::string_view bytes)
{
    constexpr std::string_view white = " \t\r\n";
    constexpr std::size_t examined = 512;
    const std::size_t first = bytes.find_first_not_of(white);
    if (first == std::string_view::npos || bytes[first] == '{' || bytes[first] == '[') return false;
    const std::string_view head = bytes.substr(0, examined);
    const auto isControl = [&](char c) {
        return static_cast<unsigned char>(c) < 0x20 && white.find(c) == std::string_view::npos;
    };
    return std::count_if(head.begin(), head.end(), isControl) > 1;  // A single one is reported with its position.
}

Json JsonReader::read(const std::string& name)
{
    const std::string_view text = source_.text;
    const auto refuseWhole = [&](const Message& why) { throw JsonFailure({name, 1, 1}, why); };
    if (text.size() > limits_.bytes) {
        refuseWhole(message("the file has {1} bytes, more than the {2} allowed for JSON", text.size(), limits_.bytes));
    }
    if (text.empty()) refuseWhole(message("the file is empty; it should hold JSON"));
    if (text.starts_with("\xEF\xBB\xBF")) refuseWhole(message("the file starts with two byte order marks; delete one"));
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        refuseWhole(message("the file is UTF-16; save it as UTF-8"));
    if (isBinary(text)) refuseWhole(message("this is binary data and not JSON; choose another file"));
    // The library takes a zero byte for the end of the text and would ignore everything after it.
    if (const auto zero = zeroByteIn(text)) throw JsonFailure({name, zero->line, zero->column}, zeroByteProblem());
    if (Json::sax_parse(CountingIterator(source_, 0), CountingIterator(source_, text.size()), this))
        return std::move(root_);

    std::size_t& taken = source_.taken;
    while (numberEnded_ && taken > 1 && (text[taken - 1] < '0' || text[taken - 1] > '9')) --taken;
    const TextPosition at = positionIn(source_);
    throw JsonFailure({name, at.line, at.column, path()},
                      problem_.empty() ? message("this is not valid JSON") : problem_);
}

std::vector<JsonSpan> JsonReader::places(const std::string& name)
{
    SpanRecorder recorder(source_);
    recorder_ = &recorder;
    static_cast<void>(read(name));
    recorder_ = nullptr;
    return std::move(recorder.spans);
}

}  // namespace

JsonFailure::JsonFailure(const FilePlace& at, const Message& problem)
    : Failure(ErrorKind::file,
              at.key.empty() ? vitrine::message("{1}, line {2}, column {3}: {4}.", at.file, at.line, at.column, problem)
                             : vitrine::message("{1}, line {2}, column {3}, {4}: {5}.", at.file, at.line, at.column,
                                                at.key, problem),
              at),
      problem_(problem)
{
}

int JsonDocument::lineOf(std::string_view keyPath) const
{
    const JsonLimits none{text_.size(), 100'000, text_.size() + 1, text_.size()};
    JsonReader reader(text_, none, keyPath);
    static_cast<void>(reader.read(name_));
    return reader.wantedLine();
}

Failure JsonDocument::failure(std::string_view keyPath, const Message& problem) const
{
    if (keyPath.empty()) return Failure(ErrorKind::file, message("{1}: {2}", name_, problem), {name_});
    const FilePlace at{name_, lineOf(keyPath), 0, std::string(keyPath)};
    return Failure(ErrorKind::file, message("{1}, line {2}, {3}: {4}", at.file, at.line, at.key, problem), at);
}

JsonDocument parseJson(std::string text, std::string name, const JsonLimits& limits)
{
    text = withoutByteOrderMark(std::move(text));
    Json root = JsonReader(text, limits).read(name);
    return JsonDocument(std::move(root), std::move(text), std::move(name));
}

std::vector<JsonSpan> jsonSpans(std::string_view text, const std::string& name, const JsonLimits& limits)
{
    assert(limits.bytes < JsonSpan::none);
    return JsonReader(text, limits).places(name);
}

JsonDocument readJson(const std::filesystem::path& path, const JsonLimits& limits)
{
    return parseJson(readFile(path, limits.bytes), path.string(), limits);
}

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
    [[noreturn]] void fail(const Message& problem) const
    {
        throw Failure(ErrorKind::file, path_.empty() ? message("Cannot write JSON: the value {1}", problem)
                                                     : message("Cannot write JSON: {1} {2}", path_, problem));
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
        if (!std::isfinite(x)) fail(message("is not a finite number; reset it."));
        const std::string text = shortestNumber(x);
        out += text;
        if (text.find_first_of(".e") == std::string::npos) out += ".0";
    }

    void writeString(const std::string& text)
    {
        try {
            out += quoted(text, false);
        } catch (const Json::type_error&) {
            fail(message("holds text that is not UTF-8; retype it."));
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
            throw Failure(ErrorKind::file, message("Cannot write JSON: the text is not UTF-8."));
        }
    }
    return out;
}

}  // namespace vitrine::render
