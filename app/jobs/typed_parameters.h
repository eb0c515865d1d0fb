#pragma once

#include "exhibits/jobs/kit/given_values.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Options of a command for the parameters of a table, and what was typed for them.
class TypedParameters {
public:
    using Wanted = std::function<bool(const ParameterInfo&)>;

    /// Adds an option for each parameter, or for those that are `wanted`. Must outlive the command.
    void addTo(CLI::App&, const Parameters&, const Wanted& wanted = {});
    /// Takes what was typed, option by option, so that a message names the first one that is wrong. Throws Failure
    /// (Blame::usage).
    void read(const CLI::App&, jobs::GivenValues&) const;

private:
    std::vector<std::vector<std::string>> words_;  ///< By option of the table.
};

}  // namespace vitrine::app
