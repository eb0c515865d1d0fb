#include "app/say.h"

#include "ui/kit/language.h"

#include <cstdio>

namespace vitrine::app {

void say(const std::string& sentence)
{
    std::fprintf(stderr, "vitrine: %s\n", ui::saidInLocale(sentence).c_str());
}

}  // namespace vitrine::app
