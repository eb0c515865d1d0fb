#include "render/files/json_scan.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <vector>

namespace vitrine::render {
namespace {

/// Reads the text for nlohmann's lexer and counts what it has taken: its events carry no position.
class CountingIterator {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* at, std::size_t* taken) : at_(at), taken_(taken) {}
    reference operator*() const { return *at_; }
    CountingIterator& operator++()
    {
        ++at_;
        ++*taken_;
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
    const char* at_;
    std::size_t* taken_;
};

/// An object or array that is still open.
struct Level {
    bool isObject = false;
    std::unordered_set<std::string> keys;
    std::string key;        // The one last seen.
    std::size_t index = 0;  // Of the next array element.
};

class Handler final : public nlohmann::json_sax<Json> {
public:
    Handler(JsonEvents& events, const JsonLimits& limits, bool reportPaths)
        : events_(events), limits_(limits), reportPaths_(reportPaths)
    {
    }

    bool null() override { return plain(Json(nullptr)); }
    bool boolean(bool x) override { return plain(Json(x)); }
    bool number_integer(number_integer_t x) override { return plain(Json(x)); }
    bool number_unsigned(number_unsigned_t x) override { return plain(Json(x)); }
    bool number_float(number_float_t x, const string_t& /*text*/) override { return plain(Json(x)); }
    bool binary(binary_t& /*bytes*/) override { return refuse("JSON has no binary values"); }
    bool string(string_t& x) override
    {
        if (x.size() > limits_.stringBytes) return refuse("this string is longer than " + bytes(limits_.stringBytes));
        if (x.find('\0') != std::string::npos) return refuse("this string contains the character U+0000; remove it");
        return plain(Json(std::move(x)));
    }
    bool start_object(std::size_t /*size*/) override { return open(true); }
    bool start_array(std::size_t /*size*/) override { return open(false); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& x) override
    {
        if (x.size() > limits_.stringBytes) return refuse("this key is longer than " + bytes(limits_.stringBytes));
        const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
        if (std::any_of(x.begin(), x.end(), isControl)) return refuse("a key contains a control character; remove it");
        Level& level = levels_.back();
        level.key = x;
        if (!level.keys.insert(x).second) return refuse("this key stands twice; remove one of the two");
        events_.key(x);
        if (reportPaths_) events_.place(path());
        return true;
    }
    bool parse_error(std::size_t /*position*/, const std::string& lastToken,
                     const nlohmann::detail::exception& e) override
    {
        constexpr int outOfRange = 406;
        numberEnded = e.id == outOfRange;
        if (numberEnded) return refuse("the number " + lastToken + " is too large; numbers end at 1.8e308");
        // "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while ...".
        std::string what = e.what();
        if (const std::size_t colon = what.find(": "); colon != std::string::npos) what.erase(0, colon + 2);
        return refuse("this is not valid JSON (" + what + "); correct it there");
    }

    /// "values.morph" or "accessors[3].count" for where the scan stands.
    [[nodiscard]] std::string path() const
    {
        std::string text;
        for (const Level& level : levels_) {
            if (!level.isObject) {
                text += '[' + std::to_string(level.index) + ']';
            } else if (!level.key.empty()) {
                if (!text.empty()) text += '.';
                text += level.key;
            }
        }
        return text;
    }

    std::string problem;
    bool numberEnded = false;  ///< The problem is a number, which ends before what was taken last.

private:
    static std::string bytes(std::size_t n) { return std::to_string(n) + " bytes; shorten it"; }

    bool refuse(std::string why)
    {
        problem = std::move(why);
        return false;
    }
    bool count()
    {
        if (reportPaths_ && !levels_.empty() && !levels_.back().isObject) events_.place(path());
        if (++nodes_ > limits_.nodes)
            return refuse("the file holds more than " + std::to_string(limits_.nodes) + " values");
        return true;
    }
    bool plain(Json value)
    {
        if (!count()) return false;
        events_.value(std::move(value));
        next();
        return true;
    }
    bool open(bool isObject)
    {
        if (!count()) return false;
        if (levels_.size() >= limits_.depth) {
            return refuse("objects and arrays are nested more than " + std::to_string(limits_.depth) + " deep");
        }
        levels_.push_back({isObject, {}, {}, 0});
        events_.open(isObject);
        return true;
    }
    bool close()
    {
        levels_.pop_back();
        events_.close();
        next();
        return true;
    }
    void next()
    {
        if (levels_.empty()) return;
        ++levels_.back().index;
    }

    JsonEvents& events_;
    const JsonLimits& limits_;
    bool reportPaths_;
    std::vector<Level> levels_;
    std::size_t nodes_ = 0;
};

[[noreturn]] void fail(const std::string& name, const std::string& problem)
{
    throw Failure(Blame::file, name + ": " + problem);
}

}  // namespace

JsonScanner::JsonScanner(std::string_view text, const std::string& name, const JsonLimits& limits)
    : text_(text), name_(name), limits_(limits)
{
}

JsonScanner::Position JsonScanner::position() const
{
    const std::size_t last = taken_ > 0 ? taken_ - 1 : 0;
    const std::string_view before = text_.substr(0, std::min(last, text_.size()));
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = newline == std::string_view::npos ? before.size() + 1 : before.size() - newline;
    return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1, static_cast<int>(column)};
}

void JsonScanner::scan(JsonEvents& events, Paths paths)
{
    if (text_.size() > limits_.bytes) {
        fail(name_, "the file has " + std::to_string(text_.size()) + " bytes, more than the " +
                        std::to_string(limits_.bytes) + " allowed for JSON.");
    }
    if (text_.empty()) fail(name_, "the file is empty; it should hold JSON.");
    if (text_.starts_with("\xEF\xBB\xBF")) {
        fail(name_, "line 1: the file starts with a byte order mark; save it as UTF-8 without one.");
    }
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF")) {
        fail(name_, "line 1: the file is UTF-16; save it as UTF-8.");
    }
    taken_ = 0;
    Handler handler(events, limits_, paths == Paths::report);
    const CountingIterator first(text_.data(), &taken_);
    const CountingIterator last(text_.data() + text_.size(), &taken_);
    const bool good = Json::sax_parse(first, last, &handler);
    if (good && handler.problem.empty()) return;

    while (handler.numberEnded && taken_ > 1 && (text_[taken_ - 1] < '0' || text_[taken_ - 1] > '9')) --taken_;
    const Position at = position();
    std::string where = "line " + std::to_string(at.line) + ", column " + std::to_string(at.column);
    if (const std::string path = handler.path(); !path.empty()) where += ", " + path;
    fail(name_ + ", " + where, handler.problem.empty() ? "this is not valid JSON." : handler.problem + ".");
}

}  // namespace vitrine::render
