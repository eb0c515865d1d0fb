#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// One share of work that a queue runs in parts: part `part` of `of`, both from 1.
struct Shard {
    int part = 1, of = 1;

    /// Whether item `number` (from 0) belongs to it: every `of`th one does.
    [[nodiscard]] bool makes(std::size_t number) const
    {
        return number % static_cast<std::size_t>(of) == static_cast<std::size_t>(part) - 1;
    }
};

constexpr int mostParts = 10000;

/// Of "2/8". Throws Failure (Blame::usage) saying what to give.
[[nodiscard]] Shard parseShard(const std::string& typed);

/// What a command that can be split into parts was told about it.
struct PartOptions {
    std::string shard;       ///< "2/8"; empty: all of it.
    bool fromParts = false;  ///< What the parts made is taken in place of being made: by `merge`.
};
void addPartOptions(CLI::App&, PartOptions&);

/// The words of this process's command line behind the program's name. `main` sets them.
[[nodiscard]] std::vector<std::string>& commandLine();
/// The same without --shard: what all parts of a job have in common.
[[nodiscard]] std::vector<std::string> commandOfAllParts();
/// As one types it, words quoted where a shell needs it.
[[nodiscard]] std::string shellText(const std::vector<std::string>& words);

}  // namespace vitrine::app
