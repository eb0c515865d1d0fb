#include "ui/export/export_presets.h"

#include "exhibits/framework/files/state_folder.h"
#include "render/failure.h"

#include <QByteArray>

#include <algorithm>
#include <string>
#include <system_error>

namespace vitrine::ui {
namespace {

constexpr const char* presetEnding = ".vitrine-job.json";

/// Returns the file name of a preset. Any name makes a name of one file: "a/b" becomes "a%2Fb".
std::string fileNameOf(const QString& name)
{
    std::string text;
    for (const char c : name.toUtf8()) {
        const bool isPlain = static_cast<unsigned char>(c) >= 0x20 && c != '/' && c != '%';
        if (isPlain && !(c == '.' && text.empty()))
            text += c;
        else
            text += '%' + QByteArray(1, c).toHex().toUpper().toStdString();
    }
    return text + presetEnding;
}

std::filesystem::path folderOf(const jobs::Job& job)
{
    return userPresetFolder().parent_path() / "export-presets" / std::string(job.name());
}

}  // namespace

ExportPresets::ExportPresets(const jobs::Job& job) : job_(job) {}

QStringList ExportPresets::names() const
{
    QStringList names;
    std::error_code noFolder;
    for (const auto& entry : std::filesystem::directory_iterator(folderOf(job_), noFolder)) {
        const QString name = QString::fromStdString(entry.path().filename().string());
        if (name.endsWith(QLatin1String(presetEnding)))
            names << QString::fromUtf8(
                QByteArray::fromPercentEncoding(name.chopped(QLatin1String(presetEnding).size()).toUtf8()));
    }
    std::sort(names.begin(), names.end(),
              [](const QString& a, const QString& b) { return QString::localeAwareCompare(a, b) < 0; });
    return names;
}

std::filesystem::path ExportPresets::file(const QString& name) const
{
    return folderOf(job_) / fileNameOf(name);
}

void ExportPresets::save(const QString& name, const ParameterValues& values) const
{
    writeOwnFile(file(name), documentText(job_, jobs::JobOrder{values}, {}));
}

jobs::JobDocument ExportPresets::read(const QString& name) const
{
    return jobs::readDocument(file(name), job_, nullptr);
}

void ExportPresets::remove(const QString& name) const
{
    std::error_code error;
    std::filesystem::remove(file(name), error);
    if (error)
        throw Failure(ErrorKind::file, message("Cannot delete {1}: {2}; allow writing in that folder.",
                                               file(name).string(), error.message()));
}

}  // namespace vitrine::ui
