#include "render/files/number_text.h"
#include "render/files/strict_json.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace {

using namespace vitrine::render;

TEST(JsonNumbers, AreTheShortestThatReadBack)
{
    EXPECT_EQ(shortestNumber(0.1), "0.1");
    EXPECT_EQ(shortestNumber(1e20), "1e+20");
    EXPECT_EQ(shortestNumber(-0.0), "-0");
    EXPECT_EQ(parseNumber("0.1"), 0.1);
    EXPECT_EQ(parseNumber("0,1"), std::nullopt);
    EXPECT_EQ(parseNumber("1 "), std::nullopt);
    EXPECT_EQ(parseNumber("inf"), std::nullopt);
    EXPECT_EQ(parseNumber("1e999"), std::nullopt);
}

// A million random bit patterns, also through the file format: writer and strict reader.
TEST(LongJsonNumbers, ReadBackBitForBit)
{
    std::mt19937_64 random(2);
    std::vector<double> numbers = {0.0,
                                   -0.0,
                                   5e-324,
                                   2.2250738585072014e-308,
                                   1.7976931348623157e308,
                                   9007199254740993.0,
                                   1e22,
                                   123456789012345680000.0};
    while (numbers.size() < 1'000'000) {
        const double x = std::bit_cast<double>(random());
        if (std::isfinite(x)) numbers.push_back(x);
    }
    Json json = Json::array();
    for (const double x : numbers) json.push_back(x);
    const JsonDocument back = parseJson(writeJson(json), "numbers.json");
    ASSERT_EQ(back.root().size(), numbers.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        different +=
            std::bit_cast<std::uint64_t>(back.root()[i].get<double>()) != std::bit_cast<std::uint64_t>(numbers[i]);
        different += std::bit_cast<std::uint64_t>(*parseNumber(shortestNumber(numbers[i]))) !=
                     std::bit_cast<std::uint64_t>(numbers[i]);
    }
    EXPECT_EQ(different, 0U);
}

}  // namespace
