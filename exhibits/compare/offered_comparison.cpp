#include "exhibits/compare/offered_comparison.h"

#include "exhibits/framework/scene/scene_object.h"
#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

namespace vitrine::compare {

std::vector<OfferedComparison> offeredComparisons(const SceneObject& subject)
{
    const auto* offers = capability<OffersComparisons>(subject);
    return offers ? offers->comparisons() : std::vector<OfferedComparison>();
}

OfferedComparison offeredComparison(const SceneObject& subject, std::string_view name)
{
    const std::vector<OfferedComparison> all = offeredComparisons(subject);
    for (const OfferedComparison& offered : all)
        if (offered.name == name) return offered;
    std::vector<std::string> names;
    for (const OfferedComparison& offered : all) names.push_back(offered.name);
    const std::string who(subject.name());
    throw Failure(ErrorKind::usage, names.empty()
                                        ? who + " offers no comparisons; name two settings."
                                        : who + " offers no comparison \"" + std::string(name) + "\"" +
                                              didYouMean(name, names) + " choose one of " + joined(names, ", ") + ".");
}

SceneState otherSide(const SceneState& a, std::size_t subject, const OfferedComparison& offered)
{
    SceneState b = a;
    ParameterValues& values = b.values[subject];
    for (const auto& [name, value] : offered.rows) {
        const auto row = values.table().find(name);
        if (!row) continue;
        values.setParameter(*row, value);
        values.setMotion(*row, std::nullopt);
    }
    return b;
}

}  // namespace vitrine::compare
