// One writer: whatever the program writes for people or for itself is written beside its target and takes its place in
// one step (render/files/atomic_write.h). Qt's settings files, which Qt writes so by itself, are not looked at.

#include "tests/source/source_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

namespace vitrine {
namespace {

/// Files that open one for writing by themselves, and why.
const std::map<std::string, std::string> writers{
    {"render/files/atomic_write.cpp", "it is the writer"},
    {"render/files/scratch_file.cpp", "working data without a name"},
    {"render/image/png_rows.cpp", "rows of a part file, which PictureStream publishes"},
    {"render/video/video_file.cpp", "frames of a part file, which it publishes"},
};

/// The first way past the writer that a text takes; empty: none.
std::string otherWriter(const std::string& text)
{
    static const std::regex ways(
        R"re(\bofstream\b|\bfopen\b|\bQSaveFile\b|\bcopy_file\b|\bO_CREAT\b|\bO_WRONLY\b|\bmkostemp\b|)re"
        R"re(QIODevice::(WriteOnly|ReadWrite|Append)|\.save\([^&)][^)]*, *"(PNG|JPG)")re");
    // The pattern takes seconds: texts that hold none of its words are not asked.
    const auto holds = [&](const char* word) { return text.find(word) != std::string::npos; };
    static constexpr auto words = {"ofstream", "fopen",    "QSaveFile", "copy_file", "O_CREAT",
                                   "O_WRONLY", "mkostemp", "QIODevice", ".save("};
    if (std::none_of(words.begin(), words.end(), holds)) return {};
    std::smatch found;
    return std::regex_search(text, found, ways) ? found.str() : std::string();
}

TEST(Writers, ThereIsOne)
{
    for (const char* folder : {"app", "ui", "exhibits", "render"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions)) {
            if (writers.contains(file)) continue;
            EXPECT_EQ(otherWriter(test::withoutComments(test::sourceText(file))), "")
                << file << ": use render::atomicWrite";
        }
}

TEST(WritersControl, OthersAreSeen)
{
    for (const char* text :
         {"std::ofstream stream(path);", "QSaveFile file(path);", "fs::copy_file(a, b);",
          "open(path, O_WRONLY | O_TRUNC);", "picture.save(path, \"PNG\");", "file.open(QIODevice::WriteOnly)"})
        EXPECT_NE(otherWriter(text), "") << text;
    for (const char* text : {"std::ifstream stream(path);", "picture.save(&buffer, \"PNG\");", "store_.save(next)"})
        EXPECT_EQ(otherWriter(text), "") << text;
    for (const auto& [file, why] : writers) EXPECT_NE(otherWriter(test::sourceText(file)), "") << file << ": " << why;
}

/// Where a text gives Qt a settings file that may be a pipe, on which reading waits for good; empty: nowhere.
std::string uncheckedIni(const std::string& text)
{
    constexpr std::string_view format = ", QSettings::IniFormat";
    for (std::size_t at = text.find(format); at != std::string::npos; at = text.find(format, at + 1)) {
        const std::size_t line = text.rfind('\n', at) + 1;
        const std::string before = text.substr(line, at - line);
        if (before.find("iniPath(") == std::string::npos) return before;
    }
    return {};
}

TEST(Readers, AskWhatASettingsFileIsBeforeQtOpensIt)
{
    for (const char* folder : {"app", "ui"})
        for (const std::string& file : test::sourceFiles(folder, test::cppExtensions))
            EXPECT_EQ(uncheckedIni(test::withoutComments(test::sourceText(file))), "") << file << ": use iniPath";
    EXPECT_NE(uncheckedIni("QSettings kept(path, QSettings::IniFormat);"), "");
    EXPECT_EQ(uncheckedIni("QSettings kept(iniPath(path), QSettings::IniFormat);"), "");
}

}  // namespace
}  // namespace vitrine
