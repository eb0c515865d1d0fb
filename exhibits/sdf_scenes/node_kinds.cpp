#include "exhibits/sdf_scenes/node_kinds.h"

#include <algorithm>
#include <iterator>

namespace vitrine::scenes {

std::size_t NodeKind::numbers() const
{
    return numberOf("");
}

std::size_t NodeKind::numberOf(std::string_view field) const
{
    std::size_t number = 0;
    for (const Field& f : fields) {
        if (f.name == field) break;
        number += numbersOf(f.type);
    }
    return number;
}

const std::vector<NodeKind>& nodeKinds()
{
    static const std::vector<NodeKind> kinds = [] {
        std::vector<NodeKind> all;
        for (std::vector<NodeKind> part :
             {solidKinds(), furtherSolidKinds(), profileKinds(), operandKinds(), modifierKinds(), repeaterKinds()})
            all.insert(all.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
        return all;
    }();
    return kinds;
}

const NodeKind* findKind(std::string_view name)
{
    const std::vector<NodeKind>& kinds = nodeKinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const NodeKind& k) { return k.name == name; });
    return found == kinds.end() ? nullptr : &*found;
}

render::Box grown(const render::Box& box, double by)
{
    return {box.low - by, box.high + by};
}

render::Box boxAround(const glm::dvec3& halfSize)
{
    return {-halfSize, halfSize};
}

render::Box endlessBox()
{
    return boxAround(glm::dvec3(std::numeric_limits<double>::infinity()));
}

}  // namespace vitrine::scenes
