#include "ui/presets/recent_presets.h"

#include "exhibits/framework/files/state_folder.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/preferences.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace vitrine::ui {
namespace {
namespace recent_presets {

constexpr int most = 6;
const QString key = QStringLiteral("recentPresets");

QSettings settings()
{
    return QSettings(iniPath(QString::fromStdString((stateFolder() / "window.ini").string())), QSettings::IniFormat);
}

}  // namespace recent_presets
}  // namespace

QStringList recentPresets()
{
    QStringList there;
    for (const QString& path : recent_presets::settings().value(recent_presets::key).toStringList())
        if (QFileInfo::exists(path)) there << path;
    return there.mid(0, std::min(recent_presets::most, Preferences::saved().recentFiles));
}

void addRecentPreset(const QString& path)
{
    QStringList presets = recentPresets();
    if (!presets.isEmpty() && presets.front() == path) return;
    presets.removeAll(path);
    presets.prepend(path);
    recent_presets::settings().setValue(recent_presets::key, presets.mid(0, recent_presets::most));
}

void renameRecentPreset(const QString& before, const QString& after)
{
    QStringList presets = recent_presets::settings().value(recent_presets::key).toStringList();
    if (!presets.contains(before)) return;
    presets.replace(presets.indexOf(before), after);
    recent_presets::settings().setValue(recent_presets::key, presets);
}

}  // namespace vitrine::ui
