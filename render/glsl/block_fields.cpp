#include "render/glsl/block_fields.h"

namespace vitrine::render {

std::vector<ListedField> listedFields(const Tokens& tokens, std::size_t first)
{
    std::vector<ListedField> fields;
    for (std::size_t i = first; tokens.text(i) == "FIELD" || tokens.text(i) == "ARRAY"; i = fields.back().last + 1) {
        std::size_t last = i;
        while (last < tokens.size() && tokens.text(last) != ")") ++last;
        ListedField field{.type = tokens.text(i + 2), .name = tokens.text(i + 4), .last = last};
        if (tokens.text(i) == "ARRAY" && i + 6 < last)
            field.count = tokens.whole().substr(tokens[i + 6].begin, tokens[last - 1].end - tokens[i + 6].begin);
        fields.push_back(field);
    }
    return fields;
}

}  // namespace vitrine::render
