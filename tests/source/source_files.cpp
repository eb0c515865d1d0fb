#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace vitrine::test {

namespace fs = std::filesystem;

std::vector<std::string> sourceFiles(const std::string& folder, const std::vector<std::string>& extensions)
{
    std::vector<std::string> files;
    const fs::path root(VITRINE_SOURCE_DIR);
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() && std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
            files.push_back(entry.path().lexically_relative(root).generic_string());
    }
    EXPECT_FALSE(files.empty()) << "no source in " << folder;
    std::sort(files.begin(), files.end());
    return files;
}

std::string sourceText(const std::string& file)
{
    std::ifstream stream(fs::path(VITRINE_SOURCE_DIR) / file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string withoutComments(std::string text)
{
    bool inLine = false;
    bool inBlock = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool pair = i + 1 < text.size();
        if (!inLine && !inBlock && pair && text[i] == '/' && text[i + 1] == '/') inLine = true;
        if (!inLine && !inBlock && pair && text[i] == '/' && text[i + 1] == '*') inBlock = true;
        if (text[i] == '\n') {
            inLine = false;
            continue;
        }
        if (inBlock && pair && text[i] == '*' && text[i + 1] == '/') {
            inBlock = false;
            text[i] = text[i + 1] = ' ';
            continue;
        }
        if (inLine || inBlock) text[i] = ' ';
    }
    return text;
}

std::vector<std::string> lines(const std::string& text)
{
    std::vector<std::string> result;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) result.push_back(line);
    return result;
}

std::vector<Include> includesOf(const std::string& file)
{
    static const std::regex pattern(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
    std::vector<Include> found;
    const std::vector<std::string> text = lines(sourceText(file));
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::smatch match;
        if (std::regex_search(text[i], match, pattern)) found.push_back({file, static_cast<int>(i) + 1, match[1]});
    }
    return found;
}

}  // namespace vitrine::test
