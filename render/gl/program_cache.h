#pragma once

#include "render/gl/program.h"
#include "render/gl/renderer.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace vitrine::render::gl {

/// Programs by key, built when first used; in a debug build rebuilt when a file of theirs changes. A driver keeps about
/// 2 MB for each, and choices make hundreds of permutations, so what was not used for the longest time is let go: the
/// cache on disk brings it back.
class ProgramCache {
public:
    /// So many programs are kept that the last frame did not use.
    static constexpr std::size_t mostIdle = 24;

    /// What is used from now on is used by this frame.
    void beginFrame() { ++frame_; }
    /// Deletes all but `mostIdle` of the programs that this frame has not used.
    void dropIdle();

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
        std::uint64_t lastUse = 0;
    };
    void rebuild(Entry&);
    [[nodiscard]] std::filesystem::file_time_type newestFile(const std::vector<std::string>& files) const;

    ShaderSource source_;
    std::map<std::string, Entry> programs_;
    std::vector<ShaderProblem> problems_;
    int built_ = 0;
    std::uint64_t frame_ = 0;
};

}  // namespace vitrine::render::gl
