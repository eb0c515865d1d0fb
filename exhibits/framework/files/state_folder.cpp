#include "exhibits/framework/files/state_folder.h"

#include "render/failure.h"
#include "render/files/atomic_write.h"

#include <QDir>
#include <QStandardPaths>
#include <QString>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

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
    // Not AppDataLocation: it would append the organization and application names of Qt.
    const QString data = QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation);
    return std::filesystem::path(data.toStdString()) / "vitrine" / "presets";
}

std::filesystem::path configFolder()
{
    return std::filesystem::path(
               QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation).toStdString()) /
           "vitrine";
}

namespace {

bool liesIn(const std::filesystem::path& path, const std::filesystem::path& folder)
{
    const auto relative = path.lexically_normal().lexically_relative(folder.lexically_normal());
    return !relative.empty() && *relative.begin() != "..";
}

}  // namespace

void writeOwnFile(const std::filesystem::path& path, std::string_view bytes)
{
    const std::filesystem::path folder = path.parent_path();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!error && ::access(folder.c_str(), W_OK) != 0) error.assign(errno, std::generic_category());
    if (!error) return render::atomicWrite(path, bytes);
    const std::string what = "Cannot write " + path.string() + ": " + error.message();
    if (liesIn(path, stateFolder()))
        throw Failure(ErrorKind::file,
                      what + "; allow writing in that folder, or start Vitrine with XDG_STATE_HOME set to "
                             "a folder that can be written. Until then nothing is saved there.");
    if (liesIn(path, userPresetFolder()))
        throw Failure(ErrorKind::file, what +
                                           "; allow writing in that folder, or start Vitrine with XDG_DATA_HOME set to "
                                           "a folder that can be written.");
    throw Failure(ErrorKind::file, what + "; allow writing in that folder.");
}

}  // namespace vitrine
