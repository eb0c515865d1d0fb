#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace vitrine::render {

/// Part of the program in a library of its own, opened when it is first needed.
struct ModuleFile {
    std::string name;             ///< "libvitrine_oiio.so".
    std::filesystem::path built;  ///< Where it was built.
    const char* symbol;           ///< The one that it exports.
    std::string purpose;          ///< "reads and writes pictures", for messages.
    std::string needs;            ///< "OpenImageIO", for messages.
};

/// Looks for it beside the running program, one folder up, in ../lib/vitrine/modules, and where it was built, and opens
/// the first whose symbol `made` turns into something (null: it belongs to another version). It is never closed:
/// threads of what it links would outlive their code. Throws Failure (Blame::file) when none can be opened.
[[nodiscard]] void* openModule(const ModuleFile&, const std::function<void*(void* symbol)>& made);

}  // namespace vitrine::render
