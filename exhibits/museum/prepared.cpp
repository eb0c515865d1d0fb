#include "exhibits/museum/prepared.h"

#include "exhibits/hall/hall_scene.h"

#include <limits>

namespace vitrine {

std::vector<Message> Prepared::unreadableFiles() const
{
    std::vector<Message> sentences;
    const auto take = [&](const PreparedPart* part) {
        if (!part) return;
        for (const UnreadableFile& file : part->unreadable) sentences.push_back(file.why);
    };
    take(hall.get());
    for (const PreparedExhibit& exhibit : exhibits) take(exhibit.part.get());
    return sentences;
}

double Prepared::sincePress(std::size_t i) const
{
    return i < sincePressed.size() ? sincePressed[i] : std::numeric_limits<double>::infinity();
}

ExhibitState Prepared::state(std::size_t i) const
{
    return {sceneState.values[i], time, sincePress(i), exhibits[i].part.get()};
}

}  // namespace vitrine
