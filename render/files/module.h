#pragma once

#include "render/text/message.h"

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::render {

/// Part of the program in a separate library, which is opened on first use.
struct ModuleFile {
    std::string name;             ///< "libvitrine_oiio.so".
    std::filesystem::path built;  ///< Path in the build folder.
    const char* symbol;           ///< The symbol that it exports.
    Message purpose;              ///< "reads and writes pictures", for messages.
    Message needs;                ///< "OpenImageIO", for messages.
};

/// Opens a module. Searches beside the executable, one folder up, in ../lib/vitrine/modules, and where it was built.
/// Takes the first library for whose symbol `made` returns an object (null: it belongs to another version), and returns
/// that object. The library is never closed, because threads of its dependencies would outlive their code. Throws
/// Failure (ErrorKind::file) if none can be opened.
[[nodiscard]] void* openModule(const ModuleFile&, const std::function<void*(void* symbol)>& made);

}  // namespace vitrine::render
