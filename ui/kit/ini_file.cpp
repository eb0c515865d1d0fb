#include "ui/kit/ini_file.h"

#include <filesystem>

namespace vitrine::ui {

QString iniPath(const QString& path)
{
    constexpr std::uintmax_t largest = 4U << 20U;
    // Reads the path's status only, and opens nothing.
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path.toStdString(), error);
    const bool isMissing = status.type() == std::filesystem::file_type::not_found;
    const bool isFile =
        std::filesystem::is_regular_file(status) && std::filesystem::file_size(path.toStdString(), error) <= largest;
    return isMissing || isFile ? path : QStringLiteral("/proc/self/no-settings.ini");
}

}  // namespace vitrine::ui
