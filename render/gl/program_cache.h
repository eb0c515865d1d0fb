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

/// Program to draw with.
struct ProgramInUse {
    GLuint program = 0;
    /// Reason why a fallback is used instead of the requested program; empty if it is not a fallback.
    std::string fallback = {};
    bool building = false;  ///< The requested program is being built and will be used in a later frame.
    /// If a fallback from the same family is used: hash of the generated sources that it was built from, if they
    /// differ.
    std::optional<std::uint64_t> ofSources = {};
    /// Description of the specialized program (ShaderKey::specialized), if that is used; else empty.
    std::string specialized = {};
};

/// Programs by key, built on first use. In a debug build they are rebuilt when one of their files changes. A driver
/// needs about 2 MB for each, and options make hundreds of permutations. So the least recently used are deleted; the
/// cache on disk restores them quickly. Programs of a family (ShaderKey::programFamily) are built in the background
/// while another program can be used in their place. That needs a context for a thread (`buildWith`) or a driver that
/// compiles in the background.
class ProgramCache {
public:
    /// Number of programs that are kept although the last frame did not use them.
    static constexpr std::size_t mostIdle = 24;

    ProgramCache() { allowBuildThreads(); }

    /// Builds programs of families on a thread with this context from now on. Null stops that thread.
    void buildWith(std::shared_ptr<SharedContext>);

    /// Starts a new frame: programs used from now on count as used by it.
    void beginFrame() { ++frame_; }
    /// Deletes all but `mostIdle` of the programs that this frame has not used.
    void dropIdle();

    enum class Building { goesOn, isWaitedFor };
    /// Starts building the programs of these passes that a frame has to wait for, all at once. A driver that compiles
    /// in the background then needs the time of the slowest of them instead of their sum. Does nothing for others.
    void begin(const std::vector<Pass>&, Building);
    /// Returns the program or a fallback: its last good build, or another program of its family. Throws Failure
    /// (ErrorKind::shader) if there is none.
    [[nodiscard]] ProgramInUse use(const ShaderKey&, Building = Building::goesOn);
    /// Returns the specialized program of a key (ShaderKey::specialized) if it is built. Otherwise starts building it
    /// and returns nothing.
    [[nodiscard]] std::optional<ProgramInUse> useSpecialized(const ShaderKey&);

    /// Rebuilds programs whose files on disk are newer than their build. Returns whether it tried to rebuild any.
    bool reloadChanged();
    [[nodiscard]] const std::vector<ShaderProblem>& problems() const { return problems_; }
    [[nodiscard]] std::size_t size() const { return programs_.size(); }
    /// Builds so far that were not served by the cache on disk, in their order.
    [[nodiscard]] const std::vector<ProgramBuild>& builds() const { return builds_; }
    void abandon();

private:
    struct Entry {
        ShaderKey key;
        BuiltProgram build;
        std::filesystem::file_time_type newest{};
        std::uint64_t lastUse = 0;
        bool building = false;                  ///< Being built in the background.
        bool awaited = false;                   ///< Being built because a frame waits for it (`begin`).
        std::optional<PendingProgram> pending;  ///< For a driver that compiles in the background.
    };
    using Programs = std::map<std::string, Entry>;

    void rebuild(Entry&);
    void take(Entry&, BuiltProgram);
    void beginInBackground(const std::string& id, Entry&);
    void takeWhatIsFinished(const std::string& id, Entry&);
    void buildNow(const std::string& id, Entry&);
    void giveUpOthers(const std::string& family, const std::string& id);
    [[nodiscard]] bool canWait(const ShaderKey&) const;
    [[nodiscard]] std::optional<ProgramInUse> fallback(const Entry&);
    [[nodiscard]] std::filesystem::file_time_type newestFile(const std::vector<std::string>& files) const;

    ShaderSource source_;
    Programs programs_;
    std::map<std::string, std::string> lastGood_;  ///< Family -> id of the program that was last used successfully.
    std::vector<ShaderProblem> problems_;
    std::vector<ProgramBuild> builds_;
    std::uint64_t frame_ = 0;
    std::unique_ptr<ProgramBuilder> builder_;
};

}  // namespace vitrine::render::gl
