#include "ui/compare/compare_controller.h"

#include "exhibits/compare/differing_parameters.h"
#include "exhibits/museum/named_files.h"
#include "render/video/carried_settings.h"
#include "ui/compare/compare_actions.h"
#include "ui/compare/compare_bar.h"
#include "ui/compare/compare_overlay.h"
#include "ui/compare/picture_b.h"
#include "ui/kit/file_patterns.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/model/settings_b.h"
#include "ui/model/workbench.h"
#include "ui/presets/preset_controller.h"
#include "ui/viewport/viewport.h"

#include <QFileDialog>

namespace vitrine::ui {
namespace {

constexpr int lookAtFilesEvery = 1000;  // Milliseconds.

/// Returns the key under which the message strip lists problems of drawing B.
QString drawingOfB()
{
    return QStringLiteral("drawing of B");
}

}  // namespace

CompareController::CompareController(Workbench& workbench, PresetController& presetController, QWidget* parent)
    : QObject(parent), workbench_(workbench), presetController_(presetController), window_(parent),
      other_(new SettingsB(workbench.history(), this)),
      picture_(new PictureB(workbench.viewport(), workbench.renderers(), *other_, this)),
      overlay_(new CompareOverlay(workbench.viewport(), *other_, *picture_)), actions_(new CompareActions(*this)),
      bar_(new CompareBar(*this, parent))
{
    connect(other_, &SettingsB::changed, this, &CompareController::refresh);
    connect(overlay_, &CompareOverlay::needsChanged, this, &CompareController::refresh);
    connect(&workbench.history(), &History::changesSettled, bar_, &CompareBar::refresh);
    connect(picture_, &PictureB::drawn, this, [this] {
        workbench_.setProblems(drawingOfB(), {});
        tellReport();
    });
    connect(picture_, &PictureB::gone, this, &CompareController::tellReport);
    connect(picture_, &PictureB::failed, this,
            [this](const QString& why) { workbench_.setProblems(drawingOfB(), {tr("B: %1").arg(why)}); });
    fileWatch_.setInterval(lookAtFilesEvery);
    connect(&fileWatch_, &QTimer::timeout, this, &CompareController::lookAtFiles);
    bar_->refresh();
}

CompareController::~CompareController() = default;

void CompareController::refresh()
{
    if (!other_->isSet() && overlay_->mode() != CompareMode::off) {
        overlay_->setMode(CompareMode::off);  // Calls this function again.
        return;
    }
    if (!other_->isSet() || !namesFiles(other_->sceneState())) {
        fileWatch_.stop();
    } else if (!fileWatch_.isActive()) {
        filesRead_ = stateOfFiles(workbench_.museum().subjects(), other_->sceneState());
        fileWatch_.start();
    }
    picture_->setWanted(other_->isSet() && (overlay_->mode() != CompareMode::off || overlay_->otherAlone()));
    actions_->refresh();
    bar_->refresh();
    tellReport();
}

void CompareController::tellReport()
{
    if (!other_->isSet())
        emit reportChanged(nullptr, {});
    else if (!picture_->wanted())
        emit reportChanged(nullptr, tr("B: not drawn, because no view shows it"));
    else if (!picture_->failure().isEmpty())
        emit reportChanged(nullptr, tr("B: cannot be drawn"));
    else if (picture_->image().isNull())
        emit reportChanged(nullptr, tr("B: being drawn"));
    else
        emit reportChanged(&picture_->report(), {});
}

void CompareController::setMode(CompareMode mode)
{
    if (mode != CompareMode::off && !other_->isSet()) setToCurrent();
    overlay_->setMode(mode);
    refresh();  // Needed even if nothing changed, because an action may have been unchecked.
}

void CompareController::set(const SceneState& sceneState, const QString& name)
{
    // Files that the state names may add parameters. They are read on the render thread.
    workbench_.viewport().renderThread().post(
        [this, &museum = workbench_.museum(), sceneState, name, number = ++holds_]() -> std::function<void()> {
            const TabledSceneState read = museum.readTables(sceneState);
            return [this, read, name, number] {
                if (number != holds_) return;
                QStringList unreadable;
                for (const Message& why : read.unreadable) unreadable << tr("B: %1").arg(translatedText(why));
                workbench_.setProblems(QStringLiteral("files of B"), unreadable);
                if (name.isNull())
                    other_->readAgain(read.sceneState);
                else
                    other_->set(read.sceneState, name);
                if (overlay_->mode() == CompareMode::off && !overlay_->otherAlone()) setMode(CompareMode::wipe);
            };
        });
}

void CompareController::lookAtFiles()
{
    const std::uint64_t now = stateOfFiles(workbench_.museum().subjects(), other_->sceneState());
    if (now == filesRead_) return;
    filesRead_ = now;
    set(other_->sceneState(), {});
}

void CompareController::setToCurrent()
{
    ++holds_;
    // The parameter tables of A have been read already.
    other_->set(workbench_.history().sceneState(), tr("Snapshot of A"));
    if (overlay_->mode() == CompareMode::off) setMode(CompareMode::wipe);
}

void CompareController::holdSelectedPreset()
{
    if (const QString id = presetController_.selected(); !id.isEmpty())
        holdFile(id);
    else
        workbench_.say(MessageStrip::Mood::notice, tr("B was not set: select a preset in the list first."));
}

void CompareController::holdFile(const QString& path)
{
    if (const std::optional<ReadSettings> found = presetController_.settingsIn(path))
        set(found->sceneState, found->name);
}

void CompareController::holdStep(int step, const QString& name)
{
    set(workbench_.history().valuesAt(step), name);
}

void CompareController::compareWith(std::size_t subject, const OfferedComparison& offered)
{
    ++holds_;
    other_->follow([subject, offered](const SceneState& a) { return compare::otherSide(a, subject, offered); },
                   text(offered.title));
    if (overlay_->mode() == CompareMode::off) setMode(CompareMode::wipe);
    if (differences().empty())
        workbench_.say(MessageStrip::Mood::notice,
                       tr("“%1” is already shown: both sides are the same.").arg(text(offered.title)));
}

void CompareController::chooseFile()
{
    auto* dialog = new QFileDialog(window_, tr("Open as B"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(
        tr("Presets, and pictures with one inside (%1)").arg(filePatterns("json " + render::carriedSettingsEndings())));
    connect(dialog, &QFileDialog::fileSelected, this, &CompareController::holdFile);
    dialog->open();
}

void CompareController::letGo()
{
    ++holds_;
    overlay_->setOtherAlone(false);
    other_->letGo();
}

std::vector<std::pair<QString, QString>> CompareController::presets() const
{
    return presetController_.choices(workbench_.shown());
}

const QUndoStack& CompareController::steps() const
{
    return workbench_.history().stack();
}

History& CompareController::history() const
{
    return workbench_.history();
}

std::vector<ParameterDifference> CompareController::differences() const
{
    std::vector<ParameterDifference> all;
    if (!other_->isSet()) return all;
    for (const compare::DifferingParameter& row :
         compare::differingParameters(workbench_.history().sceneState(), other_->sceneState())) {
        const auto value = [&](const std::optional<Value>& v) {
            return v ? QString::fromStdString(compare::valueWithUnit(row.info, *v)) : tr("no such parameter");
        };
        all.push_back({row.subject, row.name,
                       tr("%1: %2: %3 | %4")
                           .arg(translatedText(workbench_.museum().subject(row.subject).title()),
                                translatedText(label(row.info)), value(row.a), value(row.b))});
    }
    return all;
}

}  // namespace vitrine::ui

#include "moc_compare_controller.cpp"
