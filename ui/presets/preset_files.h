#pragma once

#include "exhibits/framework/files/preset_tags.h"
#include "ui/kit/language.h"

#include <QFileDialog>
#include <QString>
#include <QStringList>

#include <filesystem>
#include <string>

namespace vitrine::ui {

[[nodiscard]] inline std::filesystem::path pathOf(const QString& id)
{
    return id.toStdString();
}

[[nodiscard]] inline QString idOf(const std::filesystem::path& path)
{
    return QString::fromStdString(path.string());
}

[[nodiscard]] inline QString words(const std::string& s)
{
    return QString::fromStdString(s);
}

/// Returns the displayed name of a preset. Names of presets that come with the exhibits are translated; their files
/// stay English.
[[nodiscard]] inline QString presetName(const std::string& name, bool shipped)
{
    return shipped ? translatedText(name) : words(name);
}

/// Returns the displayed tags of a preset, likewise translated.
[[nodiscard]] inline QStringList presetTags(const PresetTags& tags, bool shipped)
{
    QStringList shown;
    for (const std::string& tag : tags) shown << presetName(tag, shipped);
    return shown;
}

[[nodiscard]] inline QFileDialog* fileDialog(QWidget* window, const QString& title, QFileDialog::AcceptMode mode,
                                             const QString& filter)
{
    auto* dialog = new QFileDialog(window, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(mode == QFileDialog::AcceptOpen ? QFileDialog::ExistingFile : QFileDialog::AnyFile);
    dialog->setNameFilter(filter);
    if (mode == QFileDialog::AcceptSave) dialog->setDefaultSuffix(QStringLiteral("vitrine-preset.json"));
    return dialog;
}

}  // namespace vitrine::ui
