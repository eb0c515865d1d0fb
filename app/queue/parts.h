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

/// Folder OUT.parts of a job that is split into parts. It contains `job.json`, with the command of all parts, and the
/// files of the parts. Each part that has ended has a `part_K.json`, which lists its files with their hashes or gives
/// the reason of a failure.
class Parts {
public:
    /// For making one part: makes the folder and removes an earlier report of this part. Throws Failure:
    /// ErrorKind::usage if the folder belongs to another job, ErrorKind::file if it cannot be made.
    Parts(const std::filesystem::path& out, const Shard&);
    /// For merging the parts. Throws Failure (ErrorKind::check) with a line for each part that is missing, failed,
    /// damaged or drawn by another renderer, and the command that makes it.
    explicit Parts(const std::filesystem::path& out);

    /// Returns the command of all parts, without --shard. Throws Failure (ErrorKind::check) if there are no parts, or
    /// those of another version of the program.
    [[nodiscard]] static std::vector<std::string> commandFor(const std::filesystem::path& out);

    [[nodiscard]] const Shard& shard() const { return shard_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// Returns the path of a file in the folder.
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_ / name; }

    /// Lists a file that this part wrote itself.
    void wrote(const std::string& name);
    /// Writes a picture exactly, with data about it.
    void keep(const std::string& name, const render::Image&, const render::Json& about = nullptr);
    /// Reads what `keep` wrote; nullopt if there is none of this name. Throws Failure (ErrorKind::check) if it is
    /// damaged.
    [[nodiscard]] std::optional<render::Image> kept(const std::string& name, render::Json* about = nullptr) const;

    /// Marks this part as complete. `renderer`: name of the renderer that drew it.
    void finish(const std::string& renderer);
    /// Marks this part as failed, with a sentence.
    void fail(const std::string& why);

private:
    [[nodiscard]] std::filesystem::path reportOf(int part) const;
    [[nodiscard]] std::string commandOf(int part) const;
    /// Returns why a part cannot be used; empty if it can. Counts its renderer in `renderers`.
    [[nodiscard]] std::string problemOf(int part, std::map<std::string, int>& renderers) const;

    std::filesystem::path folder_;
    Shard shard_;
    std::vector<std::string> command_;
    render::Json files_ = render::Json::object();
};

/// Makes a part by calling `make`, which returns the renderer's name, or nullopt if it was stopped. Prints the result.
/// Returns the exit code; throws what `make` throws.
int runPart(const std::filesystem::path& out, const Shard&,
            const std::function<std::optional<std::string>(Parts&)>& make);

}  // namespace vitrine::app
