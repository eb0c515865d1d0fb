#pragma once

#include "app/queue/shard.h"
#include "render/files/json_text.h"
#include "render/image/image.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::app {

/// What a job that is split into parts makes before it is put together: the folder OUT.parts. It holds `job.json`, the
/// command of all parts; for each part that has ended `part_K.json`, which lists its files with a hash of each or says
/// why it failed; and the files.
class Parts {
public:
    /// To make one part: makes the folder, and forgets what this part said before. Throws Failure: Blame::usage where
    /// the folder belongs to another job, Blame::file where it cannot be made.
    Parts(const std::filesystem::path& out, const Shard&);
    /// To put all together. Throws Failure (Blame::check) naming each part that is missing, failed, damaged or was
    /// drawn by another renderer, one to a line, with the command that makes it.
    explicit Parts(const std::filesystem::path& out);

    /// The command of all parts, without --shard. Throws Failure (Blame::check) where there are none, or of another
    /// version of the program.
    [[nodiscard]] static std::vector<std::string> commandFor(const std::filesystem::path& out);

    [[nodiscard]] const Shard& shard() const { return shard_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// A file of that name in the folder.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    /// This part wrote the file of that name itself.
    void wrote(const std::string& name);
    /// Writes a picture, bit for bit, and what goes with it.
    void keep(const std::string& name, const render::Image&, const render::Json& about = nullptr);
    /// What `keep` wrote; nothing when there is none of that name. Throws Failure (Blame::check) where it is damaged.
    [[nodiscard]] std::optional<render::Image> kept(const std::string& name, render::Json* about = nullptr) const;

    /// The part is whole; `renderer` drew it.
    void finish(const std::string& renderer);
    /// The part ended with this sentence.
    void fail(const std::string& why);

private:
    [[nodiscard]] std::filesystem::path reportOf(int part) const;
    [[nodiscard]] std::string commandOf(int part) const;
    /// Of one part, why it cannot be used; empty: it can. Adds its renderer.
    [[nodiscard]] std::string problemOf(int part, std::map<std::string, int>& renderers) const;

    std::filesystem::path folder_;
    Shard shard_;
    std::vector<std::string> command_;
    render::Json files_ = render::Json::object();
};

/// Makes a part by `make`, which returns the renderer's name, or nothing when it was stopped; says that it is made, or
/// why not. Returns the exit code; throws what `make` throws.
int runPart(const std::filesystem::path& out, const Shard&,
            const std::function<std::optional<std::string>(Parts&)>& make);

}  // namespace vitrine::app
