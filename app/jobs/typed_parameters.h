#pragma once

#include "exhibits/jobs/kit/given_values.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vitrine::app {

/// Options of a command for the parameters of a table, and the words typed for them.
class TypedParameters {
public:
    /// Adds an option for each parameter. This object must outlive the command.
    void addTo(CLI::App&, const Parameters&);
    /// Passes the typed words on, option by option in the order of the table, so that a message names the first wrong
    /// one. Throws Failure (ErrorKind::usage).
    void read(const CLI::App&, jobs::GivenValues&) const;

private:
    std::vector<std::vector<std::string>> words_;  ///< By option of the table.
};

}  // namespace vitrine::app
