#include "render/text/message.h"

#include <algorithm>
#include <ostream>

namespace vitrine {

std::string withPlaces(std::string_view text, const std::vector<std::string>& places)
{
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::size_t digit = i + 1;
        if (digit < text.size() && text[digit] == '=') ++digit;
        const bool place = text[i] == '{' && digit + 1 < text.size() && text[digit + 1] == '}' && text[digit] >= '1' &&
                           text[digit] <= '9' && static_cast<std::size_t>(text[digit] - '0') <= places.size();
        if (!place) {
            made += text[i];
            continue;
        }
        made += places[static_cast<std::size_t>(text[digit] - '1')];
        i = digit + 1;
    }
    return made;
}

std::string Message::english() const
{
    if (arguments_.empty()) return std::string(text());
    std::vector<std::string> places;
    for (const Message& argument : arguments_) places.push_back(argument.english());
    return withPlaces(text(), places);
}

bool Message::isMarked() const
{
    return kind_ != Kind::unmarked &&
           std::all_of(arguments_.begin(), arguments_.end(), [](const Message& one) { return one.isMarked(); });
}

std::ostream& operator<<(std::ostream& stream, const Message& message)
{
    return stream << message.english();
}

}  // namespace vitrine
