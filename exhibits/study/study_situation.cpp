#include "exhibits/study/study_situation.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/value_text.h"
#include "render/files/number_text.h"

#include <algorithm>

namespace vitrine::study {
namespace {

bool isAxis(const StudyRequest& request, const StudyParameter& row)
{
    return std::any_of(request.axes.begin(), request.axes.end(), [&](const StudyAxis& axis) {
        return StudyParameter{axis.subject, axis.row} == row;
    });
}

bool isPinned(const StudyRequest& request, const StudyParameter& row)
{
    return std::find(request.pinned.begin(), request.pinned.end(), row) != request.pinned.end();
}

/// Returns the parameters of a subject that keep their values.
std::vector<std::size_t> fixedParameters(const StudyRequest& request, std::size_t subject)
{
    std::vector<std::size_t> rows;
    for (const StudyAxis& axis : request.axes)
        if (axis.subject == subject) rows.push_back(axis.row);
    for (const StudyParameter& pinned : request.pinned)
        if (pinned.subject == subject) rows.push_back(pinned.row);
    return rows;
}

/// Changes settings until a parameter has an effect, and records the changes.
class Arrangement {
public:
    Arrangement(const StudyRequest& request, StudySituation& situation) : request_(request), situation_(situation) {}

    void makeActing(std::size_t axis)
    {
        const StudyAxis& studied = request_.axes[axis];
        ParameterValues values = valuesOf(studied);
        if (actsWithOthers(studied)) return;
        if (makeAct(values, studied.row, fixedParameters(request_, studied.subject)))
            take(axis, studied.subject, values, StudyChange::Why::acts);
    }

    void arrange(std::size_t axis)
    {
        const StudyAxis& studied = request_.axes[axis];
        const StudiedParameter declared = declaredOf(request_.sceneState, studied);
        for (const std::string_view name : declared.lifted) {
            const std::optional<std::size_t> row = valuesOf(studied).table().find(name);
            const std::optional<double> exact = row ? valuesOf(studied).rows()[*row].qualityReference : std::nullopt;
            if (exact && acts(valuesOf(studied), *row))
                set(axis, {studied.subject, *row}, *exact, StudyChange::Why::limits);
        }
        show(axis, studied.subject, declared.with);
        show(axis, hallIndex, declared.hall);
    }

private:
    [[nodiscard]] const ParameterValues& valuesOf(const StudyAxis& axis) const
    {
        return situation_.sceneState.values[axis.subject];
    }

    /// Whether the parameter acts at one of the values of another parameter that is studied with it.
    [[nodiscard]] bool actsWithOthers(const StudyAxis& studied) const
    {
        return std::any_of(request_.axes.begin(), request_.axes.end(), [&](const StudyAxis& other) {
            if (other == studied || other.subject != studied.subject) return false;
            ParameterValues values = valuesOf(studied);
            return std::any_of(other.values.begin(), other.values.end(), [&](double value) {
                values.setParameter(other.row, value);
                return acts(values, studied.row);
            });
        });
    }

    void show(std::size_t axis, std::size_t subject, const std::vector<StudiedParameter::Setting>& settings)
    {
        const Parameters& table = situation_.sceneState.values[subject].table();
        for (const StudiedParameter::Setting& setting : settings)
            if (const std::optional<std::size_t> row = table.find(setting.row))
                set(axis, {subject, *row}, setting.value, StudyChange::Why::shows);
    }

    void set(std::size_t axis, const StudyParameter& parameter, double value, StudyChange::Why why)
    {
        if (isAxis(request_, parameter) || isPinned(request_, parameter)) return;
        ParameterValues values = situation_.sceneState.values[parameter.subject];
        values.setParameter(parameter.row, value);
        if (!acts(values, parameter.row)) {
            std::vector<std::size_t> fixed = fixedParameters(request_, parameter.subject);
            fixed.push_back(parameter.row);
            if (!makeAct(values, parameter.row, fixed)) return;
        }
        take(axis, parameter.subject, values, why);
    }

    void take(std::size_t axis, std::size_t subject, const ParameterValues& changed, StudyChange::Why why)
    {
        ParameterValues& values = situation_.sceneState.values[subject];
        for (std::size_t row = 0; row < values.rows().size(); ++row) {
            if (values.row(row) == changed.row(row)) continue;
            values.setParameter(row, changed.row(row));
            values.setMotion(row, std::nullopt);
            note({{subject, row},
                  std::get<double>(request_.sceneState.values[subject].row(row)),
                  std::get<double>(changed.row(row)),
                  axis,
                  why});
        }
    }

    void note(const StudyChange& change)
    {
        auto& all = situation_.changes;
        std::erase_if(all, [&](const StudyChange& former) { return former.row == change.row; });
        if (change.from != change.to) all.push_back(change);
    }

    const StudyRequest& request_;
    StudySituation& situation_;
};

/// Returns whether every parameter acts in this view, and the view does not override a changed setting.
bool showsAll(const StudyRequest& request, const StudySituation& situation, const StudyView& view)
{
    for (const StudyAxis& axis : request.axes)
        if (axis.subject == request.subject && !acts(view.values, axis.row)) return false;
    return std::all_of(situation.changes.begin(), situation.changes.end(), [&](const StudyChange& change) {
        return change.row.subject != request.subject || view.values.row(change.row.row) == Value(change.to);
    });
}

/// Returns the declared views of the parameters; all views if none are declared.
std::vector<StudyView> declaredViews(const StudyRequest& request, const std::vector<StudyView>& all)
{
    std::vector<StudyView> views;
    for (const StudyAxis& axis : request.axes) {
        if (axis.subject != request.subject) continue;
        const StudiedParameter declared = declaredOf(request.sceneState, axis);
        for (const StudyView& view : all) {
            const bool isNamed =
                std::find(declared.views.begin(), declared.views.end(), view.name) != declared.views.end();
            const bool isNew = std::none_of(views.begin(), views.end(),
                                            [&](const StudyView& known) { return known.name == view.name; });
            if (isNamed && isNew) views.push_back(view);
        }
    }
    return views.empty() ? all : views;
}

/// Returns the acting parameters that are exact in the reference only.
std::vector<StudyParameter> exactParameters(const StudyRequest& request, const SceneState& sceneState)
{
    std::vector<StudyParameter> rows;
    for (const StudyAxis& axis : request.axes) {
        const ParameterValues& values = sceneState.values[axis.subject];
        for (const std::string_view name : declaredOf(sceneState, axis).exactInReference) {
            const std::optional<std::size_t> row = values.table().find(name);
            if (row && values.rows()[*row].qualityReference && acts(values, *row) &&
                !isAxis(request, {axis.subject, *row}))
                rows.push_back({axis.subject, *row});
        }
    }
    return rows;
}

std::string nameOf(Subjects subjects, const StudyRequest& request, const StudyParameter& row)
{
    return axisName(subjects, request.sceneState, request.subject, {row.subject, row.row, {}});
}

std::string textOf(const StudyRequest& request, const StudyParameter& row, double value)
{
    return axisValueText(request.sceneState, {row.subject, row.row, {}}, value);
}

/// Returns the name of a parameter in quotes.
std::string quoted(Subjects subjects, const StudyRequest& request, const StudyParameter& row, ParameterNames names)
{
    const StudyAxis at{row.subject, row.row, {}};
    return "“" +
           (names == ParameterNames::shown ? axisLabel(subjects, request.sceneState, request.subject, at)
                                           : axisName(subjects, request.sceneState, request.subject, at)) +
           "”";
}

std::string sentenceOf(Subjects subjects, const StudyRequest& request, const StudyChange& change, ParameterNames names)
{
    const StudyAxis& axis = request.axes[change.axis];
    const std::string parameter = quoted(subjects, request, {axis.subject, axis.row}, names);
    const std::string row = quoted(subjects, request, change.row, names);
    const std::string value = textOf(request, change.row, change.to);
    const std::string former = textOf(request, change.row, change.from);
    switch (change.why) {
    case StudyChange::Why::limits:
        return "Studied with " + row + " at " + value + " instead of " + former + ", which would limit " + parameter +
               ".";
    case StudyChange::Why::shows:
        return "Studied with " + row + " at " + value + " instead of " + former + ", so that " + parameter + " shows.";
    case StudyChange::Why::acts: break;
    }
    return "Studied with " + row + " at " + value + " instead of " + former + ", so that " + parameter + " acts.";
}

/// Returns a value in the form that `--set` reads: plain numbers are in SI units.
std::string optionText(const ParameterInfo& parameter, const Value& value)
{
    return parameter.isNumeric() ? render::shortestNumber(std::get<double>(value)) : formatValue(parameter, value);
}

}  // namespace

bool keepsSettings(const StudyRequest& request)
{
    return request.asSet || request.axes.size() > 2 || request.maxError || request.maxMilliseconds;
}

StudiedParameter declaredOf(const SceneState& sceneState, const StudyAxis& axis)
{
    return StudiedParameters::of(sceneState.values[axis.subject].table(), parameterOf(sceneState, axis).name);
}

StudySituation studySituation(Subjects subjects, const StudyRequest& request)
{
    StudySituation situation{request.sceneState, {}, {}, {}};
    const SceneObject& subject = *subjects[request.subject];
    if (keepsSettings(request)) {
        situation.views = subject.studyViews(request.sceneState.values[request.subject]);
        return situation;
    }
    Arrangement arrangement(request, situation);
    // Declared settings may themselves need conditions, so those are applied again at the end.
    for (std::size_t axis = 0; axis < request.axes.size(); ++axis) arrangement.makeActing(axis);
    for (std::size_t axis = 0; axis < request.axes.size(); ++axis) arrangement.arrange(axis);
    for (std::size_t axis = 0; axis < request.axes.size(); ++axis) arrangement.makeActing(axis);

    situation.exact = exactParameters(request, situation.sceneState);
    const std::vector<StudyView> all = subject.studyViews(situation.sceneState.values[request.subject]);
    situation.views = declaredViews(request, all);
    std::erase_if(situation.views, [&](const StudyView& view) { return !showsAll(request, situation, view); });
    if (situation.views.empty()) {
        StudyView view = all.front();
        view.values = situation.sceneState.values[request.subject];
        situation.views = {std::move(view)};
    }
    return situation;
}

std::vector<std::string> situationSentences(Subjects subjects, const StudyRequest& request, const StudyResult& result,
                                            ParameterNames names)
{
    std::vector<std::string> sentences;
    for (const StudyChange& change : result.changes) sentences.push_back(sentenceOf(subjects, request, change, names));
    for (const StudyAxis& axis : request.axes) {
        const ParameterValues& values = request.sceneState.values[axis.subject];
        for (const std::string_view name : declaredOf(request.sceneState, axis).lifted) {
            const std::optional<std::size_t> found = values.table().find(name);
            if (!found || !acts(values, *found)) continue;
            const StudyParameter row{axis.subject, *found};
            if (isAxis(request, row) || (!keepsSettings(request) && !isPinned(request, row))) continue;
            const double present = std::get<double>(values.row(*found));
            if (present == values.rows()[*found].qualityReference) continue;
            sentences.push_back(quoted(subjects, request, row, names) + " at " + textOf(request, row, present) +
                                " limits " + quoted(subjects, request, {axis.subject, axis.row}, names) +
                                ": see the error against everything exact.");
        }
    }
    for (const StudyParameter& row : result.exactInReference) {
        const double exact = *request.sceneState.values[row.subject].rows()[row.row].qualityReference;
        sentences.push_back("In the reference, " + quoted(subjects, request, row, names) + " is at " +
                            textOf(request, row, exact) + ".");
    }
    return sentences;
}

std::vector<std::string> settingsToRepeat(Subjects subjects, const StudyRequest& request, const StudyResult& result)
{
    SceneState sceneState = request.sceneState;
    for (const StudyChange& change : result.changes)
        sceneState.values[change.row.subject].setParameter(change.row.row, change.to);
    std::vector<std::string> settings;
    for (std::size_t subject = 0; subject < sceneState.values.size(); ++subject) {
        // Other exhibits are not in the picture if the subject is alone.
        if (request.alone && subject != request.subject && subject != hallIndex) continue;
        const ParameterValues& values = sceneState.values[subject];
        for (std::size_t row = 0; row < values.rows().size(); ++row)
            if (!values.isInitial(row))
                settings.push_back(nameOf(subjects, request, {subject, row}) + '=' +
                                   optionText(values.rows()[row], values.row(row)));
    }
    return settings;
}

}  // namespace vitrine::study
