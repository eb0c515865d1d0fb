#pragma once

#include <QTemporaryDir>

#include <initializer_list>
#include <memory>

namespace vitrine::test {

/// Programs that this process compiled for earlier tests: shared by all of them, or compiled anew.
enum class ProgramCaches { shared, none };

/// Returns an empty folder that takes the place of the user's home for this process: settings, presets and files of
/// state are read and written there, and the user's own are never touched.
[[nodiscard]] inline std::unique_ptr<QTemporaryDir> newHome(ProgramCaches caches)
{
    auto home = std::make_unique<QTemporaryDir>();
    for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME"})
        qputenv(name, home->path().toLocal8Bit());
    if (caches == ProgramCaches::none) qputenv("XDG_CACHE_HOME", home->path().toLocal8Bit());
    return home;
}

}  // namespace vitrine::test
