#include "exhibits/printing/print_description.h"

#include "render/failure.h"
#include "render/image/picture_stream.h"

#include <optional>
#include <utility>

namespace vitrine::printing {

namespace fs = std::filesystem;

namespace {

/// Returns the description that was written with the pixels. Nothing if there is none, or if it is unreadable but
/// another one may be used.
std::optional<render::JsonDocument> insideOf(const fs::path& print, bool anotherMayDo)
{
    try {
        if (const auto text = render::embeddedPrint(print)) return render::parseJson(*text, print.string());
    } catch (const Failure&) {
        if (!anotherMayDo) throw;
    }
    return std::nullopt;
}

bool saysTheSame(const std::string& file, const render::JsonDocument& inside)
{
    try {
        return render::readJson(file).root() == inside.root();
    } catch (const Failure&) {
        return false;
    }
}

}  // namespace

PrintDescription printDescription(const fs::path& print)
{
    std::error_code error;
    const std::string beside = print.string() + ".json";
    const bool hasBeside = fs::exists(beside, error);
    std::optional<render::JsonDocument> inside = insideOf(print, hasBeside);
    if (inside && (!hasBeside || saysTheSame(beside, *inside))) return {std::move(*inside), {}};
    if (inside)
        return {std::move(*inside), beside + " does not describe " + print.string() +
                                        ": it is of another print, or was changed. The description inside the print "
                                        "was used; make the print anew, or remove " +
                                        beside + "."};
    if (hasBeside) return {render::readJson(beside), {}};
    throw Failure(ErrorKind::file, "Cannot look at " + print.string() +
                                       ": it carries no description of its sheet, and there is no " + beside +
                                       " beside it; choose a file that vitrine print wrote.");
}

}  // namespace vitrine::printing
