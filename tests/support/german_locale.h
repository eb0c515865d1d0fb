#pragma once

#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"

#include <clocale>
#include <cstdlib>
#include <optional>
#include <string>

namespace vitrine::test {

/// Sets a German locale, whose decimal mark is a comma, until it is destroyed. Compiles one if none is installed.
class GermanLocale {
public:
    GermanLocale()
    {
        if (set()) return;
        const std::string command =
            "localedef -i de_DE -f UTF-8 " + (folder_ / "de_DE.UTF-8").string() + " >/dev/null 2>&1";
        if (std::system(command.c_str()) != 0) return;
        place_.emplace("LOCPATH", folder_.path().string());
        set();
    }
    ~GermanLocale() { std::setlocale(LC_ALL, "C"); }
    GermanLocale(const GermanLocale&) = delete;
    GermanLocale& operator=(const GermanLocale&) = delete;

    [[nodiscard]] bool active() const { return active_; }

private:
    bool set() { return active_ = std::setlocale(LC_ALL, "de_DE.UTF-8") && *std::localeconv()->decimal_point == ','; }

    TemporaryFolder folder_;
    std::optional<EnvironmentVariable> place_;
    bool active_ = false;
};

}  // namespace vitrine::test
