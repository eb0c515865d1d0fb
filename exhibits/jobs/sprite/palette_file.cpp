#include "exhibits/jobs/sprite/palette_file.h"

#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/read_file.h"
#include "render/image/image_io.h"
#include "render/image/picture_formats.h"
#include "render/image/srgb.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <set>
#include <sstream>
#include <tuple>

namespace vitrine::jobs {
namespace {

using pixel_art::mainColors;
using pixel_art::Rgb8;

constexpr std::size_t mostColors = 256;
constexpr std::uint64_t mostBytes = 1U << 20U;

/// Lines of a palette's file, read one by one.
class PaletteLines {
public:
    explicit PaletteLines(const std::filesystem::path& file) : file_(file), text_(render::readFile(file, mostBytes)) {}

    /// Reads the next line without its end and blanks around it.
    bool next(std::string& line)
    {
        if (!std::getline(text_, line)) return false;
        ++number_;
        const std::size_t first = line.find_first_not_of(" \t\r");
        line =
            first == std::string::npos ? std::string() : line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
        return true;
    }

    [[noreturn]] void fail(const Message& wanted) const
    {
        throw Failure(
            ErrorKind::file,
            message("Cannot read {1}: line {2} is not {3}; correct it there.", file_.string(), number_, wanted),
            {file_.string(), number_});
    }

private:
    const std::filesystem::path& file_;
    std::istringstream text_;
    int number_ = 0;
};

/// Reads "255 128 0 name".
Rgb8 decimalColor(const PaletteLines& lines, const std::string& line)
{
    std::istringstream in(line);
    std::array<int, 3> codes{};
    for (int& code : codes)
        if (!(in >> code) || code < 0 || code > 255)
            lines.fail(message("three numbers from 0 to 255: red, green and blue"));
    return {codes[0], codes[1], codes[2]};
}

/// Reads "ff8000" or "#ff8000".
Rgb8 hexColor(const PaletteLines& lines, const std::string& line)
{
    const std::string digits = line.front() == '#' ? line.substr(1) : line;
    unsigned code = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
    if (digits.size() != 6 || error != std::errc() || end != digits.data() + digits.size())
        lines.fail(message("a color of six hexadecimal digits, such as ff8000"));
    return {code >> 16U, (code >> 8U) & 255U, code & 255U};
}

std::vector<Rgb8> readGimp(PaletteLines& lines)
{
    std::string line;
    if (!lines.next(line) || line != "GIMP Palette")
        lines.fail(message("\"GIMP Palette\", as the first one has to be"));
    std::vector<Rgb8> colors;
    while (lines.next(line)) {
        const bool isHeader =
            line.rfind("Name:", 0) == 0 || line.rfind("Columns:", 0) == 0 || line.rfind("Channels:", 0) == 0;
        if (line.empty() || line.front() == '#' || isHeader) continue;
        colors.push_back(decimalColor(lines, line));
    }
    return colors;
}

std::vector<Rgb8> readHex(PaletteLines& lines)
{
    std::vector<Rgb8> colors;
    for (std::string line; lines.next(line);)
        if (!line.empty()) colors.push_back(hexColor(lines, line));
    return colors;
}

std::vector<Rgb8> readJasc(PaletteLines& lines)
{
    std::string line;
    if (!lines.next(line) || line != "JASC-PAL") lines.fail(message("\"JASC-PAL\", as the first one has to be"));
    if (!lines.next(line) || line != "0100") lines.fail(message("\"0100\", the version of the format"));
    std::size_t count = 0;
    const bool hasCount = lines.next(line);
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
    if (!hasCount || error != std::errc() || end != line.data() + line.size())
        lines.fail(message("the number of colors"));
    std::vector<Rgb8> colors;
    while (colors.size() < count) {
        if (!lines.next(line)) lines.fail(message("the last one: fewer colors follow than line 3 says"));
        colors.push_back(decimalColor(lines, line));
    }
    return colors;
}

std::vector<Rgb8> colorsOfPicture(const std::filesystem::path& file)
{
    const render::Image image = render::readColor(file);
    std::vector<Rgb8> colors;
    std::set<std::tuple<int, int, int>> known;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool gray = image.channels < 3, hasAlpha = image.channels % 2 == 0;
            if (hasAlpha && image.at(x, y, image.channels - 1) <= 0) continue;
            const auto code = [&](int k) { return render::srgb8FromLinear(image.at(x, y, gray ? 0 : k)); };
            const Rgb8 color(code(0), code(1), code(2));
            if (!known.insert({color.r, color.g, color.b}).second) continue;
            if (colors.size() == mostColors) return mainColors(image, static_cast<int>(mostColors));
            colors.push_back(color);
        }
    return colors;
}

}  // namespace

std::string_view paletteEndings()
{
    static const std::string endings = "gpl hex pal " + std::string(render::readEndings());
    return endings;
}

std::vector<Rgb8> readPalette(const std::filesystem::path& file)
{
    const std::string ending = render::lowerExtension(file);
    std::vector<Rgb8> colors;
    if (ending == ".gpl" || ending == ".hex" || ending == ".pal") {
        PaletteLines lines(file);
        colors = ending == ".gpl" ? readGimp(lines) : ending == ".hex" ? readHex(lines) : readJasc(lines);
    } else {
        colors = colorsOfPicture(file);
    }
    if (colors.empty() || colors.size() > mostColors)
        throw Failure(ErrorKind::file,
                      message("Cannot take the palette {1}: it has {2} colors; choose one with 1 to 256.",
                              file.string(), colors.size()));
    return colors;
}

std::string paletteText(PaletteFormat format, const std::vector<Rgb8>& colors, const std::string& name)
{
    std::string text;
    if (format == PaletteFormat::gpl) text = "GIMP Palette\nName: " + name + "\nColumns: 8\n#\n";
    if (format == PaletteFormat::pal) text = "JASC-PAL\r\n0100\r\n" + std::to_string(colors.size()) + "\r\n";
    const char* form = format == PaletteFormat::gpl   ? "%3d %3d %3d\n"
                       : format == PaletteFormat::hex ? "%02x%02x%02x\n"
                                                      : "%d %d %d\r\n";
    for (const Rgb8& c : colors) {
        std::array<char, 32> line{};
        std::snprintf(line.data(), line.size(), form, int{c.r}, int{c.g}, int{c.b});
        text += line.data();
    }
    return text;
}

}  // namespace vitrine::jobs
