#include "exhibits/framework/state_folder.h"

#include <QDir>
#include <QStandardPaths>
#include <QString>

#include <cstdlib>

namespace vitrine {

std::filesystem::path stateFolder()
{
    const char* configured = std::getenv("XDG_STATE_HOME");
    const std::filesystem::path folder = configured ? configured : "";
    if (folder.is_absolute()) return folder / "vitrine";
    return std::filesystem::path(QDir::homePath().toStdString()) / ".local" / "state" / "vitrine";
}

std::filesystem::path userPresetFolder()
{
    // GenericDataLocation: AppDataLocation would append whatever organization and application are set.
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return std::filesystem::path(data.toStdString()) / "vitrine" / "presets";
}

std::filesystem::path configFolder()
{
    return std::filesystem::path(
               QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation).toStdString()) /
           "vitrine";
}

}  // namespace vitrine
