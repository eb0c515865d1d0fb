#include "ui/model/settings_b.h"

#include "exhibits/compare/differing_parameters.h"

namespace vitrine::ui {

SettingsB::SettingsB(History& history, QObject* parent) : QObject(parent), history_(history)
{
    connect(&history, &History::changed, this, &SettingsB::catchUp);
    connect(&history, &History::replaced, this, &SettingsB::catchUp);
}

QString SettingsB::name() const
{
    return edited_ ? name_ + QStringLiteral(" *") : name_;
}

void SettingsB::show(const State& held)
{
    sceneState_ = held.sceneState;
    name_ = held.name;
    edited_ = held.edited;
    following_ = held.following;
    emit changed();
}

void SettingsB::catchUp()
{
    if (!following_) return;
    SceneState now = following_(history_.sceneState());
    if (now.values == sceneState_->values) return;  // B has no camera of its own.
    sceneState_ = std::move(now);
    emit changed();
}

void SettingsB::set(const SceneState& sceneState, const QString& name)
{
    show({sceneState, name, false});
}

void SettingsB::follow(Following following, const QString& name)
{
    SceneState now = following(history_.sceneState());
    show({std::move(now), name, false, std::move(following)});
}

void SettingsB::readAgain(const SceneState& sceneState)
{
    show({sceneState, name_, edited_, following_});
}

void SettingsB::letGo()
{
    if (isSet()) show({});
}

void SettingsB::record(const QString& text, const SceneState& a, const State& b)
{
    const State before{sceneState_, name_, edited_, following_};
    history_.record(
        text, a, [this, b] { show(b); }, [this, before] { show(before); });
}

void SettingsB::swap()
{
    SceneState a = history_.sceneState(), b = sceneState();
    std::swap(a.values, b.values);
    record(tr("Swap A and B"), a, {b, tr("The former A"), false});
}

void SettingsB::takeAll()
{
    SceneState a = history_.sceneState();
    a.values = sceneState().values;
    history_.change(tr("Copy all from B"), a);
}

void SettingsB::giveAll()
{
    record(tr("Copy all to B"), history_.sceneState(), {history_.sceneState(), tr("Snapshot of A"), false});
}

void SettingsB::take(std::size_t exhibit, const std::string& row)
{
    SceneState a = history_.sceneState();
    if (compare::copyParameter(sceneState(), a, exhibit, row))
        history_.change(tr("Copy %1 from B").arg(QString::fromStdString(row)), a, newGesture());
}

void SettingsB::give(std::size_t exhibit, const std::string& row)
{
    SceneState b = sceneState();
    if (compare::copyParameter(history_.sceneState(), b, exhibit, row) && !(b == sceneState()))
        record(tr("Copy %1 to B").arg(QString::fromStdString(row)), history_.sceneState(), {b, name_, true});
}

}  // namespace vitrine::ui

#include "moc_settings_b.cpp"
