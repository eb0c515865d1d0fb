#include "app/kit/say.h"

#include "render/failure.h"
#include "ui/kit/language.h"

#include <unistd.h>

#include <exception>
#include <string>

namespace vitrine::app {
namespace {

/// Writes as much of the text as standard error accepts. Allocates nothing.
void put(std::string_view text) noexcept
{
    while (!text.empty()) {
        const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

}  // namespace

void say(std::string_view sentence) noexcept
{
    try {
        put("vitrine: " + ui::translatedInLocale(sentence) + '\n');
    } catch (const std::exception&) {
        sayInEnglish(sentence);
    }
}

void say(const Failure& failure) noexcept
{
    try {
        put("vitrine: " + ui::translatedInLocale(failure.message()) + '\n');
    } catch (const std::exception&) {
        sayInEnglish(failure.what());
    }
}

void sayInEnglish(std::string_view sentence) noexcept
{
    put("vitrine: ");
    put(sentence);
    put("\n");
}

}  // namespace vitrine::app
