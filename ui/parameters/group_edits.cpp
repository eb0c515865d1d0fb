#include "ui/parameters/group_edits.h"

#include "ui/kit/language.h"

namespace vitrine::ui {

GroupEdits::GroupEdits(History& history, std::size_t exhibit, QObject* parent)
    : QObject(parent), history_(history), exhibit_(exhibit)
{
}

void GroupEdits::setTogether(std::string_view array, bool together)
{
    if (together)
        together_.emplace(array);
    else if (const auto found = together_.find(array); found != together_.end())
        together_.erase(found);
    emit changed();
}

std::optional<std::size_t> GroupEdits::twinOf(std::size_t row, std::size_t element) const
{
    const auto rows = currentValues().rows();
    const ParameterInfo& info = rows[row];
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].array == info.array && rows[i].element == element &&
            rows[i].elementParameter == info.elementParameter && rows[i].kind == info.kind)
            return i;
    return std::nullopt;
}

std::vector<GroupEdits::Group> GroupEdits::groupsOf(std::string_view array) const
{
    std::vector<Group> groups;
    for (const ParameterInfo& parameter : currentValues().rows())
        if (!array.empty() && parameter.array == array &&
            (groups.empty() || groups.back().element != parameter.element))
            groups.push_back({parameter.element, std::string(parameter.group)});
    return groups;
}

std::vector<std::size_t> GroupEdits::parametersWith(std::size_t row) const
{
    std::vector<std::size_t> all{row};
    const ParameterInfo& info = currentValues().rows()[row];
    if (info.array.empty() || !together(info.array)) return all;
    for (const Group& group : groupsOf(info.array))
        if (const auto twin = twinOf(row, group.element); twin && *twin != row) all.push_back(*twin);
    return all;
}

void GroupEdits::setValue(std::size_t row, const Value& value, Gesture gesture, const QString& words)
{
    const std::vector<std::size_t> rows = parametersWith(row);
    if (rows.size() == 1) {
        history_.set(exhibit_, row, value, gesture, words);
        return;
    }
    SceneState next = history_.sceneState();
    ParameterValues& values = next.values[exhibit_];
    for (const std::size_t each : rows) {
        values.setMotion(each, std::nullopt);  // Setting the value ends the animation.
        values.chooseFile(each, value);
    }
    const QString name = midSentence(translatedText(labelInGroup(values.rows()[row])));
    history_.change(words.isEmpty() ? tr("Change %1 of all together").arg(name) : words, next, gesture);
}

void GroupEdits::reset(std::size_t row, Gesture gesture, const QString& words)
{
    const std::vector<std::size_t> rows = parametersWith(row);
    if (rows.size() == 1) {
        history_.set(exhibit_, row, currentValues().rows()[row].initial, gesture, words);
        return;
    }
    SceneState next = history_.sceneState();
    ParameterValues& values = next.values[exhibit_];
    for (const std::size_t each : rows) {
        values.setMotion(each, std::nullopt);
        values.chooseFile(each, values.rows()[each].initial);
    }
    history_.change(words, next, gesture);
}

void GroupEdits::setMotion(std::size_t row, const QString& words, const std::optional<Motion>& motion,
                           const Value& base)
{
    SceneState next = history_.sceneState();
    for (const std::size_t each : parametersWith(row)) {
        next.values[exhibit_].setMotion(each, motion);
        next.values[exhibit_].setParameter(each, base);
    }
    history_.change(words, next);
}

void GroupEdits::copyInto(ParameterValues& values, std::string_view array, std::size_t from, std::size_t to) const
{
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const ParameterInfo& row = values.rows()[i];
        if (row.array != array || row.element != from) continue;
        const std::optional<std::size_t> twin = twinOf(i, to);
        if (!twin) continue;
        values.chooseFile(*twin, values.row(i));
        const Motion* motion = values.motion(i);
        values.setMotion(*twin, motion ? std::optional(*motion) : std::nullopt);
    }
}

void GroupEdits::copy(std::string_view array, std::size_t from, std::size_t to)
{
    SceneState next = history_.sceneState();
    copyInto(next.values[exhibit_], array, from, to);
    history_.change(tr("Copy a group"), next);
}

void GroupEdits::copyToOthers(std::string_view array, std::size_t from)
{
    SceneState next = history_.sceneState();
    for (const Group& group : groupsOf(array))
        if (group.element != from) copyInto(next.values[exhibit_], array, from, group.element);
    history_.change(tr("Copy a group to the others"), next);
}

bool GroupEdits::alike(std::string_view array, std::size_t a, std::size_t b) const
{
    ParameterValues values = currentValues();
    copyInto(values, array, a, b);
    return values == currentValues();
}

}  // namespace vitrine::ui

#include "moc_group_edits.cpp"
#include "ui/kit/language.h"
