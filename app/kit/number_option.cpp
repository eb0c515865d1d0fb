#include "app/kit/number_option.h"

#include "render/failure.h"
#include "render/text/joined.h"
#include "render/text/nearest_word.h"

#include <algorithm>

namespace vitrine::app {

CLI::Option* addChoice(CLI::App& command, const std::string& name, std::string& value,
                       const std::vector<std::string>& names, const std::string& help)
{
    CLI::Option* option = command.add_option_function<std::string>(
        name,
        [&value, name, names](const std::string& typed) {
            if (std::find(names.begin(), names.end(), typed) == names.end())
                throw Failure(ErrorKind::usage, noSuchChoice(name, typed, names));
            value = typed;
        },
        help);
    return option->default_function([&value] { return value; })->type_name(joined(names, "|"));
}

}  // namespace vitrine::app
