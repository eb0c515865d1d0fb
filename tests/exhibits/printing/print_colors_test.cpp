// Profiles of prints: sRGB in each, conversion into that of a printer, and its proof.
#include "exhibits/printing/print_preview.h"
#include "render/image/picture_rows.h"
#include "render/image/rec709.h"
#include "tests/exhibits/printing/set_up_print.h"
#include "tests/support/failures.h"
#include "tests/support/ink_profile.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace vitrine::printing {
namespace {

class PrintColorsTest : public test::SetUpPrint {
protected:
    /// Returns views of colored and gray areas.
    [[nodiscard]] static std::shared_ptr<const PrintViews> colored()
    {
        const auto views = std::make_shared<PrintViews>();
        for (int k = 0; k < 12; ++k) {
            render::Image image(24, 16, 3);
            for (int y = 0; y < 16; ++y)
                for (int x = 0; x < 24; ++x)
                    for (int c = 0; c < 3; ++c)
                        image.at(x, y, c) = static_cast<float>((x / 6 + c * (y / 4)) % 4) / 4 + 0.1F;
            views->add(image);
        }
        return views;
    }
    [[nodiscard]] std::vector<std::uint16_t> codesOf(const std::filesystem::path& print) const
    {
        render::PictureRows rows(print);
        std::vector<std::uint16_t> codes(static_cast<std::size_t>(rows.width() * rows.height()) * 3);
        rows.read(0, rows.height(), codes.data());
        return codes;
    }
    void setInks()
    {
        const std::filesystem::path profile = folder_ / "inks.icc";
        std::ofstream(profile, std::ios::binary) << vitrine::test::InkProfile::bytes();
        values_.set(table_.outputProfile, profile.string());
    }
};

TEST_F(PrintColorsTest, EveryPrintCarriesTheSameSrgbProfile)
{
    values_.set(table_.width, 0.05);
    values_.set(table_.height, 0.05);
    for (const char* name : {"a.png", "a.tif"}) {
        exportPrint(values_, colored().get(), folder_ / name);
        const std::string profile = render::embeddedProfile(folder_ / name);
        EXPECT_EQ(profile, render::srgbProfile()) << name;
        EXPECT_TRUE(render::isSrgbProfile(profile)) << name;
        exportPrint(chartValues(values_), nullptr, folder_ / name);
        EXPECT_EQ(render::embeddedProfile(folder_ / name), profile) << name << " as a chart";
    }
}

TEST_F(PrintColorsTest, InksAreStoredAsInksAndLookLikeTheViews)
{
    const auto views = colored();
    exportPrint(values_, views.get(), folder_ / "rgb.tif");
    setInks();
    exportPrint(values_, views.get(), folder_ / "inks.tif");
    std::unique_ptr<render::OiioRowReader> file;
    ASSERT_EQ(render::oiioCodec().openRowReader((folder_ / "inks.tif").string(), file), "");
    EXPECT_TRUE(file->isInks);
    EXPECT_EQ(file->channels, 4);
    const std::vector<std::uint16_t> rgb = codesOf(folder_ / "rgb.tif"), inks = codesOf(folder_ / "inks.tif");
    ASSERT_EQ(rgb.size(), inks.size());
    int farthest = 0;
    for (std::size_t i = 0; i < rgb.size(); ++i) farthest = std::max(farthest, std::abs(rgb[i] - inks[i]));
    // The tables of the profile are interpolated between their points.
    EXPECT_LT(farthest / 257.0, 6);
    EXPECT_GT(farthest, 0) << "nothing was converted";
    values_.set(table_.bits, PrintBits::sixteen);
    EXPECT_NE(printPlan(values_, nullptr, "a.tif").refusal.find("8 bits per channel"), std::string::npos);
    EXPECT_EQ(printPlan(values_, nullptr, "a.pdf").refusal, "");
}

TEST_F(PrintColorsTest, ThePreviewProvesTheColorsOfThePrinter)
{
    const auto views = colored();
    setInks();
    exportPrint(values_, views.get(), folder_ / "inks.tif");
    const std::vector<std::uint16_t> file = codesOf(folder_ / "inks.tif");
    const auto preview = printPreview(values_, views);
    const CodedPicture shown = preview->raster({0, 0, preview->width(), preview->height()});
    ASSERT_EQ(shown.rgb.size(), file.size());
    int farthest = 0;
    for (std::size_t i = 0; i < file.size(); ++i) farthest = std::max(farthest, std::abs(shown.rgb[i] - file[i] / 257));
    EXPECT_LE(farthest, 1);
}

TEST_F(PrintColorsTest, SaysWhatIsWrongWithAProfile)
{
    setInks();
    EXPECT_NE(printPlan(values_, nullptr, "a.png").refusal.find("a PNG cannot hold inks"), std::string::npos);
    EXPECT_EQ(printPlan(values_, nullptr, "a.pdf").refusal, "");
    EXPECT_EQ(printPlan(values_, nullptr, "a.tif").bytes / 4 * 3, [&] {
        ParameterValues rgb = values_;
        rgb.set(table_.outputProfile, std::string());
        return printPlan(rgb, nullptr, "a.tif").bytes;
    }());
    values_.set(table_.outputProfile, (folder_ / "none.icc").string());
    EXPECT_NE(printPlan(values_, nullptr, "a.tif").refusal.find("none.icc"), std::string::npos);
    std::ofstream(folder_ / "none.icc") << "no profile";
    EXPECT_NE(printPlan(values_, nullptr, "a.tif").refusal.find("none.icc: this is no ICC profile"), std::string::npos);
}

TEST_F(PrintColorsTest, APdfHasTheSameBytesEachTime)
{
    const auto views = colored();
    const auto bytes = [&] {
        exportPrint(values_, views.get(), folder_ / "a.pdf");
        return vitrine::test::bytesOf(folder_ / "a.pdf");
    };
    const std::string first = bytes();
    EXPECT_TRUE(first.starts_with("%PDF-1.6"));
    EXPECT_EQ(bytes(), first);
    EXPECT_EQ(folder_.files(), (std::vector<std::string>{"a.pdf", "a.pdf.json"}));
}

}  // namespace
}  // namespace vitrine::printing
