#include "ui/study/both_settings_button.h"

#include "exhibits/study/kept_study.h"
#include "render/failure.h"
#include "ui/kit/message_of.h"
#include "ui/model/settings_b.h"
#include "ui/study/comparison_dialog.h"
#include "ui/study/study_dock.h"
#include "ui/study/study_view.h"

namespace vitrine::ui {

BothSettingsButton::BothSettingsButton(StudyDock& dock, const SettingsB& other, QWidget* parent)
    : QPushButton(tr("Measure A and B"), parent), dock_(dock), other_(other)
{
    setToolTip(tr("Measures with the present settings, A, and then with the settings B of the comparison. Both curves "
                  "are shown in one chart."));
    setVisible(other.isSet());
    connect(&other, &SettingsB::changed, this, [this] { setVisible(other_.isSet()); });
    connect(this, &QPushButton::clicked, this, &BothSettingsButton::begin);
    connect(&dock, &StudyDock::finished, this, &BothSettingsButton::goOn);
    connect(&dock, &StudyDock::stopped, this, [this] { b_.reset(); });
}

void BothSettingsButton::begin()
{
    if (!other_.isSet()) return;
    const SceneState b = other_.sceneState();  // Later edits of B do not change what is measured.
    const QString name = other_.name();
    a_.reset();
    dock_.measurePresent();
    if (!dock_.running()) return;
    b_ = b;
    nameOfB_ = name;
}

void BothSettingsButton::goOn()
{
    if (!b_) return;
    if (a_) return showBoth(dock_.view().json());
    a_ = dock_.view().json();
    dock_.measureWith(*b_);
    if (!dock_.running()) b_.reset();
}

void BothSettingsButton::showBoth(const render::Json& b)
{
    b_.reset();
    try {
        std::vector<study::KeptStudy> studies;
        for (const auto& [json, name] : {std::pair(*a_, tr("A")), std::pair(b, tr("B: %1").arg(nameOfB_))})
            studies.push_back(study::parseStudy(render::parseJson(
                render::writeJson(study::named(json, name.toStdString())), name.toStdString(), study::studyLimits)));
        auto* dialog = new ComparisonDialog(std::move(studies), window());
        connect(dialog, &ComparisonDialog::failed, &dock_, &StudyDock::failed);
        dialog->show();
    } catch (const Failure& failure) {
        emit dock_.failed(messageOf(failure));
    }
}

}  // namespace vitrine::ui

#include "moc_both_settings_button.cpp"
