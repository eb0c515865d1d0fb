#include "render/glsl/block_copies.h"

#include "render/glsl/block_fields.h"
#include "render/glsl/lexer.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

namespace vitrine::render {
namespace {

using Structs = std::map<std::string, std::vector<ListedField>, std::less<>>;

/// Reads the structs that are declared by BLOCK_STRUCT.
Structs structsOf(const Tokens& tokens)
{
    std::map<std::string_view, std::vector<ListedField>> macros;
    Structs structs;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        // #define X_FIELDS(FIELD, ARRAY) ...; BLOCK_STRUCT(X, X_FIELDS)
        if (tokens.text(i) == "define" && tokens.text(i + 3) == "FIELD" && tokens.text(i + 5) == "ARRAY")
            macros[tokens.text(i + 1)] = listedFields(tokens, i + 7);
        else if (tokens.text(i) == "BLOCK_STRUCT" && tokens[i].directive == 0)
            structs[std::string(tokens.text(i + 2))] = macros[tokens.text(i + 4)];
    }
    return structs;
}

/// Use of a block's instance.
struct Use {
    std::size_t end = 0;     ///< Byte of the text behind the instance.
    std::string_view name;   ///< Member, or empty for the whole block.
    std::string_view index;  ///< Numeral in the brackets behind the member, or empty.
};

/// Returns whether the word of a token is a member, or is declared there: a word stands before it in its line.
bool isOtherName(const Tokens& tokens, std::size_t i)
{
    const Token& before = tokens[i - 1];
    return tokens.text(i - 1) == "." ||
           (before.kind == Token::Kind::word && before.line == tokens[i].line && tokens.text(i - 1) != "return");
}

/// Returns the uses of `instance` behind a token.
std::vector<Use> usesOf(const Tokens& tokens, std::size_t behind, std::string_view instance)
{
    std::vector<Use> uses;
    for (std::size_t i = behind + 1; i < tokens.size(); ++i) {
        if (tokens.text(i) != instance || isOtherName(tokens, i)) continue;
        Use use{.end = tokens[i].end};
        if (tokens.text(i + 1) == ".") use.name = tokens.text(i + 2);
        const std::string_view index = tokens.text(i + 4);
        if (tokens.text(i + 3) == "[" && tokens.text(i + 5) == "]" &&
            std::all_of(index.begin(), index.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
            use.index = index;
        uses.push_back(use);
    }
    return uses;
}

class Copies {
public:
    /// The text must outlive this object.
    explicit Copies(const std::string& shader) : text_(shader), tokens_(shader), structs_(structsOf(tokens_)) {}

    std::string made()
    {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (tokens_.text(i) != "layout" || tokens_.text(i + 2) != "std140") continue;
            while (i < tokens_.size() && tokens_.text(i) != ")") ++i;
            if (tokens_.text(i + 1) == "uniform" && tokens_.text(i + 3) == "{") copy(i + 2);
        }
        std::string text;
        std::size_t done = 0;
        for (const auto& [place, inserted] : inserted_) {
            text.append(text_, done, place - done).append(inserted);
            done = place;
        }
        return text.append(text_, done);
    }

private:
    /// Whether all its members can be copied by assignments.
    [[nodiscard]] bool isPlain(std::string_view type) const
    {
        const auto found = structs_.find(type);
        return found == structs_.end() ||
               std::all_of(found->second.begin(), found->second.end(),
                           [&](const ListedField& m) { return m.count.empty() && isPlain(m.type); });
    }

    /// Assignments of all numbers: `to.a = from.a; ...`.
    [[nodiscard]] std::string assigned(std::string_view type, const std::string& to, const std::string& from) const
    {
        const auto found = structs_.find(type);
        if (found == structs_.end()) return to + " = " + from + "; ";
        std::string text;
        for (const ListedField& m : found->second) {
            const std::string member = '.' + std::string(m.name);
            if (m.count.empty()) text += assigned(m.type, to + member, from + member);
        }
        return text;
    }

    /// Changes the block with the name at that token.
    void copy(std::size_t name)
    {
        const std::size_t first = name + 2;  // Name { Type instance; };
        if (const auto type = structs_.find(tokens_.text(first));
            type != structs_.end() && tokens_.text(first + 3) == "}" && tokens_.text(first + 4) == ";")
            copyStruct(first + 1, *type);
        else if (tokens_.text(name) == "Parameters")
            copyParameters(first);
    }

    void copyStruct(std::size_t instanceAt, const Structs::value_type& type)
    {
        const auto& [name, members] = type;
        const std::string instance(tokens_.text(instanceAt)), block = instance + "InBlock";
        const std::vector<Use> uses = usesOf(tokens_, instanceAt + 3, instance);
        const auto isLeft = [&, &all = members](std::string_view member) {
            const auto m =
                std::find_if(all.begin(), all.end(), [&](const ListedField& each) { return each.name == member; });
            if (m == all.end() || m->count.empty()) return false;
            const auto isOf = [&](const Use& use) { return use.name == member; };
            return std::none_of(uses.begin(), uses.end(), isOf) || !isPlain(m->type) ||
                   std::any_of(uses.begin(), uses.end(), [&](const Use& u) { return isOf(u) && u.index.empty(); });
        };
        const bool canCopy = std::all_of(members.begin(), members.end(),
                                         [&](const ListedField& m) { return !m.count.empty() || isPlain(m.type); });
        const bool asWhole = std::any_of(uses.begin(), uses.end(), [](const Use& use) { return use.name.empty(); });
        const bool copies = canCopy && !(asWhole && std::any_of(members.begin(), members.end(),
                                                                [&](const ListedField& m) { return isLeft(m.name); }));
        std::string body;
        for (const ListedField& m : members) {
            const std::string member = '.' + std::string(m.name);
            if (m.count.empty()) body += assigned(m.type, "copied" + member, block + member);
            std::map<std::string_view, std::string> elements;
            for (const Use& use : uses) {
                if (m.count.empty() || use.name != m.name || isLeft(m.name)) continue;
                const std::string element = member + '[' + std::string(use.index) + ']';
                elements[use.index] = assigned(m.type, "copied" + element, block + element);
            }
            for (const auto& [index, assignments] : elements) body += assignments;
        }
        inserted_[tokens_[instanceAt].end] = "InBlock";
        // Without copies, the word is replaced everywhere: whatever else has that name keeps one name.
        for (std::size_t i = instanceAt + 4; !copies && i < tokens_.size(); ++i)
            if (tokens_.text(i) == instance) inserted_[tokens_[i].end] = "InBlock";
        if (!copies) return;
        for (const Use& use : uses)
            if (isLeft(use.name)) inserted_[use.end] = "InBlock";
        inserted_[tokens_[instanceAt + 3].end] = ' ' + name + ' ' + instance + "Copied() { " + name + " copied; " +
                                                 body + "return copied; } " + name + ' ' + instance + " = " + instance +
                                                 "Copied();";
    }

    void copyParameters(std::size_t first)
    {
        std::string fields, values;
        std::size_t close = first;
        while (close < tokens_.size() && tokens_.text(close) != "}") ++close;
        const std::string instance(tokens_.text(close + 1));
        if (instance.empty() || tokens_.text(close + 2) != ";") return;
        for (std::size_t at = first; at < close; at += 3) {
            if (tokens_.text(at + 2) != ";") return;  // An array, or something else.
            const std::string field(tokens_.text(at + 1));
            fields += ' ' + std::string(tokens_.text(at)) + ' ' + field + ';';
            values += (values.empty() ? "" : ", ") + instance + "InBlock." + field;
        }
        const std::string type = "CopiedParameters";
        inserted_[tokens_[close + 1].end] = "InBlock";
        inserted_[tokens_[close + 2].end] =
            " struct " + type + " {" + fields + " }; " + type + ' ' + instance + " = " + type + '(' + values + ");";
    }

    const std::string& text_;
    const Tokens tokens_;
    Structs structs_;
    std::map<std::size_t, std::string> inserted_;  ///< By the byte of the text before which it stands.
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
