#pragma once

#include "render/files/unfinished.h"
#include "render/image/image.h"

#include <filesystem>
#include <optional>
#include <string>

namespace vitrine::jobs {

/// Folder of views that is either complete or absent: views are written into a subfolder, and moved out of it together
/// at the end.
class ViewFolder {
public:
    /// `extension` is one of `printing::viewFormats`; `count` is the number of views. Creates the folder if it is
    /// missing, but not its parents. Removes unfinished views of killed processes of this machine. Throws Failure
    /// (ErrorKind::file) if the folder cannot be created, or contains other pictures with names of views, which would
    /// be mistaken for views.
    ViewFolder(std::filesystem::path, std::string extension, int count);
    /// Removes views that were not published.
    ~ViewFolder();
    ViewFolder(const ViewFolder&) = delete;
    ViewFolder& operator=(const ViewFolder&) = delete;

    /// Writes view `k`, in linear light; a PNG contains the preset. Throws Failure like `writePicture`.
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

}  // namespace vitrine::jobs
