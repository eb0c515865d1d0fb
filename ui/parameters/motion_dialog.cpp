#include "ui/parameters/motion_dialog.h"

#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/make_editor.h"
#include "ui/parameters/parameter_row.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace vitrine::ui {
namespace {

/// Parameters of an animation beside its two ends, as a table, so that they have the usual controls.
struct MotionTable final : Parameters {
    Choice<MotionKind> kind =
        choice("kind", MotionKind::sine, {"once", "sine", "triangle", "steps", "noise", "by distance"},
               "Course from the first value to the second: once, there and back (sine or triangle), in steps, at "
               "random (noise), or by the distance of the visitor.");
    Choice<Ease> ease = choice("ease", Ease::inOut, {"even", "slow at first", "slow at last", "slow at both"},
                               "Acceleration at the start and the end of each way.");
    Real period = real("period", 4, second, Range{shortestPeriod, longestPeriod, logarithmic}.soft(0.5, 60),
                       "Duration of one way, or of there and back if it repeats.");
    Real phase = real("phase", 0, none, Range{-1e9, 1e9}.soft(0, 1),
                      "Position in the period when the clock starts, in periods.");
    Real start = real("start", 0, second, Range{-1e9, 1e9}.soft(0, 60), "Time at which the animation starts.");
    Count steps = count("steps", 4, Range{2, mostMotionSteps, logarithmic}.soft(2, 16),
                        "Number of values, evenly spaced from the first to the second.");
    Count seed = count("seed", 1, Range{0, 4294967295.0}.soft(0, 100), "Seed of the random values.");
    Real nearest = real("nearest", 1, meter, Range{0, 1e4}.soft(0, 20),
                        "Distance of the visitor at which, or nearer, the parameter has the first value.");
    Real farthest = real("farthest", 6, meter, Range{0, 1e4}.soft(0, 20),
                         "Distance of the visitor at which, or farther, the parameter has the second value.");
};

const MotionTable& motionTable()
{
    static const MotionTable table;
    return table;
}

ParameterValues numbersOf(const Motion& motion)
{
    const MotionTable& t = motionTable();
    ParameterValues values = t.initial();
    values.set(t.kind, motion.kind);
    values.set(t.ease, motion.ease);
    values.set(t.period, motion.period);
    values.set(t.phase, motion.phase);
    values.set(t.start, motion.start);
    values.set(t.steps, motion.steps);
    values.setParameter(t.seed.row, static_cast<double>(motion.seed));
    values.set(t.nearest, motion.nearest);
    values.set(t.farthest, motion.farthest);
    return values;
}

Motion withNumbers(Motion motion, const ParameterValues& values)
{
    const MotionTable& t = motionTable();
    motion.kind = values[t.kind];
    motion.ease = values[t.ease];
    motion.period = values[t.period];
    motion.phase = values[t.phase];
    motion.start = values[t.start];
    motion.steps = values[t.steps];
    motion.seed = static_cast<std::uint32_t>(std::get<double>(values.row(t.seed.row)));
    motion.nearest = values[t.nearest];
    motion.farthest = values[t.farthest];
    return motion;
}

/// Returns whether animations of this kind use a parameter of the table.
bool isUsed(MotionKind kind, std::size_t row)
{
    const MotionTable& t = motionTable();
    if (row == t.ease.row) return isEased(kind);
    if (row == t.period.row) return kind != MotionKind::distance;
    if (row == t.phase.row) return isPeriodic(kind);
    if (row == t.start.row) return kind == MotionKind::ease;
    if (row == t.steps.row) return kind == MotionKind::steps;
    if (row == t.seed.row) return kind == MotionKind::noise;
    if (row == t.nearest.row || row == t.farthest.row) return kind == MotionKind::distance;
    return true;
}

}  // namespace

Motion usualMotion(const ParameterInfo& parameter, const Value& now)
{
    Motion motion;
    motion.from = now;
    if (const double* number = std::get_if<double>(&now)) {
        const auto way = [&](double end) {
            const bool byFactors = parameter.range.scale == Scale::logarithmic && *number > 0 && end > 0;
            return std::abs(byFactors ? std::log(end / *number) : end - *number);
        };
        const bool up = way(parameter.range.softHigh) >= way(parameter.range.softLow);
        motion.to = parameter.kind == Kind::toggle ? 1 - *number
                    : up                           ? parameter.range.softHigh
                                                   : parameter.range.softLow;
        if (parameter.kind == Kind::choice)
            motion.to = *number + 1 < static_cast<double>(parameter.choices.size()) ? *number + 1 : 0;
    } else if (const auto* three = std::get_if<glm::dvec3>(&now)) {
        // Colors: the complement to white. Directions: a quarter turn about the vertical.
        if (parameter.kind == Kind::color)
            motion.to = glm::dvec3(1) - *three;
        else
            motion.to = std::abs(three->y) > 0.99 ? glm::dvec3(1, 0, 0) : glm::dvec3(three->z, three->y, -three->x);
    }
    motion.to = nearestLegal(parameter, motion.to).value_or(now);
    return motion;
}

/// Values of the dialog's table; setting one changes the animation.
class MotionDialog::Numbers final : public ValueOwner {
public:
    explicit Numbers(MotionDialog& dialog) : dialog_(dialog) {}

    [[nodiscard]] const ParameterValues& currentValues() const override { return values_; }
    void setValue(std::size_t row, const Value& value, Gesture, const QString&) override
    {
        const Motion* motion = dialog_.present();
        if (!motion) return;
        values_.setParameter(row, value);
        dialog_.change(withNumbers(*motion, values_));
    }
    void take(const Motion& motion) { values_ = numbersOf(motion); }

private:
    MotionDialog& dialog_;
    ParameterValues values_ = motionTable().initial();
};

/// Values of the exhibit in which the animated parameter has its value at one end.
class MotionDialog::End final : public ValueOwner {
public:
    End(MotionDialog& dialog, Value Motion::*end, const ParameterValues& values, std::size_t row)
        : dialog_(dialog), end_(end), values_(values), row_(row)
    {
    }

    [[nodiscard]] const ParameterValues& currentValues() const override { return values_; }
    void setValue(std::size_t, const Value& value, Gesture, const QString&) override
    {
        const Motion* motion = dialog_.present();
        if (!motion) return;
        Motion changed = *motion;
        changed.*end_ = value;
        dialog_.change(changed);
    }
    void take(const Motion& motion)
    {
        values_.setParameter(row_, motion.*end_);
        editor->showValue(values_.row(row_));
    }
    [[nodiscard]] ValueRef ref() { return {*this, row_}; }

    ValueEditor* editor = nullptr;

private:
    MotionDialog& dialog_;
    Value Motion::*end_;
    ParameterValues values_;
    std::size_t row_;
};

MotionDialog::MotionDialog(History& history, std::size_t exhibit, const std::vector<std::size_t>& rows, QWidget* parent)
    : InlineDialog(
          tr("Animate %1").arg(translatedText(label(history.sceneState().values[exhibit].rows()[rows.front()]))),
          tr("Done"), parent),
      history_(history), exhibit_(exhibit), name_(history.sceneState().values[exhibit].rows()[rows.front()].name),
      before_(history.sceneState()), numbers_(std::make_unique<Numbers>(*this))
{
    const ParameterValues& values = history.sceneState().values[exhibit];
    const std::size_t row = rows.front();
    for (std::size_t i = 1; i < rows.size(); ++i) others_.emplace_back(values.rows()[rows[i]].name);
    const ParameterInfo& info = values.rows()[row];
    from_ = std::make_unique<End>(*this, &Motion::from, values, row);
    to_ = std::make_unique<End>(*this, &Motion::to, values, row);
    addEnd(*from_, tr("From"));
    addEnd(*to_, tr("To"));
    addNumbers();
    if (!present()) change(usualMotion(info, values.row(row)));
    history_.watch(exhibit_, this, [this](std::optional<std::size_t>) { refresh(); });
    refresh();
}

MotionDialog::~MotionDialog()
{
    // The editors use the objects that are destroyed after them.
    for (ParameterRow* row : rows_) delete row;
    for (const End* end : {from_.get(), to_.get()}) delete end->editor;
}

void MotionDialog::addEnd(End& end, const QString& name)
{
    auto* line = new QHBoxLayout;
    line->setContentsMargins(16, 0, 22, 0);
    line->setSpacing(4);
    auto* words = new QLabel(name, this);
    growWidth(*words, ParameterRow::narrowestLabel);
    end.editor = makeEditor(end.ref(), this);
    end.editor->setAccessibleName(name);
    for (QWidget* child : end.editor->findChildren<QWidget*>())
        if (child->focusPolicy() != Qt::NoFocus) child->setAccessibleName(name);
    line->addWidget(words);
    line->addWidget(end.editor, 1);
    body().addLayout(line);
}

void MotionDialog::addNumbers()
{
    auto* lines = new QVBoxLayout;
    lines->setSpacing(0);
    for (std::size_t i = 0; i < motionTable().rows().size(); ++i) {
        rows_.push_back(new ParameterRow(ValueRef(*numbers_, i), this));
        lines->addWidget(rows_.back());
    }
    body().addLayout(lines);
}

ParameterRow* MotionDialog::row(std::string_view name) const
{
    const std::optional<std::size_t> i = motionTable().find(name);
    return i && !rows_[*i]->isHidden() ? rows_[*i] : nullptr;
}

const Motion* MotionDialog::present() const
{
    const ParameterValues& values = history_.sceneState().values[exhibit_];
    const std::optional<std::size_t> row = values.table().find(name_);
    return row ? values.motion(*row) : nullptr;
}

void MotionDialog::change(const Motion& motion)
{
    SceneState next = history_.sceneState();
    ParameterValues& values = next.values[exhibit_];
    const std::optional<std::size_t> row = values.table().find(name_);
    if (!row || !values.setMotion(*row, motion)) return;
    for (const std::string& other : others_)
        if (const auto twin = values.table().find(other)) values.setMotion(*twin, motion);
    history_.change(tr("Animate %1").arg(midSentence(translatedText(label(values.rows()[*row])))), next, gesture_);
}

void MotionDialog::refresh()
{
    const Motion* motion = present();
    if (!motion) {
        InlineDialog::reject();
        return;
    }
    numbers_->take(*motion);
    from_->take(*motion);
    to_->take(*motion);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i]->setVisible(isUsed(motion->kind, i));
        rows_[i]->showValue(numbers_->currentValues().row(i));
    }
}

void MotionDialog::reject()
{
    disconnect(&history_, nullptr, this, nullptr);
    SceneState next = history_.sceneState();
    ParameterValues& values = next.values[exhibit_];
    const auto takeBack = [&](const std::string& name) {
        const std::optional<std::size_t> now = values.table().find(name);
        const std::optional<std::size_t> then = before_.values[exhibit_].table().find(name);
        if (!now || !then) return;
        const Motion* motion = before_.values[exhibit_].motion(*then);
        values.setMotion(*now, motion ? std::optional(*motion) : std::nullopt);
    };
    takeBack(name_);
    for (const std::string& other : others_) takeBack(other);
    if (const auto row = values.table().find(name_))
        history_.change(tr("Animate %1").arg(midSentence(translatedText(label(values.rows()[*row])))), next, gesture_);
    InlineDialog::reject();
}

}  // namespace vitrine::ui

#include "moc_motion_dialog.cpp"
