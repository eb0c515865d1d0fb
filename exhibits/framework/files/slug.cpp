#include "exhibits/framework/files/slug.h"

#include <QString>

namespace vitrine {

std::string slugFor(std::string_view name)
{
    constexpr std::size_t longest = 64;
    // Decomposed, "é" is "e" and a combining mark, which is dropped below.
    const QString decomposed =
        QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())).normalized(QString::NormalizationForm_KD);
    std::string slug;
    for (const QChar c : decomposed.toLower()) {
        const char16_t unit = c.unicode();
        const bool plain = (unit >= u'a' && unit <= u'z') || (unit >= u'0' && unit <= u'9');
        if (plain)
            slug += static_cast<char>(unit);
        else if (!c.isMark() && !slug.empty() && slug.back() != '-')
            slug += '-';
        if (slug.size() == longest) break;
    }
    while (!slug.empty() && slug.back() == '-') slug.pop_back();
    return slug.empty() ? "preset" : slug;
}

std::filesystem::path freePath(const std::filesystem::path& folder, const std::string& slug)
{
    std::error_code error;
    std::filesystem::path path = folder / (slug + ".json");
    for (int n = 2; std::filesystem::exists(std::filesystem::symlink_status(path, error)); ++n) {
        std::string name = slug;
        (name += '-') += std::to_string(n);
        path = folder / (name += ".json");
    }
    return path;
}

}  // namespace vitrine
