// Every build reads the corpora of the fuzzers, which contain all inputs that once crashed the program.

#include "tests/fuzz/readers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace vitrine::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path corpora = fs::path(VITRINE_SOURCE_DIR) / "tests/fuzz/corpus";

/// Bytes of the files of a corpus, by name.
std::map<std::string, std::string> filesOf(const Reader& reader)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(corpora / reader.corpus)) {
        std::ifstream file(entry.path(), std::ios::binary);
        files[entry.path().filename().string()].assign(std::istreambuf_iterator<char>(file), {});
    }
    return files;
}

TEST(FuzzCorpora, BelongToOneReaderEach)
{
    std::set<std::string> folders, readersNamed;
    for (const auto& entry : fs::directory_iterator(corpora)) folders.insert(entry.path().filename().string());
    for (const Reader& reader : readers()) readersNamed.emplace(reader.corpus);
    EXPECT_EQ(folders, readersNamed);
}

class FuzzCorpus : public testing::TestWithParam<Reader> {};

TEST_P(FuzzCorpus, IsReadOrRefusedAndNothingElse)
{
    const auto files = filesOf(GetParam());
    int accepted = 0;
    for (const auto& [name, bytes] : files) {
        SCOPED_TRACE(name);
        accepted += GetParam().read(bytes);
    }
    // A corpus without accepted inputs would not help the fuzzer.
    EXPECT_GE(accepted, 2);
    EXPECT_GE(files.size(), 5U);
}

/// Some parsers end the text at a zero byte, and would ignore the rest.
TEST_P(FuzzCorpus, WithAZeroByteIsRefusedWhereItIsText)
{
    if (!GetParam().isText) return;
    for (const auto& [name, bytes] : filesOf(GetParam())) {
        if (bytes.size() > 4096 || !GetParam().read(bytes)) continue;
        SCOPED_TRACE(name);
        for (const char* behind : {"", "]", " garbage"})
            EXPECT_FALSE(GetParam().read(bytes + std::string(1, '\0') + behind));
        for (std::size_t at = 0; at <= bytes.size(); at += std::max<std::size_t>(bytes.size() / 16, 1)) {
            std::string with = bytes;
            with.insert(at, 1, '\0');
            EXPECT_FALSE(GetParam().read(with)) << "zero byte at " << at;
        }
    }
}

/// Damage of one to four kinds, as by disks, editors and attackers.
class Damage {
public:
    explicit Damage(const std::map<std::string, std::string>& files) : random_(1)
    {
        for (const auto& [name, bytes] : files) originals_.push_back(bytes);
    }

    [[nodiscard]] std::string next()
    {
        std::string bytes = originals_[pick(originals_.size())];
        for (std::size_t n = 1 + pick(4); n > 0; --n) damage(bytes);
        return bytes;
    }

private:
    std::size_t pick(std::size_t count) { return count > 0 ? random_() % count : 0; }
    void damage(std::string& bytes)
    {
        static const std::vector<std::string> words{
            "0",   "-1",   "1e999",   "1e308",    "-1e-320",  "4294967296", "9223372036854775808",
            "0.5", "nan",  "null",    "true",     "[]",       "{}",         "[[",
            "{\"", "\"\"", "\\u0000", "\xff\xfe", "\xc0\x80", "..",         "/",
            "```", "\n# ", "[row:",   ":",        "=",        ",",          "}",
            "]",   "\""};
        const std::size_t at = pick(bytes.size() + 1);
        const std::size_t length = std::min(bytes.size() - at, pick(pick(8) == 0 ? 4096 : 16));
        switch (pick(8)) {
        case 0: bytes.resize(at); break;
        case 1: bytes.erase(at, length); break;
        case 2: bytes.insert(at, bytes.substr(pick(bytes.size() + 1), length)); break;
        case 3: bytes.insert(at, words[pick(words.size())]); break;
        case 4: replaceNumber(bytes, at, words[pick(12)]); break;
        case 5: {
            const std::string& other = originals_[pick(originals_.size())];
            bytes.replace(at, length, other.substr(pick(other.size() + 1), 1 + pick(64)));
            break;
        }
        default:
            if (at < bytes.size()) bytes[at] = pick(2) == 0 ? static_cast<char>(random_()) : "\0\xff\x7f\x80"[pick(4)];
        }
    }
    static void replaceNumber(std::string& bytes, std::size_t at, const std::string& number)
    {
        const std::size_t first = bytes.find_first_of("0123456789", at);
        if (first == std::string::npos) return;
        bytes.replace(first, std::min(bytes.find_first_not_of("0123456789.eE+-", first), bytes.size()) - first, number);
    }

    std::mt19937 random_;
    std::vector<std::string> originals_;
};

/// Random damage, without the fuzzers' feedback, in every build. VITRINE_FUZZ_SECONDS sets its duration.
/// VITRINE_FUZZ_LAST names a file that contains the present input.
TEST_P(FuzzCorpus, IsReadOrRefusedWhenItIsDamaged)
{
    using std::chrono::steady_clock;
    const char* seconds = std::getenv("VITRINE_FUZZ_SECONDS");
    const char* last = std::getenv("VITRINE_FUZZ_LAST");
    const auto end = steady_clock::now() + std::chrono::seconds(seconds ? std::atoi(seconds) : 0);
    Damage damage(filesOf(GetParam()));
    std::size_t read = 0, accepted = 0;
    for (; read < 300 || steady_clock::now() < end; ++read) {
        const std::string bytes = damage.next();
        if (last) std::ofstream(last, std::ios::binary) << bytes;
        accepted += GetParam().read(bytes) ? 1U : 0U;
    }
    EXPECT_GT(accepted, 0U) << "damage that is always refused tries only the first check";
    RecordProperty("inputs", static_cast<int>(read));
    if (seconds) std::printf("%s: %zu inputs, %zu accepted\n", std::string(GetParam().corpus).c_str(), read, accepted);
}

INSTANTIATE_TEST_SUITE_P(Readers, FuzzCorpus, testing::ValuesIn(readers().begin(), readers().end()),
                         [](const auto& p) { return std::string(p.param.corpus); });

}  // namespace
}  // namespace vitrine::fuzz
