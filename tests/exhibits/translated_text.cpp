#include "tests/exhibits/translated_text.h"

#include "render/files/assets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>

namespace vitrine::test {
namespace {

/// Returns the number of bytes of the character that begins with this byte; 0 if none does.
std::size_t lengthOfCharacter(unsigned char first)
{
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

}  // namespace

std::vector<std::string> languagesUnder(const std::string& folder)
{
    std::vector<std::string> languages;
    for (const auto& entry : std::filesystem::directory_iterator(render::asset(folder)))
        if (entry.is_directory() && entry.path().filename().string().size() == 2)
            languages.push_back(entry.path().filename().string());
    std::sort(languages.begin(), languages.end());
    EXPECT_FALSE(languages.empty()) << folder;
    return languages;
}

std::vector<std::string> filesIn(const std::string& folder, const std::string& ending)
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(render::asset(folder)))
        if (entry.path().extension() == ending) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<std::string> numbersIn(const std::string& text)
{
    static const std::regex names(R"(\[row:[^\]]*\]|(src|href)="[^"]*")"), number(R"([0-9]+([.][0-9]+)?)");
    const std::string plain = std::regex_replace(text, names, "");
    std::vector<std::string> numbers(std::sregex_token_iterator(plain.begin(), plain.end(), number),
                                     std::sregex_token_iterator());
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

std::string faultOfText(const std::string& text)
{
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = lengthOfCharacter(static_cast<unsigned char>(text[at]));
        bool whole = length > 0 && at + length <= text.size();
        for (std::size_t i = 1; whole && i < length; ++i)
            whole = (static_cast<unsigned char>(text[at + i]) & 0xC0) == 0x80;
        if (!whole) return "no UTF-8 at byte " + std::to_string(at);
        at += length;
    }
    if (text.find("\xCC\x88") != std::string::npos) return "an umlaut that was taken apart";
    static const std::regex entity("&([aouAOU]uml|szlig);");
    std::smatch found;
    if (std::regex_search(text, found, entity)) return "an entity: " + found.str();
    static const std::regex umlaut("\xC3[\xA4\xB6\xBC\x9F]");
    return std::regex_search(text, umlaut) ? "" : "not one umlaut in all of it";
}

}  // namespace vitrine::test
