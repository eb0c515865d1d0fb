#pragma once

#include "render/gl/program.h"
#include "render/gl/program_builder.h"
#include "render/gl/renderer.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::render::gl {

/// What to draw with.
struct ProgramInUse {
    GLuint program = 0;
    std::string standIn = {};  ///< Why this is not the program that was asked for; empty when it is.
    bool building = false;     ///< The one that was asked for will be there in a later frame.
    /// Of a stand-in from its slot that was made of other generated sources: their hash.
    std::optional<std::uint64_t> ofSources = {};
    std::string better = {};  ///< What it is where it is the better one (ShaderKey::better).
};

/// Programs by key, built when first used; in a debug build rebuilt when a file of theirs changes. A driver keeps about
/// 2 MB for each, and choices make hundreds of permutations, so what was not used for the longest time is let go: the
/// cache on disk brings it back. Programs of a slot (ShaderKey::slot) are built in the background where a context for
/// that was given or the driver can by itself, as long as there is one to draw with meanwhile.
class ProgramCache {
public:
    /// So many programs are kept that the last frame did not use.
    static constexpr std::size_t mostIdle = 24;

    /// Builds on a thread with this context from now on.
    void buildWith(std::shared_ptr<SharedContext>);

    /// What is used from now on is used by this frame.
    void beginFrame() { ++frame_; }
    /// Deletes all but `mostIdle` of the programs that this frame has not used.
    void dropIdle();

    enum class Building { goesOn, isWaitedFor };
    /// The program, or one that stands in for it: its last good build, or another of its slot. Throws Failure
    /// (Blame::shader) when there is none.
    [[nodiscard]] ProgramInUse use(const ShaderKey&, Building = Building::goesOn);
    /// The better program of a key (ShaderKey::better) where it is built; nothing while it is not. Begins to build it.
    [[nodiscard]] std::optional<ProgramInUse> useBetter(const ShaderKey&);

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
        bool building = false;                  ///< In the background.
        std::optional<PendingProgram> pending;  ///< Of a driver that builds by itself.
    };
    using Programs = std::map<std::string, Entry>;

    void rebuild(Entry&);
    void take(Entry&, BuiltProgram);
    void beginInBackground(const std::string& id, Entry&);
    void takeWhatIsFinished(const std::string& id, Entry&);
    void buildNow(const std::string& id, Entry&);
    void giveUpOthers(const std::string& slot, const std::string& id);
    [[nodiscard]] bool canWait(const ShaderKey&) const;
    [[nodiscard]] std::optional<ProgramInUse> standIn(const Entry&);
    [[nodiscard]] std::filesystem::file_time_type newestFile(const std::vector<std::string>& files) const;

    ShaderSource source_;
    Programs programs_;
    std::map<std::string, std::string> lastGood_;  ///< Slot -> id of the program that was last drawn with.
    std::vector<ShaderProblem> problems_;
    int built_ = 0;
    std::uint64_t frame_ = 0;
    std::unique_ptr<ProgramBuilder> builder_;
};

}  // namespace vitrine::render::gl
