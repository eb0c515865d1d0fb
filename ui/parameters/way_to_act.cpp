#include "ui/parameters/way_to_act.h"

#include "exhibits/framework/table/acting.h"
#include "ui/kit/language.h"
#include "ui/parameters/shown_text.h"

#include <QObject>
#include <QStringList>

namespace vitrine::ui {

std::optional<ParameterChanges> changesToAct(const ParameterValues& values, std::size_t row)
{
    ParameterValues changed = values;
    if (!makeAct(changed, row, {})) return std::nullopt;
    ParameterChanges changes;
    for (std::size_t i = 0; i < values.rows().size(); ++i)
        if (!(changed.row(i) == values.row(i))) changes.emplace_back(i, changed.row(i));
    return changes;
}

std::optional<IdleGroup> idleGroup(const ParameterValues& values, std::span<const std::size_t> rows)
{
    std::optional<IdleGroup> best;
    for (const std::size_t row : rows) {
        if (acts(values, row)) return std::nullopt;
        const ParameterChanges changes = changesToAct(values, row).value_or(ParameterChanges{});
        const bool shorter =
            best && !changes.empty() && (best->changes.empty() || changes.size() < best->changes.size());
        if (!best || shorter) best = {row, changes};
    }
    return best;
}

QString changesText(const ParameterValues& values, const ParameterChanges& changes)
{
    QStringList parts;
    for (const auto& [row, value] : changes) {
        const ParameterInfo& info = values.rows()[row];
        parts << QObject::tr("“%1” to %2").arg(translatedText(label(info)), shownText(info, value));
    }
    return parts.isEmpty() ? QString() : QObject::tr("Set %1").arg(parts.join(QStringLiteral(", ")));
}

}  // namespace vitrine::ui
