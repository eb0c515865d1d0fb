#include "exhibits/museum/prepared.h"

#include <limits>

namespace vitrine {

std::vector<std::string> Prepared::unreadableFiles() const
{
    std::vector<std::string> sentences;
    for (const PreparedExhibit& exhibit : exhibits) {
        if (!exhibit.part) continue;
        for (const UnreadableFile& file : exhibit.part->unreadable) sentences.push_back(file.why);
    }
    return sentences;
}

double Prepared::sincePress(std::size_t i) const
{
    return i < sincePressed.size() ? sincePressed[i] : std::numeric_limits<double>::infinity();
}

ExhibitState Prepared::state(std::size_t i) const
{
    return {look.values[i], time, sincePress(i), exhibits[i].part.get()};
}

}  // namespace vitrine
