#include "app/kit/command.h"
#include "app/queue/parts.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>

namespace vitrine::app {

void addMergeCommand(CLI::App& parser, Action& chosen, const std::function<int(const std::vector<std::string>&)>& run)
{
    CLI::App* command = parser.add_subcommand("merge", "Join the parts that --shard made");
    auto out = std::make_shared<std::string>();
    command->add_option("out", *out, "Output file or folder that --out named when the parts were made")->required();
    command->callback([&chosen, out, run] {
        chosen = [out, run] {
            std::vector<std::string> words = Parts::commandFor(*out);
            words.emplace_back("--from-parts");  // This option checks all parts before anything is written.
            const int code = run(words);
            if (code == 0) std::printf("The parts in %s.parts are not needed any more.\n", out->c_str());
            return code;
        };
    });
}

}  // namespace vitrine::app
