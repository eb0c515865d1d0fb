#include "exhibits/printing/view_files.h"

#include "exhibits/printing/print_layout.h"
#include "render/failure.h"
#include "render/files/extension.h"
#include "render/files/number_text.h"
#include "render/image/image_limits.h"
#include "render/text/joined.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace vitrine::printing {
namespace {

namespace fs = std::filesystem;

/// Returns a note such as "Left out of the folder DIR, because these files are no PNG, ... pictures: a.bmp, b.gif."
std::string leftOutNote(const fs::path& folder, const std::vector<fs::path>& files)
{
    constexpr std::size_t mostNamed = 5;
    std::string list = joined(std::span(files).first(std::min(files.size(), mostNamed)), ", ",
                              [](const fs::path& file) { return file.filename().string(); });
    if (files.size() > mostNamed) list += ", and " + std::to_string(files.size() - mostNamed) + " more";
    return "Left out of the folder " + folder.string() + ", because these files are no " + render::readFormats() +
           " pictures: " + list + ".";
}

}  // namespace

bool beforeByNumber(const std::string& a, const std::string& b)
{
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (digit(a[i]) && digit(b[j])) {
            const auto run = [&](const std::string& text, std::size_t& at) {
                while (at < text.size() && text[at] == '0') ++at;
                const std::size_t first = at;
                while (at < text.size() && digit(text[at])) ++at;
                return text.substr(first, at - first);
            };
            const std::string left = run(a, i);
            const std::string right = run(b, j);
            if (left.size() != right.size()) return left.size() < right.size();
            if (left != right) return left < right;
        } else {
            if (small(a[i]) != small(b[j])) return small(a[i]) < small(b[j]);
            ++i;
            ++j;
        }
    }
    if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
    return a < b;
}

std::vector<fs::path> picturesIn(const fs::path& folder, std::vector<fs::path>* others)
{
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        if (!at->is_regular_file(error) || at->path().filename().string()[0] == '.') continue;
        if (const auto* format = render::formatNamed(at->path()); format && format->isRead)
            files.push_back(at->path());
        else if (others && render::lowerExtension(at->path()) != ".json")
            others->push_back(at->path());
    }
    if (error)
        throw Failure(ErrorKind::file, "Cannot read the folder " + folder.string() + ": " + error.message() + ".");
    const auto before = [](const fs::path& a, const fs::path& b) {
        return beforeByNumber(a.filename().string(), b.filename().string());
    };
    std::sort(files.begin(), files.end(), before);
    if (others) std::sort(others->begin(), others->end(), before);
    return files;
}

std::vector<fs::path> viewFiles(const std::vector<std::string>& names, std::vector<std::string>* notes)
{
    std::vector<fs::path> files;
    for (const std::string& name : names) {
        std::error_code error;
        if (fs::is_directory(name, error)) {
            std::vector<fs::path> others;
            std::vector<fs::path> found = picturesIn(name, &others);
            if (found.empty())
                throw Failure(ErrorKind::file, "There are no pictures in " + name +
                                                   "; give a folder with the views as " + render::readFormats() + ".");
            if (notes && !others.empty()) notes->push_back(leftOutNote(name, others));
            for (fs::path& file : found) files.push_back(std::move(file));
        } else {
            files.emplace_back(name);
        }
    }
    if (files.empty()) throw Failure(ErrorKind::usage, "There are no views; give a folder or files with --views.");
    return files;
}

std::string quiltNote(const render::Image& image, int columns, int rows)
{
    const int right = columns > 0 ? image.width % columns : 0;
    const int top = rows > 0 ? image.height % rows : 0;
    if (right == 0 && top == 0) return {};
    return "The quilt of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
           " pixels does not divide into " + std::to_string(columns) + " x " + std::to_string(rows) +
           " views; they have " + std::to_string(image.width / columns) + " x " + std::to_string(image.height / rows) +
           " pixels, and a margin of " + std::to_string(right) + " x " + std::to_string(top) +
           " pixels at the edges is left out.";
}

render::Image viewOfQuilt(const render::Image& image, int columns, int rows, int k, QuiltOrder order)
{
    if (columns < 1 || rows < 1 || image.width < columns || image.height < rows) {
        throw Failure(ErrorKind::usage, "A quilt of " + std::to_string(image.width) + " x " +
                                            std::to_string(image.height) + " pixels does not hold " +
                                            std::to_string(columns) + " x " + std::to_string(rows) +
                                            " views; give fewer columns and rows.");
    }
    render::Image view(image.width / columns, image.height / rows, image.channels);
    const int left = k % columns * view.width;
    const int row = k / columns;
    const int top = order == QuiltOrder::topLeft ? row * view.height : image.height - (row + 1) * view.height;
    for (int y = 0; y < view.height; ++y) {
        const float* from = image.pixels.data() + image.index(left, top + y);
        std::copy_n(from, static_cast<std::size_t>(view.width) * static_cast<std::size_t>(image.channels),
                    view.pixels.data() + view.index(0, y));
    }
    return view;
}

std::vector<std::size_t> chosenViews(std::size_t available, const SequenceSettings& settings)
{
    if (settings.every < 1)
        throw Failure(ErrorKind::usage, "--every " + std::to_string(settings.every) + ": give 1 or more.");
    std::vector<std::size_t> row;
    for (std::size_t i = 0; i < available; i += static_cast<std::size_t>(settings.every)) row.push_back(i);
    if (row.empty())
        throw Failure(ErrorKind::usage, "There are no views; give pictures with --views or --quilt, or an --exhibit.");
    if (settings.pingPong)
        for (std::size_t i = row.size() - 1; i-- > 1;) row.push_back(row[i]);

    if (settings.count < 0 || static_cast<std::size_t>(settings.count) > row.size()) {
        throw Failure(ErrorKind::usage, "--count " + std::to_string(settings.count) + ": there are " +
                                            std::to_string(row.size()) + " views; give 1 to " +
                                            std::to_string(row.size()) + ", or leave it out for all.");
    }
    const auto most = static_cast<std::size_t>(mostViews);
    const std::size_t count = settings.count == 0 ? row.size() : static_cast<std::size_t>(settings.count);
    if (count > most) {
        throw Failure(ErrorKind::usage,
                      "There are " + std::to_string(count) + " views, and at most " + std::to_string(mostViews) +
                          " are possible; take fewer with --every " +
                          std::to_string((row.size() + most - 1) / most * static_cast<std::size_t>(settings.every)) +
                          " or --count " + std::to_string(mostViews) + ".");
    }
    std::vector<std::size_t> chosen;
    const std::size_t last = row.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
        // Evenly spaced; a single view is the middle one.
        chosen.push_back(row[count == 1 ? (last + 1) / 2 : (2 * last * i + count - 1) / (2 * (count - 1))]);
    }
    return chosen;
}

}  // namespace vitrine::printing
