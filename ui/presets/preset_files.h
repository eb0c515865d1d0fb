#pragma once

#include <QFileDialog>
#include <QString>

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
