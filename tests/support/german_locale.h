#pragma once

#include "tests/support/environment_variable.h"
#include "tests/support/temporary_folder.h"

#include <clocale>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

namespace vitrine::test {

/// Sets a German locale, whose decimal mark is a comma, until it is destroyed. Compiles one if none is installed.
class GermanLocale {
public:
    GermanLocale()
    {
        if (set()) return;
        // Compiling the characters and the order of letters, too, would take four times as long.
        const std::filesystem::path source = folder_ / "source";
        std::ofstream(source) << R"(LC_CTYPE
copy "POSIX"
END LC_CTYPE
LC_COLLATE
copy "POSIX"
END LC_COLLATE
LC_MONETARY
copy "de_DE"
END LC_MONETARY
LC_NUMERIC
copy "de_DE"
END LC_NUMERIC
LC_TIME
copy "de_DE"
END LC_TIME
LC_MESSAGES
copy "de_DE"
END LC_MESSAGES
)";
        // It warns of the categories that are left out; -c lets it write those that are there.
        const std::string command = "localedef -c -i " + source.string() + " -f UTF-8 " +
                                    (folder_ / "de_DE.UTF-8").string() + " >/dev/null 2>&1";
        static_cast<void>(std::system(command.c_str()));
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
