#include "exhibits/shader_export/glsl_items.h"

#include "exhibits/shader_export/code_rewriter.h"
#include "render/failure.h"
#include "render/glsl/lexer.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

namespace vitrine::guest {
namespace {

[[noreturn]] void refuseText(const std::string& text)
{
    throw Failure(ErrorKind::shader,
                  message("The shader of this exhibit cannot be exported: “{1}” is not understood.", text));
}

std::optional<int> numberOf(std::string_view text)
{
    while (!text.empty() && (text.back() == 'u' || text.back() == 'U')) text.remove_suffix(1);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Evaluates the condition of an `#if`: numbers, macros, defined, !, comparisons, && and ||.
class Condition {
public:
    Condition(std::string text, const GlslMacros& macros) : text_(std::move(text)), tokens_(text_), macros_(macros) {}

    bool run()
    {
        const int value = either();
        if (at_ != tokens_.size()) refuseText(text_);
        return value != 0;
    }

private:
    bool take(std::string_view first, std::string_view second = {})
    {
        // The lexer may give "&&" as one symbol or as two.
        const std::string both = std::string(first) + std::string(second);
        if (tokens_.text(at_) == both) return ++at_, true;
        if (second.empty() || tokens_.text(at_) != first || tokens_.text(at_ + 1) != second) return false;
        at_ += 2;
        return true;
    }
    int either()
    {
        int value = both();
        while (take("|", "|")) value = static_cast<int>((both() != 0) | (value != 0));
        return value;
    }
    int both()
    {
        int value = comparison();
        while (take("&", "&")) value = static_cast<int>((comparison() != 0) & (value != 0));
        return value;
    }
    int comparison()
    {
        const int left = atom();
        if (take("=", "=")) return static_cast<int>(left == atom());
        if (take("!", "=")) return static_cast<int>(left != atom());
        if (take("<", "=")) return static_cast<int>(left <= atom());
        if (take(">", "=")) return static_cast<int>(left >= atom());
        if (take("<")) return static_cast<int>(left < atom());
        if (take(">")) return static_cast<int>(left > atom());
        return left;
    }
    int atom()
    {
        if (take("!")) return static_cast<int>(atom() == 0);
        if (take("(")) {
            const int value = either();
            if (!take(")")) refuseText(text_);
            return value;
        }
        const std::string word(tokens_.text(at_++));
        if (word == "defined") {
            const bool inBrackets = take("(");
            const bool is = macros_.contains(tokens_.text(at_++));
            if (inBrackets && !take(")")) refuseText(text_);
            return static_cast<int>(is);
        }
        if (word.empty()) refuseText(text_);
        return numberOf(word) || macros_.contains(word) ? wholeNumber(macros_, word) : 0;
    }

    const std::string text_;
    const render::Tokens tokens_;
    const GlslMacros& macros_;
    std::size_t at_ = 0;
};

/// Evaluates the #if lines of a text, line by line.
class Conditions {
public:
    explicit Conditions(GlslMacros& macros) : macros_(macros) {}

    /// Returns whether the preprocessor keeps the line.
    bool keeps(const std::string& line)
    {
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string::npos || line[first] != '#') return isActive();
        std::istringstream words(line.substr(first + 1));
        std::string word, rest;
        words >> word;
        std::getline(words, rest);
        rest = rest.substr(0, rest.find("//"));
        std::istringstream names(rest);
        std::string name;
        names >> name;
        if (word == "if") return push(isActive() && Condition(rest, macros_).run());
        if (word == "ifdef") return push(macros_.contains(name));
        if (word == "ifndef") return push(!macros_.contains(name));
        if (word == "elif") return change(!stack_.back().wasTrue && isOuterActive() && Condition(rest, macros_).run());
        if (word == "else") return change(!stack_.back().wasTrue);
        if (word == "endif") return stack_.pop_back(), false;
        if (!isActive() || word == "line" || word == "version" || word == "extension") return false;
        if (word == "define") define(name, rest);
        if (word == "undef") macros_.erase(name);
        return true;
    }

private:
    struct Level {
        bool isTrue, wasTrue;
    };
    [[nodiscard]] bool isActive() const
    {
        return std::all_of(stack_.begin(), stack_.end(), [](const Level& level) { return level.isTrue; });
    }
    [[nodiscard]] bool isOuterActive() const
    {
        return std::all_of(stack_.begin(), stack_.end() - 1, [](const Level& level) { return level.isTrue; });
    }
    bool push(bool isTrue)
    {
        stack_.push_back({isTrue, isTrue});
        return false;
    }
    bool change(bool isTrue)
    {
        stack_.back().isTrue = isTrue;
        stack_.back().wasTrue = stack_.back().wasTrue || isTrue;
        return false;
    }
    void define(const std::string& name, const std::string& rest)
    {
        if (name.find('(') != std::string::npos) return;
        const std::size_t begin = rest.find(name) + name.size();
        std::string value = rest.substr(begin);
        value.erase(0, std::min(value.find_first_not_of(" \t"), value.size()));
        value.erase(value.find_last_not_of(" \t") + 1);
        macros_[name] = value;
    }

    GlslMacros& macros_;
    std::vector<Level> stack_;
};

/// Splits a text into items.
class Splitter {
public:
    explicit Splitter(const std::string& text) : text_(text), tokens_(text_) {}

    std::vector<GlslItem> run()
    {
        for (std::size_t i = 0; i < tokens_.size();) {
            const std::size_t end = endFrom(i);
            add(i, end);
            i = end;
        }
        return std::move(items_);
    }

private:
    /// Returns the index behind the last token of the item that begins at `i`.
    [[nodiscard]] std::size_t endFrom(std::size_t i) const
    {
        if (tokens_[i].directive != 0) return tokens_.lineEnd(i);
        const std::string_view first = tokens_.text(i);
        bool isBlock = first == "struct" || first == "layout";
        int depth = 0, inBrackets = 0;
        for (std::size_t at = i; at < tokens_.size(); ++at) {
            const std::string_view word = tokens_.text(at);
            depth += (word == "{") - (word == "}");
            inBrackets += (word == "(") - (word == ")");
            isBlock = isBlock || (depth == 0 && (word == "uniform" || word == "buffer"));
            if (depth != 0 || inBrackets != 0) continue;
            if (word == ";" || (word == "}" && !isBlock)) return at + 1;
            if (word == ")" && first == "BLOCK_STRUCT") return at + 1;
        }
        return tokens_.size();
    }
    void add(std::size_t begin, std::size_t end)
    {
        std::size_t to = tokens_[end - 1].end;
        const std::size_t newline = std::min(text_.find('\n', to), text_.size());
        // A comment behind the item belongs to it.
        const std::size_t next = end < tokens_.size() ? tokens_[end].begin : text_.size();
        if (next >= newline) to = newline;
        GlslItem item{.text = text_.substr(at_, to - at_), .names = {}, .words = {}, .members = {}, .pairs = {}};
        at_ = std::min(to + 1, text_.size());
        item.isMacro = tokens_[begin].directive != 0;
        for (std::size_t i = begin; i < end; ++i) {
            if (tokens_[i].kind != render::Token::Kind::word) continue;
            item.words.emplace(tokens_.text(i));
            if (i < begin + 2 || tokens_.text(i - 1) != ".") continue;
            item.members.emplace(tokens_.text(i));
            item.pairs.insert(std::string(tokens_.text(i - 2)) + '.' + std::string(tokens_.text(i)));
        }
        item.names = namesFrom(begin, end);
        items_.push_back(std::move(item));
    }
    [[nodiscard]] std::set<std::string> namesFrom(std::size_t begin, std::size_t end) const
    {
        if (tokens_[begin].directive != 0) return {std::string(tokens_.text(begin + 2))};
        if (tokens_.text(begin) == "BLOCK_STRUCT") return {std::string(tokens_.text(begin + 2))};
        const std::string code = text_.substr(tokens_[begin].begin, tokens_[end - 1].end - tokens_[begin].begin);
        std::set<std::string> names = globalNames({{0, 1, code}});
        bool isUniform = false;
        for (std::size_t i = begin; i < end && tokens_.text(i) != "{"; ++i)
            isUniform = isUniform || tokens_.text(i) == "uniform" || tokens_.text(i) == "buffer";
        // The members of a block without a name of its own are names; the block's name is none that code uses.
        if (isUniform && tokens_.text(end - 2) == "}")
            for (std::size_t i = begin; i < end; ++i)
                if ((tokens_.text(i + 1) == ";" || tokens_.text(i + 1) == "[") &&
                    tokens_[i].kind == render::Token::Kind::word)
                    names.emplace(tokens_.text(i));
        return names;
    }

    const std::string& text_;
    const render::Tokens tokens_;
    std::vector<GlslItem> items_;
    std::size_t at_ = 0;
};

}  // namespace

std::string withoutConditions(std::string_view text, GlslMacros& macros)
{
    Conditions conditions(macros);
    std::istringstream lines{std::string(text)};
    std::string kept;
    for (std::string line; std::getline(lines, line);) {
        std::string whole = line;
        while (!whole.empty() && whole.back() == '\\' && std::getline(lines, line)) whole += '\n' + line;
        if (conditions.keeps(whole)) kept += whole + '\n';
    }
    return kept;
}

std::vector<GlslItem> itemsOf(const std::string& text)
{
    return Splitter(text).run();
}

std::vector<GlslItem> neededItems(const std::vector<GlslItem>& items, const std::set<std::string>& roots)
{
    std::multimap<std::string_view, std::size_t> byName;
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const std::string& name : items[i].names) byName.emplace(name, i);
    std::vector<char> needed(items.size(), 0);
    std::vector<std::string_view> open(roots.begin(), roots.end());
    std::set<std::string_view> seen(open.begin(), open.end());
    while (!open.empty()) {
        const std::string_view name = open.back();
        open.pop_back();
        for (auto [at, end] = byName.equal_range(name); at != end; ++at) {
            if (needed[at->second] != 0) continue;
            needed[at->second] = 1;
            for (const std::string& word : items[at->second].words)
                if (seen.insert(word).second) open.push_back(word);
        }
    }
    std::vector<GlslItem> kept;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (needed[i] != 0) kept.push_back(items[i]);
    return kept;
}

int wholeNumber(const GlslMacros& macros, const std::string& text)
{
    std::string word = text;
    for (int depth = 0; depth < 16; ++depth) {
        if (const auto number = numberOf(word)) return *number;
        const auto found = macros.find(word);
        if (found == macros.end()) break;
        word = found->second;
    }
    refuseText(text);
}

}  // namespace vitrine::guest
