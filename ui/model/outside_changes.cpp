#include "ui/model/outside_changes.h"

#include "ui/kit/language.h"
#include "ui/model/scene_state_change.h"

#include <QCoreApplication>

namespace vitrine::ui {

OutsideChanges::Places OutsideChanges::differing(const SceneState& before, const SceneState& after)
{
    Places places;
    for (std::size_t e = 0; e < before.values.size(); ++e) {
        const ParameterValues &from = before.values[e], &to = after.values[e];
        if (from.sharedTable() != to.sharedTable()) {
            places.emplace(e, std::string());
            continue;
        }
        for (std::size_t r = 0; r < from.rows().size(); ++r) {
            const Motion *was = from.motion(r), *is = to.motion(r);
            const bool moves = (was != nullptr) != (is != nullptr) || (was && *was != *is);
            if (from.row(r) != to.row(r) || moves) places.emplace(e, std::string(from.rows()[r].name));
        }
    }
    return places;
}

void OutsideChanges::make(const SceneState& before, const SceneState& after)
{
    SceneState next = history_.sceneState();
    SceneStateChange(before, after).apply(next);
    if (SceneStateChange(history_.sceneState(), next).empty()) return;
    Places places = differing(before, after);
    if (places != last_ || !since_.isValid() || since_.elapsed() > sameStep) gesture_ = newGesture();
    since_.start();
    last_ = std::move(places);
    QString text = QObject::tr("Change values by the service");
    if (last_.size() == 1 && !last_.begin()->second.empty()) {
        const ParameterValues& values = next.values[last_.begin()->first];
        if (const auto row = values.table().find(last_.begin()->second))
            text = QObject::tr("Change %1 by the service").arg(midSentence(translatedText(label(values.rows()[*row]))));
    }
    history_.change(text, next, gesture_);
}

}  // namespace vitrine::ui
