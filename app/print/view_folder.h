#pragma once

#include "render/files/unfinished.h"
#include "render/image/image.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::app {

/// Extensions that views may have, the usual one first: "png", "jpg".
[[nodiscard]] std::vector<std::string> viewFormats();

/// A folder of views that is there completely or not at all: they are written into a folder within and put in
/// place together at the end.
class ViewFolder {
public:
    /// `extension` is one of `viewFormats`; `count` views will come. Makes the folder when it is missing (not those
    /// that hold it). Throws Failure (Blame::file) when it cannot be made, or holds other pictures than views of these
    /// names: they would be taken for views as well. Clears what processes of this machine left there when they were
    /// killed.
    ViewFolder(std::filesystem::path, std::string extension, int count);
    /// Removes what was not published.
    ~ViewFolder();
    ViewFolder(const ViewFolder&) = delete;
    ViewFolder& operator=(const ViewFolder&) = delete;

    /// Writes view `k`, of linear light; a PNG carries the preset. Throws Failure as `writePicture` does.
    void add(int k, const render::Image&, const std::string& preset);
    void publish();

private:
    [[nodiscard]] std::string nameOf(int k) const;

    std::filesystem::path folder_;
    std::optional<render::Unfinished> newFolder_;
    std::filesystem::path part_;
    render::Unfinished unfinished_;
    std::string extension_;
    int digits_ = 2;
    bool made_ = false;  ///< The folder is new, and empty as long as nothing is published.
};

}  // namespace vitrine::app
