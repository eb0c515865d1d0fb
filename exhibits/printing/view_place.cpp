#include "exhibits/printing/view_place.h"

#include "exhibits/printing/print_layout.h"
#include "render/failure.h"
#include "render/files/number_text.h"
#include "render/text/trimmed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace vitrine::printing {
namespace {

std::string_view trimmed(std::string_view text)
{
    return render::trimmed(text, " ");
}

/// Removes everything up to the first `sign` from `left`, and the sign with it; all of `left` if it has no such sign.
/// Returns the removed text, trimmed, without the sign.
std::string_view takeTo(char sign, std::string_view& left)
{
    const std::size_t at = left.find(sign);
    const std::string_view part = left.substr(0, at);
    left = at == std::string_view::npos ? std::string_view() : left.substr(at + 1);
    return trimmed(part);
}

/// Parses "3:1.5,2,-0.5". Returns nothing if the text has another form or a number is out of its range.
std::optional<std::pair<int, ViewPlace>> onePlace(std::string_view text)
{
    const auto picture = render::parseNumber(takeTo(':', text));
    if (!picture || *picture < 1 || *picture > 1e6 || *picture != std::floor(*picture)) return std::nullopt;
    std::array<double, 3> numbers{};
    const std::array<double, 3> most{mostTurn, mostShift, mostShift};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto number = render::parseNumber(takeTo(',', text));
        if (!number || std::abs(*number) > most[i]) return std::nullopt;
        numbers[i] = *number;
    }
    if (!text.empty()) return std::nullopt;
    return std::pair{static_cast<int>(*picture), ViewPlace{numbers[0], {numbers[1], numbers[2]}}};
}

}  // namespace

ViewPlaces viewPlaces(std::string_view text)
{
    ViewPlaces places;
    std::string lines(text);
    std::replace(lines.begin(), lines.end(), '\n', ';');
    for (std::string_view left = lines; !trimmed(left).empty();) {
        const std::string_view part = takeTo(';', left);
        if (part.empty()) continue;
        const auto place = onePlace(part);
        if (!place)
            throw Failure(ErrorKind::usage,
                          "Cannot place a picture by \"" + std::string(part) +
                              "\": this is not PICTURE:TURN,RIGHT,DOWN; give the picture's number, degrees clockwise "
                              "(-360 to 360) and percent of the view's width and height (-100 to 100), such as "
                              "3:1.5,2,-0.5.");
        places[place->first] = place->second;
    }
    return places;
}

std::string textOf(const ViewPlaces& places)
{
    std::string text;
    for (const auto& [picture, place] : places) {
        if (place == ViewPlace{}) continue;
        if (!text.empty()) text += "; ";
        text += std::to_string(picture) + ':' + render::shortestNumber(place.turn) + ',' +
                render::shortestNumber(place.shift.x) + ',' + render::shortestNumber(place.shift.y);
    }
    return text;
}

ViewPlace placeOf(const ViewPlaces& places, int picture)
{
    const auto found = places.find(picture);
    return found == places.end() ? ViewPlace{} : found->second;
}

void requirePictures(const ViewPlaces& places, int pictures)
{
    if (places.empty() || places.rbegin()->first <= pictures) return;
    throw Failure(ErrorKind::usage, "Cannot place picture " + std::to_string(places.rbegin()->first) +
                                        ": the last picture is number " + std::to_string(pictures) +
                                        "; correct its number.");
}

}  // namespace vitrine::printing
