#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Share of a job that is split into parts: part `part` of `of`, both from 1.
struct Shard {
    int part = 1, of = 1;

    /// Returns whether item `number` (from 0) belongs to the part, as every `of`th one does.
    [[nodiscard]] bool makes(std::size_t number) const
    {
        return number % static_cast<std::size_t>(of) == static_cast<std::size_t>(part) - 1;
    }
};

constexpr int mostParts = 10000;

/// Parses "2/8". Throws Failure (ErrorKind::usage) saying what to give.
[[nodiscard]] Shard parseShard(const std::string& typed);

/// Options of a command that can be split into parts.
struct PartOptions {
    std::string shard;       ///< Text "2/8"; empty: the whole job.
    bool fromParts = false;  ///< Takes the results of the parts in place of computing them. Used by `merge`.
};
void addPartOptions(CLI::App&, PartOptions&);

/// Arguments of this process, without the program's name. Set by `main`.
[[nodiscard]] std::vector<std::string>& commandLine();
/// Returns the arguments without --shard, which all parts of a job share.
[[nodiscard]] std::vector<std::string> commandOfAllParts();
/// Formats a command line for a shell, with quotes where they are needed.
[[nodiscard]] std::string shellText(const std::vector<std::string>& words);

}  // namespace vitrine::app
