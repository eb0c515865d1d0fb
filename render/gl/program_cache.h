#pragma once

#include "render/gl/program.h"
#include "render/gl/renderer.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vitrine::render::gl {

/// Programs by key, built when first used; in a debug build rebuilt when a file of theirs changes.
class ProgramCache {
public:
    /// The program, or its last good build. Throws Failure (Blame::shader) when it never built.
    [[nodiscard]] GLuint use(const ShaderKey&);

    /// Rebuilds programs whose files are newer on disk than their build. Returns whether any was tried.
    bool reloadChanged();
    [[nodiscard]] const std::vector<ShaderProblem>& problems() const { return problems_; }
    [[nodiscard]] std::size_t size() const { return programs_.size(); }
    [[nodiscard]] int built() const { return built_; }  ///< Builds so far that the cache on disk did not serve.
    void abandon();

private:
    struct Entry {
        ShaderKey key;
        BuiltProgram build;
        std::filesystem::file_time_type newest{};
    };
    void rebuild(Entry&);
    [[nodiscard]] std::filesystem::file_time_type newestFile(const std::vector<std::string>& files) const;

    ShaderSource source_;
    std::map<std::string, Entry> programs_;
    std::vector<ShaderProblem> problems_;
    int built_ = 0;
};

}  // namespace vitrine::render::gl
