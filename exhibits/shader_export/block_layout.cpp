#include "exhibits/shader_export/block_layout.h"

#include "exhibits/shader_export/code_rewriter.h"
#include "exhibits/your_shader/reading.h"
#include "render/glsl/block_fields.h"
#include "render/glsl/lexer.h"
#include "render/text/trimmed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace vitrine::guest {
namespace {

std::string commentIn(std::string_view text)
{
    const std::size_t open = text.find("/*"), close = text.find("*/");
    if (open == std::string_view::npos || close == std::string_view::npos || close < open) return "";
    return std::string(render::trimmed(text.substr(open + 2, close - open - 2), " \t"));
}

int columnsOf(const std::string& type)
{
    return type.size() == 4 && type.starts_with("mat") ? type.back() - '0' : 0;
}

template <typename T> T numberAt(std::span<const std::byte> bytes, std::size_t offset)
{
    T value{};
    if (offset + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// Returns a scalar of a block as GLSL.
std::string scalarText(char letter, std::span<const std::byte> bytes, std::size_t offset)
{
    if (letter == 'f') {
        const double x = numberAt<float>(bytes, offset);
        return floatText(std::isfinite(x) ? x : 0);
    }
    const auto whole = numberAt<std::int32_t>(bytes, offset);
    if (letter == 'b') return whole != 0 ? "true" : "false";
    return letter == 'u' ? std::to_string(static_cast<std::uint32_t>(whole)) + 'u' : std::to_string(whole);
}

/// Returns the letter of a type's numbers: f, i, u or b.
char letterOf(const std::string& type)
{
    return type.starts_with('v') || type.starts_with('m') ? 'f' : type.front();
}

std::string valueText(const std::string& type, std::span<const std::byte> bytes, std::size_t offset)
{
    const int columns = columnsOf(type);
    const std::size_t rows = columns > 0 ? static_cast<std::size_t>(columns) : componentsOf(type);
    if (columns == 0 && rows == 1) return scalarText(letterOf(type), bytes, offset);
    std::string text;
    for (int column = 0; column < std::max(columns, 1); ++column)
        for (std::size_t row = 0; row < rows; ++row)
            text += (text.empty() ? "" : ", ") +
                    scalarText(letterOf(type), bytes, offset + 16 * static_cast<std::size_t>(column) + 4 * row);
    return type + '(' + text + ')';
}

std::size_t roundedUp(std::size_t x, std::size_t to)
{
    return (x + to - 1) / to * to;
}

}  // namespace

std::vector<BlockField> fieldsOfMacro(const std::string& text, const GlslMacros& macros)
{
    // `# define X_FIELDS(FIELD, ARRAY)` has eight tokens; then the fields follow, each with a comment behind it.
    constexpr std::size_t first = 8;
    const render::Tokens tokens(text);
    std::vector<BlockField> fields;
    for (const render::ListedField& listed : render::listedFields(tokens, first)) {
        BlockField field{std::string(listed.type), std::string(listed.name)};
        if (!listed.count.empty()) field.count = wholeNumber(macros, std::string(listed.count));
        const std::size_t end = tokens[std::min(listed.last, tokens.size() - 1)].end;
        const std::size_t next = listed.last + 1 < tokens.size() ? tokens[listed.last + 1].begin : text.size();
        field.comment = commentIn(std::string_view(text).substr(end, next - end));
        fields.push_back(std::move(field));
    }
    return fields;
}

std::vector<BlockField> fieldsInBraces(const std::string& text, const GlslMacros& macros)
{
    const render::Tokens tokens(text);
    std::vector<BlockField> fields;
    std::size_t i = 0;
    while (i < tokens.size() && tokens.text(i) != "{") ++i;
    for (++i; i + 1 < tokens.size() && tokens.text(i) != "}";) {
        BlockField field{std::string(tokens.text(i)), std::string(tokens.text(i + 1))};
        i += 2;
        if (tokens.text(i) == "[") {
            const std::size_t count = tokens[i + 1].begin;
            while (i + 1 < tokens.size() && tokens.text(i) != "]") ++i;
            field.count = wholeNumber(macros, text.substr(count, tokens[i - 1].end - count));
            ++i;
        }
        ++i;
        fields.push_back(std::move(field));
    }
    return fields;
}

std::string structText(const std::string& name, const std::vector<BlockField>& fields,
                       const std::set<std::string>& used)
{
    std::string text = "struct " + name + " {\n";
    for (const BlockField& field : fields) {
        if (!used.contains(field.name)) continue;
        text += "    " + field.type + ' ' + field.name;
        if (field.count > 0) text += '[' + std::to_string(field.count) + ']';
        text += field.comment.empty() ? ";\n" : ";  // " + field.comment + '\n';
    }
    return text + "};\n";
}

BlockConstants::Shape BlockConstants::shapeOf(const std::string& type) const
{
    if (const int columns = columnsOf(type); columns > 0) return {16, 16 * static_cast<std::size_t>(columns)};
    const auto found = structs_.find(type);
    if (found == structs_.end()) {
        const std::size_t count = std::max<std::size_t>(componentsOf(type), 1);
        return {count > 2 ? 16 : 4 * count, 4 * count};
    }
    std::size_t at = 0;
    for (const BlockField& field : found->second) {
        const Shape shape = shapeOf(field.type);
        const std::size_t stride = roundedUp(shape.size, 16);
        at = roundedUp(at, field.count > 0 ? 16 : shape.alignment);
        at += field.count > 0 ? stride * static_cast<std::size_t>(field.count) : shape.size;
    }
    return {16, roundedUp(at, 16)};
}

void BlockConstants::write(const std::string& type, std::size_t offset, std::span<const std::byte> bytes,
                           const std::string& name, const std::set<std::string>& without, std::string& lines) const
{
    if (without.contains(name)) return;
    if (const auto found = structs_.find(type); found != structs_.end()) {
        writeAll(found->second, offset, bytes, name + '.', without, lines);
        return;
    }
    lines += "    " + name + " = " + valueText(type, bytes, offset) + ";\n";
}

std::size_t BlockConstants::writeAll(const std::vector<BlockField>& fields, std::size_t offset,
                                     std::span<const std::byte> bytes, const std::string& prefix,
                                     const std::set<std::string>& without, std::string& lines) const
{
    std::size_t at = offset;
    for (const BlockField& field : fields) {
        const Shape shape = shapeOf(field.type);
        const bool isUsed = used_.contains(field.name) && !without.contains(prefix + field.name);
        at = roundedUp(at, field.count > 0 ? 16 : shape.alignment);
        if (field.count == 0) {
            if (isUsed) write(field.type, at, bytes, prefix + field.name, without, lines);
            at += shape.size;
            continue;
        }
        const std::size_t stride = roundedUp(shape.size, 16);
        // Elements at the end that are all 0 are not used.
        int last = field.count;
        const auto isZero = [&](int i) {
            const std::size_t begin = at + stride * static_cast<std::size_t>(i);
            const std::size_t end = std::min(begin + shape.size, bytes.size());
            return begin >= end || std::all_of(bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                                               bytes.begin() + static_cast<std::ptrdiff_t>(end),
                                               [](std::byte each) { return each == std::byte{0}; });
        };
        while (last > 0 && isZero(last - 1)) --last;
        for (int i = 0; i < last && isUsed; ++i)
            write(field.type, at + stride * static_cast<std::size_t>(i), bytes,
                  prefix + field.name + '[' + std::to_string(i) + ']', without, lines);
        at += stride * static_cast<std::size_t>(field.count);
    }
    return at;
}

std::string BlockConstants::lines(const std::vector<BlockField>& fields, std::span<const std::byte> bytes,
                                  const std::string& prefix, const std::set<std::string>& without) const
{
    std::string text;
    writeAll(fields, 0, bytes, prefix, without, text);
    return text;
}

}  // namespace vitrine::guest
