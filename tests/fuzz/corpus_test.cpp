// The corpus of the fuzzers, read once by every build: what once ended the program is in it and must not again.

#include "tests/fuzz/readers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Corpus {
    const char* folder;
    bool (*read)(std::string_view);
};

class FuzzCorpus : public testing::TestWithParam<Corpus> {};

TEST_P(FuzzCorpus, IsReadOrRefusedAndNothingElse)
{
    std::vector<fs::path> files;
    for (const auto& entry :
         fs::directory_iterator(fs::path(VITRINE_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().folder))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    int accepted = 0;
    for (const fs::path& path : files) {
        SCOPED_TRACE(path.filename());
        std::ifstream file(path, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        accepted += GetParam().read(bytes);
    }
    // A corpus that is all refused would lead the fuzzer nowhere.
    EXPECT_GE(accepted, 2);
    EXPECT_GE(files.size(), 5U);
}

INSTANTIATE_TEST_SUITE_P(
    Readers, FuzzCorpus,
    testing::Values(Corpus{"preset", vitrine::fuzz::readPreset}, Corpus{"exhibition", vitrine::fuzz::readExhibition},
                    Corpus{"gltf", vitrine::fuzz::readGltf}, Corpus{"image", vitrine::fuzz::readImage},
                    Corpus{"scene", vitrine::fuzz::readScene}, Corpus{"request", vitrine::fuzz::readRequest}),
    [](const auto& p) { return std::string(p.param.folder); });

}  // namespace
