#include "exhibits/printing/print_marks.h"

#include "exhibits/printing/print_preview.h"
#include "tests/exhibits/printing/set_up_print.h"
#include "tests/support/failures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vitrine::printing {
namespace {

/// A print of 120 mm x 80 mm at 254 dots per inch, so that a millimeter is 10 dots, with a bleed of 2 mm and a border
/// of 8 mm.
class PrintMarksTest : public test::SetUpPrint {
protected:
    void SetUp() override
    {
        SetUpPrint::SetUp();
        values_.set(table_.width, 0.12);
        values_.set(table_.height, 0.08);
        values_.set(table_.bleed, 0.002);
        values_.set(table_.border, 0.008);
        values_.set(table_.dotsPerInch, 254.0);
        values_.set(table_.lensesPerInch, 25.4);
    }
    [[nodiscard]] CodedPicture raster() const
    {
        const auto preview = printPreview(values_, solid(12));
        return preview->raster({0, 0, preview->width(), preview->height()});
    }
    [[nodiscard]] static std::array<int, 3> at(const CodedPicture& picture, int x, int y)
    {
        const std::size_t i =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
        return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
    }
};

constexpr std::array<int, 3> black{0, 0, 0}, white{255, 255, 255};
constexpr int border = 80, bleed = 20, width = 1400, height = 1000;  // Dots.

TEST_F(PrintMarksTest, LieInTheBorderOnly)
{
    const CodedPicture plain = raster();
    ASSERT_EQ(plain.width, width);
    ASSERT_EQ(plain.height, height);
    for (const auto& mark : {table_.cropMarks, table_.registrationMarks, table_.colorBar, table_.pitchStrip})
        values_.set(mark, true);
    const CodedPicture marked = raster();
    int changed = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (at(plain, x, y) == at(marked, x, y)) continue;
            ++changed;
            ASSERT_TRUE(x < border || y < border || x >= width - border || y >= height - border) << x << ' ' << y;
        }
    EXPECT_GT(changed, 1000);
}

TEST_F(PrintMarksTest, CropMarksPointAtTheTrim)
{
    values_.set(table_.cropMarks, true);
    const CodedPicture picture = raster();
    const int trim = border + bleed;
    // A line of one dot lies around the edge of the trim; it ends a millimeter before the bleed.
    for (const int y : {border - 11, border - 40, height - border + 11}) {
        EXPECT_TRUE(at(picture, trim - 1, y) == black || at(picture, trim, y) == black) << y;
        EXPECT_TRUE(at(picture, width - trim - 1, y) == black || at(picture, width - trim, y) == black) << y;
    }
    for (const int x : {border - 11, width - border + 11})
        EXPECT_TRUE(at(picture, x, trim - 1) == black || at(picture, x, trim) == black) << x;
    EXPECT_EQ(at(picture, trim, border - 5), white);
    EXPECT_EQ(at(picture, width / 2, 20), white);
}

TEST_F(PrintMarksTest, TheBarHasTheInksAndThePitchStripThePitch)
{
    values_.set(table_.colorBar, true);
    values_.set(table_.pitchStrip, true);
    const CodedPicture picture = raster();
    const int y = height - border / 2, from = border + bleed + 10;
    const std::array<std::array<int, 3>, 4> inks{{{0, 255, 255}, {255, 0, 255}, {255, 255, 0}, {0, 0, 0}}};
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(at(picture, from + 40 * i + 20, y), inks.at(static_cast<std::size_t>(i))) << i;
    // Ten dots for each lens: half of them black, with the lens's axis in the middle.
    int blacks = 0;
    for (int x = from; x < from + 400; ++x) blacks += at(picture, x, border / 2) == black ? 1 : 0;
    EXPECT_NEAR(blacks, 200, 12);
    const PrintLayout layout(printSettings(values_, 12));
    for (int x = from; x < from + 400; ++x) {
        const double lens = layout.lensAt(x + 0.5, 0), off = std::abs(lens - std::floor(lens) - 0.5);
        if (off < 0.2) {
            EXPECT_EQ(at(picture, x, border / 2), black) << x;
        }
        if (off > 0.3) {
            EXPECT_EQ(at(picture, x, border / 2), white) << x;
        }
    }
}

TEST_F(PrintMarksTest, AreTheSameInPartsAndInSixteenBits)
{
    for (const auto& mark : {table_.cropMarks, table_.registrationMarks, table_.colorBar, table_.pitchStrip})
        values_.set(mark, true);
    const PrintMarks marks{PrintLayout(printSettings(values_, 12))};
    const std::size_t samples = std::size_t{3} * width * height;
    std::vector<std::uint8_t> whole(samples, 200), parts(samples, 200);
    std::vector<std::uint16_t> deep(samples, 200 * 257);
    marks.draw({0, 0, width, height}, whole.data());
    for (int y = 0; y < height; y += 37)
        marks.draw({0, y, width, std::min(y + 37, height)},
                   parts.data() + std::size_t{3} * width * static_cast<std::size_t>(y));
    marks.draw({0, 0, width, height}, deep.data());
    EXPECT_EQ(whole, parts);
    for (std::size_t i = 0; i < samples; ++i) ASSERT_NEAR(deep[i] / 257.0, whole[i], 0.6) << i;
}

TEST_F(PrintMarksTest, AreRefusedWhereTheyDoNotFit)
{
    values_.set(table_.cropMarks, true);
    values_.set(table_.border, 0.004);
    EXPECT_NE(printPlan(values_, nullptr, "a.tif").refusal.find("a border of at least 5 mm"), std::string::npos);
    values_.set(table_.border, 0.005);
    EXPECT_EQ(printPlan(values_, nullptr, "a.tif").refusal, "");
    values_.set(table_.colorBar, true);
    values_.set(table_.width, 0.03);
    EXPECT_NE(printPlan(values_, nullptr, "a.tif").refusal.find("too narrow for a bar of colors"), std::string::npos);
    EXPECT_EQ(printPlan(chartValues(values_), nullptr, "a.tif").refusal.find("marks"), std::string::npos);
}

}  // namespace
}  // namespace vitrine::printing
