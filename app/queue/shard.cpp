#include "app/queue/shard.h"

#include "render/failure.h"
#include "render/files/shell_word.h"
#include "render/text/joined.h"

#include <CLI/CLI.hpp>

namespace vitrine::app {
namespace {

/// Parses a whole number of at most five digits; 0 for other texts.
int countOf(const std::string& text)
{
    if (text.empty() || text.size() > 5 || text.find_first_not_of("0123456789") != std::string::npos) return 0;
    return std::stoi(text);
}

}  // namespace

Shard parseShard(const std::string& typed)
{
    const std::size_t slash = typed.find('/');
    const Shard shard{countOf(typed.substr(0, slash)),
                      slash == std::string::npos ? 0 : countOf(typed.substr(slash + 1))};
    if (shard.part < 1 || shard.of < shard.part || shard.of > mostParts)
        throw Failure(ErrorKind::usage, "--shard " + typed + ": give the part and how many there are, from 1/1 to " +
                                            std::to_string(mostParts) + "/" + std::to_string(mostParts) +
                                            ", such as --shard 2/8.");
    return shard;
}

void addPartOptions(CLI::App& command, PartOptions& options)
{
    command.add_option(
        "--shard", options.shard,
        "Part to make, as K/N such as 2/8. It is written into OUT.parts; `vitrine merge OUT` joins all parts");
    command.add_flag("--from-parts", options.fromParts)->group("");
}

std::vector<std::string>& commandLine()
{
    static std::vector<std::string> words;
    return words;
}

std::vector<std::string> commandOfAllParts()
{
    std::vector<std::string> words;
    for (std::size_t i = 0; i < commandLine().size(); ++i) {
        const std::string& word = commandLine()[i];
        if (word == "--shard")
            ++i;
        else if (word.rfind("--shard=", 0) != 0)
            words.push_back(word);
    }
    return words;
}

std::string shellText(const std::vector<std::string>& words)
{
    return joined(words, " ", render::shellWord);
}

}  // namespace vitrine::app
