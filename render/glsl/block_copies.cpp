#include "render/glsl/block_copies.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace vitrine::render {
namespace {

struct Member {
    std::string type, name;
    bool isArray = false;
};
using Structs = std::map<std::string, std::vector<Member>, std::less<>>;

bool isWordPart(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Leaves out comments, but not their line ends.
std::string withoutComments(const std::string& text)
{
    std::string result;
    result.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        if (text.compare(i, 2, "//") == 0) {
            i = std::min(text.find('\n', i), text.size());
        } else if (text.compare(i, 2, "/*") == 0) {
            const std::size_t end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
            for (; i < end; ++i)
                if (text[i] == '\n') result += '\n';
            result += ' ';
        } else {
            result += text[i++];
        }
    }
    return result;
}

/// The words of a text and the signs between them.
class Scanner {
public:
    Scanner(std::string_view text, std::size_t at) : text_(text), at_(at) {}

    std::string_view word()
    {
        space();
        const std::size_t begin = at_;
        while (at_ < text_.size() && isWordPart(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    bool sign(char wanted)
    {
        space();
        if (at_ >= text_.size() || text_[at_] != wanted) return false;
        ++at_;
        return true;
    }
    [[nodiscard]] std::size_t at() const { return at_; }

private:
    void space()
    {
        while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '\\'))
            ++at_;
    }

    std::string_view text_;
    std::size_t at_;
};

/// Reads `FIELD(type, name)` and `ARRAY(type, name, count)` up to the end of the macro.
std::vector<Member> membersOf(std::string_view text, std::size_t at)
{
    std::vector<Member> members;
    for (Scanner scan(text, at);;) {
        const std::string_view kind = scan.word();
        if ((kind != "FIELD" && kind != "ARRAY") || !scan.sign('(')) return members;
        Member member{std::string(scan.word()), "", kind == "ARRAY"};
        (void)scan.sign(',');
        member.name = scan.word();
        members.push_back(std::move(member));
        scan = Scanner(text, text.find(')', scan.at()) + 1);
    }
}

std::vector<std::size_t> placesOf(const std::string& text, const std::string& word)
{
    std::vector<std::size_t> places;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) {
        const char before = at > 0 ? text[at - 1] : ' ';
        const char after = at + word.size() < text.size() ? text[at + word.size()] : ' ';
        if (!isWordPart(before) && !isWordPart(after)) places.push_back(at);
    }
    return places;
}

bool isMember(const std::string& text, std::size_t place)
{
    return place > 0 && text[place - 1] == '.';
}

/// Whether a word stands before that place, such as the type in a declaration.
bool followsWord(const std::string& text, std::size_t place)
{
    return place > 1 && text[place - 1] == ' ' && isWordPart(text[place - 2]) &&
           text.compare(place - std::min<std::size_t>(place, 7), 7, "return ") != 0;
}

struct ArrayUse {
    std::set<std::string> indices;  ///< Numerals.
    bool computed = false;          ///< Other indices, or none.
};

/// The uses of a block's instance in a text.
struct Uses {
    std::map<std::string, ArrayUse> arrays;
    bool whole = false;  ///< Without a member.
};

Uses usesOf(const std::string& text, const std::string& instance, const std::vector<Member>& members)
{
    Uses uses;
    for (const std::size_t place : placesOf(text, instance)) {
        if (isMember(text, place) || followsWord(text, place)) continue;
        Scanner scan(text, place + instance.size());
        if (!scan.sign('.')) {
            uses.whole = true;
            continue;
        }
        const std::string name(scan.word());
        const auto member =
            std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.name == name; });
        if (member == members.end() || !member->isArray) continue;
        ArrayUse& use = uses.arrays[name];
        const bool opened = scan.sign('[');
        const std::string index(scan.word());
        const bool numeral = !index.empty() && std::all_of(index.begin(), index.end(),
                                                           [](unsigned char c) { return std::isdigit(c) != 0; });
        if (opened && numeral && scan.sign(']'))
            use.indices.insert(index);
        else
            use.computed = true;
    }
    return uses;
}

class Copies {
public:
    explicit Copies(const std::string& shader) : text_(withoutComments(shader)) {}

    std::string made()
    {
        std::map<std::string, std::vector<Member>, std::less<>> macros;
        const std::string define = "#define ", list = "_FIELDS(FIELD, ARRAY)";
        for (std::size_t at = text_.find(list); at != std::string::npos; at = text_.find(list, at + 1)) {
            const std::size_t begin = text_.rfind(define, at) + define.size();
            macros[text_.substr(begin, at - begin)] = membersOf(text_, at + list.size());
        }
        const std::string declared = "\nBLOCK_STRUCT(";
        for (std::size_t at = text_.find(declared); at != std::string::npos; at = text_.find(declared, at + 1)) {
            Scanner scan(text_, at + declared.size());
            const std::string name(scan.word());
            (void)scan.sign(',');
            std::string fields(scan.word());
            fields.resize(fields.size() - std::min<std::size_t>(fields.size(), 7));  // _FIELDS
            structs_[name] = macros[fields];
        }
        const std::string block = "layout(std140";
        for (std::size_t at = text_.find(block); at != std::string::npos; at = text_.find(block, at + 1)) copy(at);
        return std::move(text_);
    }

private:
    /// Whether all its members can be copied by assignments.
    [[nodiscard]] bool isPlain(const std::string& type) const
    {
        const auto found = structs_.find(type);
        return found == structs_.end() || std::all_of(found->second.begin(), found->second.end(),
                                                      [&](const Member& m) { return !m.isArray && isPlain(m.type); });
    }

    /// Assignments of all numbers: `to.a = from.a; ...`.
    [[nodiscard]] std::string assigned(const std::string& type, const std::string& to, const std::string& from) const
    {
        const auto found = structs_.find(type);
        if (found == structs_.end()) return to + " = " + from + "; ";
        std::string text;
        for (const Member& m : found->second)
            if (!m.isArray) text += assigned(m.type, to + '.' + m.name, from + '.' + m.name);
        return text;
    }

    /// Changes the block that begins there.
    void copy(std::size_t at)
    {
        const std::size_t open = text_.find('{', at), uniform = text_.find(" uniform ", at);
        if (open == std::string::npos || uniform > open) return;
        Scanner scan(text_, open + 1);
        const std::string first(scan.word()), instance(scan.word());
        if (!scan.sign(';')) return;
        const auto type = structs_.find(first);
        if (type != structs_.end() && scan.sign('}') && scan.sign(';'))
            copyStruct(scan.at(), *type, instance);
        else if (Scanner(text_, uniform + 9).word() == "Parameters")
            copyParameters(open);
    }

    void copyStruct(std::size_t end, const Structs::value_type& type, const std::string& instance)
    {
        const auto& [name, members] = type;
        const std::string block = instance + "InBlock";
        std::string head = text_.substr(0, end), rest = text_.substr(end);
        head.insert(head.rfind(instance) + instance.size(), "InBlock");
        const auto inBlock = [&](const std::string& word) {
            const std::vector<std::size_t> places = placesOf(rest, word);
            for (auto place = places.rbegin(); place != places.rend(); ++place)
                if (word == instance || !isMember(rest, *place)) rest.replace(*place, instance.size(), block);
        };
        const Uses uses = usesOf(rest, instance, members);
        const auto isLeft = [&](const Member& m) {
            const auto use = uses.arrays.find(m.name);
            return m.isArray && (use == uses.arrays.end() || use->second.computed || !isPlain(m.type));
        };
        const bool canCopy =
            std::all_of(members.begin(), members.end(), [&](const Member& m) { return m.isArray || isPlain(m.type); });
        if (!canCopy || (uses.whole && std::any_of(members.begin(), members.end(), isLeft))) {
            inBlock(instance);
            text_ = head + rest;
            return;
        }
        std::string body;
        for (const Member& m : members) {
            if (isLeft(m))
                inBlock(instance + '.' + m.name);
            else if (!m.isArray)
                body += assigned(m.type, "copied." + m.name, block + '.' + m.name);
            else
                for (const std::string& i : uses.arrays.at(m.name).indices) {
                    const std::string element = '.' + m.name + '[' + i + ']';
                    body += assigned(m.type, "copied" + element, block + element);
                }
        }
        text_ = head + ' ' + name + ' ' + instance + "Copied() { " + name + " copied; " + body + "return copied; } " +
                name + ' ' + instance + " = " + instance + "Copied();" + rest;
    }

    void copyParameters(std::size_t open)
    {
        const std::size_t close = text_.find('}', open);
        Scanner scan(text_, close + 1);
        const std::string instance(scan.word());
        if (instance.empty() || !scan.sign(';')) return;
        std::string values;
        const std::string fields = text_.substr(open + 1, close - open - 1);
        Scanner field(fields, 0);
        for (std::string_view type = field.word(); !type.empty(); type = field.word()) {
            values += (values.empty() ? "" : ", ") + instance + "InBlock." + std::string(field.word());
            if (!field.sign(';')) return;  // An array, or something else.
        }
        std::string flat = fields;
        std::replace(flat.begin(), flat.end(), '\n', ' ');
        const std::string type = "CopiedParameters";
        text_.replace(close + 1, scan.at() - close - 1,
                      ' ' + instance + "InBlock; struct " + type + " {" + flat + "}; " + type + ' ' + instance + " = " +
                          type + '(' + values + ");");
    }

    std::string text_;
    Structs structs_;
};

}  // namespace

bool asksForCopies(const std::string& shader)
{
    return shader.find("\n#define COPY_BLOCKS") != std::string::npos;
}

std::string copyingBlocks(const std::string& shader)
{
    return Copies(shader).made();
}

}  // namespace vitrine::render
