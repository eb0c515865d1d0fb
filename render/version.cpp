#include "render/version.h"

namespace vitrine::render {
namespace {

std::string& version()
{
    static std::string text = VITRINE_VERSION_NUMBER;
    return text;
}

}  // namespace

void setProgramCommit(std::string_view commit)
{
    version() = VITRINE_VERSION_NUMBER;
    if (!commit.empty()) version().append("+").append(commit);
}

const std::string& programVersion()
{
    return version();
}

}  // namespace vitrine::render
