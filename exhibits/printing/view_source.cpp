#include "exhibits/printing/view_source.h"

#include "render/failure.h"
#include "render/files/extension.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace vitrine::lenticular {
namespace {

namespace fs = std::filesystem;

/// A view that takes more than this part of the memory goes to disk at once: while it is read it is in memory anyway.
constexpr std::size_t largestShare = 4;

/// Compares names as people do: runs of digits by their value.
bool beforeByNumber(const std::string& a, const std::string& b)
{
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
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
            if (a[i] != b[j]) return a[i] < b[j];
            ++i;
            ++j;
        }
    }
    if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
    return a < b;
}

bool looksLikePicture(const fs::path& file)
{
    const std::string extension = render::lowerExtension(file);
    for (const char* known : {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr"})
        if (extension == known) return true;
    return false;
}

std::uint16_t code(double linear)
{
    return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(linear, 0.0, 1.0)));
}

/// The rows of the source that row `y` of `height` shows, box-filtered or, when enlarging, interpolated.
void resampledRow(const render::Image& image, int y, int height, std::vector<double>& out)
{
    const double scale = static_cast<double>(image.height) / height;
    const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
    std::fill(out.begin(), out.end(), 0.0);
    const auto add = [&](int from, double weight) {
        const float* at = image.pixels.data() + static_cast<std::size_t>(std::clamp(from, 0, image.height - 1)) * row;
        for (std::size_t i = 0; i < row; ++i) out[i] += weight * static_cast<double>(at[i]);
    };
    if (scale <= 1) {
        const double at = (y + 0.5) * scale - 0.5;
        const int first = static_cast<int>(std::floor(at));
        if (at > first) add(first + 1, at - first);
        add(first, 1 - (at - first));
        return;
    }
    const double from = y * scale;
    const double to = from + scale;
    for (int r = static_cast<int>(from); r < to && r < image.height; ++r) add(r, (std::min<double>(to, r + 1) - std::max<double>(from, r)) / scale);
}

}  // namespace

void ViewSet::add(const render::Image& image)
{
    if (image.width < 1 || image.height < 1 || image.channels < 1) throw Failure(Blame::file, "A view is empty; choose another picture.");
    if (height_ == 0) height_ = image.height;
    const auto channels = static_cast<std::size_t>(image.channels);
    const std::size_t rowSamples = static_cast<std::size_t>(image.width) * 4;
    const std::size_t samples = rowSamples * static_cast<std::size_t>(height_) + 4;
    const bool onDisk = scratch_ || samples * 2 > memory_ / largestShare || samples * 2 > memory_ - used_;
    if (onDisk && !scratch_) {
        scratch_ = std::make_shared<render::ScratchFile>();
        firstOnDisk_ = views_.size();
    }
    const std::uint64_t begin = onDisk ? scratch_->size() : 0;
    auto kept = onDisk ? nullptr : std::make_shared<std::vector<std::uint16_t>>(samples);
    std::vector<std::uint16_t> passing(onDisk ? rowSamples : 0);
    std::vector<double> row(static_cast<std::size_t>(image.width) * channels);
    const bool gray = channels < 3;
    const std::size_t alphaAt = channels == 2 ? 1 : channels == 4 ? 3 : channels;
    for (int y = 0; y < height_; ++y) {
        resampledRow(image, y, height_, row);
        std::uint16_t* out = onDisk ? passing.data() : kept->data() + static_cast<std::size_t>(y) * rowSamples;
        for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x, out += 4) {
            const double* pixel = row.data() + x * channels;
            const double alpha = alphaAt < channels ? std::clamp(pixel[alphaAt], 0.0, 1.0) : 1.0;
            for (std::size_t c = 0; c < 3; ++c) out[c] = code(pixel[gray ? 0 : c] * alpha + (1 - alpha));
        }
        if (onDisk) scratch_->append(passing.data(), rowSamples * 2);
    }
    if (!onDisk) {
        used_ += samples * 2;
        views_.push_back({image.width, {kept, kept->data()}});
        return;
    }
    const std::array<std::uint16_t, 4> behind{};
    scratch_->append(behind.data(), sizeof behind);
    scratch_->align();
    const auto* mapped = static_cast<const std::uint16_t*>(scratch_->map(begin, samples * 2));
    views_.push_back({image.width, {mapped, [samples](const std::uint16_t* at) { render::unmapPages(at, samples * 2); }}});
}

void ViewSet::rowIsRead(int y) const
{
    for (std::size_t k = firstOnDisk_; k < views_.size(); ++k) {
        const std::size_t row = static_cast<std::size_t>(views_[k].width) * 8;
        render::releasePages(views_[k].samples.get(), row * static_cast<std::size_t>(height_), row * static_cast<std::size_t>(y), row);
    }
}

void ViewSet::allIsRead() const
{
    for (std::size_t k = firstOnDisk_; k < views_.size(); ++k) {
        const std::size_t all = static_cast<std::size_t>(views_[k].width) * 8 * static_cast<std::size_t>(height_);
        render::releasePages(views_[k].samples.get(), all, 0, all);
    }
}

std::vector<fs::path> picturesIn(const fs::path& folder)
{
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (at->is_regular_file(error) && looksLikePicture(at->path()) && at->path().filename().string()[0] != '.') files.push_back(at->path());
    if (error) throw Failure(Blame::file, "Cannot read the folder " + folder.string() + ": " + error.message() + ".");
    std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) { return beforeByNumber(a.filename().string(), b.filename().string()); });
    return files;
}

std::vector<fs::path> viewFiles(const std::vector<std::string>& names)
{
    std::vector<fs::path> files;
    for (const std::string& name : names) {
        std::error_code error;
        if (fs::is_directory(name, error)) {
            std::vector<fs::path> found = picturesIn(name);
            if (found.empty()) throw Failure(Blame::file, "There are no pictures in " + name + "; give a folder with the views as PNG, JPEG, TIFF, EXR or HDR.");
            for (fs::path& file : found) files.push_back(std::move(file));
        } else {
            files.emplace_back(name);
        }
    }
    if (files.empty()) throw Failure(Blame::usage, "There are no views; give a folder or files with --views.");
    return files;
}

render::Image viewOfQuilt(const render::Image& image, int columns, int rows, int k, QuiltOrder order)
{
    if (columns < 1 || rows < 1 || image.width % columns != 0 || image.height % rows != 0) {
        throw Failure(Blame::usage, "A quilt of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels does not divide into " +
                                        std::to_string(columns) + " x " + std::to_string(rows) + " views.");
    }
    render::Image view(image.width / columns, image.height / rows, image.channels);
    const int left = k % columns * view.width;
    const int row = order == QuiltOrder::topLeft ? k / columns : rows - 1 - k / columns;
    for (int y = 0; y < view.height; ++y) {
        const float* from = image.pixels.data() + image.index(left, row * view.height + y);
        std::copy_n(from, static_cast<std::size_t>(view.width) * static_cast<std::size_t>(image.channels), view.pixels.data() + view.index(0, y));
    }
    return view;
}

}  // namespace vitrine::lenticular
