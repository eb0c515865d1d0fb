#include "exhibits/sdf_scenes/glsl_expression.h"

#include "render/files/number_text.h"

#include <cctype>

namespace vitrine::scenes {
namespace {

bool isWordByte(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

std::string floatLiteral(double x)
{
    std::string text = render::shortestNumber(static_cast<double>(static_cast<float>(x)));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text.starts_with('-') ? '(' + text + ')' : text;
}

std::string writtenOut(std::string_view expression, const ExpressionNames& names,
                       const std::function<std::string(std::uint32_t)>& number)
{
    std::string text;
    for (std::size_t at = 0; at < expression.size();) {
        if (!isWordByte(expression[at])) {
            text += expression[at++];
            continue;
        }
        std::size_t end = at;
        while (end < expression.size() && isWordByte(expression[end])) ++end;
        const std::string_view token = expression.substr(at, end - at);
        const bool isMember = at > 0 && expression[at - 1] == '.';
        if (token == "V" || token == "V3") {
            const std::size_t close = expression.find(')', end);
            const auto i =
                static_cast<std::uint32_t>(render::parseNumber(expression.substr(end + 1, close - end - 1)).value());
            text += token == "V" ? number(i) : "vec3(" + number(i) + ", " + number(i + 1) + ", " + number(i + 2) + ')';
            at = close + 1;
            continue;
        }
        const auto found = names.find(token);
        text += found != names.end() && !isMember ? found->second : std::string(token);
        at = end;
    }
    return text;
}

}  // namespace vitrine::scenes
