#include "exhibits/jobs/print/view_folder.h"

#include "exhibits/printing/print_table.h"
#include "exhibits/printing/view_files.h"
#include "render/failure.h"
#include "render/image/image_io.h"

#include <algorithm>

namespace vitrine::jobs {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const std::string& why)
{
    throw Failure(ErrorKind::file, "--save-views " + folder.string() + ": " + why + ".");
}

/// Removes unfinished views of processes that have ended.
void clearViews(const fs::path& folder)
{
    std::vector<fs::path> left;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(".views.") && render::isLeftBehind(name)) left.push_back(entry->path());
    }
    for (const fs::path& part : left) fs::remove_all(part, error);
}

}  // namespace

ViewFolder::ViewFolder(fs::path folder, std::string extension, int count)
    : folder_(std::move(folder)), part_(folder_ / (".views" + render::partSuffix())), unfinished_(part_),
      extension_(std::move(extension)), digits_(count > 100 ? 3 : 2)
{
    std::error_code error;
    made_ = fs::create_directory(folder_, error);
    if (error) refuse(folder_, "the folder cannot be made (" + error.message() + "); choose another");
    if (made_) newFolder_.emplace(folder_, render::Unfinished::Content::onlyIfEmpty);
    clearViews(folder_);
    std::vector<std::string> names;
    for (int k = 0; k < count; ++k) names.push_back(nameOf(k));
    for (const fs::path& file : printing::picturesIn(folder_)) {
        if (std::find(names.begin(), names.end(), file.filename().string()) == names.end()) {
            refuse(folder_, "it holds " + file.filename().string() + ", which is none of the " + std::to_string(count) +
                                " views to be written; choose an empty folder");
        }
    }
    fs::create_directory(part_, error);
    std::error_code ignored;
    if (error && made_) fs::remove(folder_, ignored);
    if (error) refuse(folder_, "nothing can be written into it (" + error.message() + "); choose another");
}

ViewFolder::~ViewFolder()
{
    std::error_code error;
    fs::remove_all(part_, error);
    if (made_) fs::remove(folder_, error);
}

std::string ViewFolder::nameOf(int k) const
{
    std::string number = std::to_string(k);
    number.insert(0, static_cast<std::size_t>(std::max(digits_ - static_cast<int>(number.size()), 0)), '0');
    return "view_" + number + '.' + extension_;
}

void ViewFolder::add(int k, const render::Image& image, const std::string& preset)
{
    const fs::path file = part_ / nameOf(k);
    render::writePicture(file, image, render::writtenFormat(file, printing::viewBits).value(), {.preset = preset});
}

void ViewFolder::publish()
{
    const auto lock = render::unfinishedLock();
    std::vector<fs::path> files;
    for (const fs::directory_entry& file : fs::directory_iterator(part_)) files.push_back(file.path());
    for (const fs::path& file : files) {
        std::error_code error;
        fs::rename(file, folder_ / file.filename(), error);
        if (error) refuse(folder_, file.filename().string() + " cannot be put in place (" + error.message() + ")");
    }
    made_ = false;
}

}  // namespace vitrine::jobs
