#pragma once

#include "exhibits/framework/files/document_folder.h"
#include "exhibits/study/contact_sheet.h"
#include "exhibits/study/kept_study.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine::study {

/// Kept study in a list.
struct StudyEntry {
    std::filesystem::path path;
    std::string problem;  ///< Why it cannot be read; empty if it can, and then `study` is filled in.
    KeptStudy study = {};
};

/// Returns the name for a study without its own name: that of its file, or of the folder of a "study.json".
[[nodiscard]] std::string nameOfStudyFile(const std::filesystem::path&);

/// Studies on disk, one file each, as `studyJson` writes them, with "measured", "complete" and a name added. The
/// pictures of "NAME.json", if kept, are in "NAME.pictures.exr".
///
/// Number and bytes are limited. Before a new study is kept, the oldest ones without a name are deleted, and likewise
/// pictures of the oldest ones without a name. Studies with a name, and files that cannot be read, are never deleted
/// automatically.
///
/// Every function throws Failure naming file and cause. The studies are then unchanged, but `add` may have kept some of
/// a file's studies, and `keepPictures` may have removed earlier pictures.
class StudyStore {
public:
    struct Limits {
        std::size_t studies = 100;
        std::uintmax_t bytes = 32U << 20U;
        std::uintmax_t pictureBytes = 512U << 20U;
    };
    static constexpr const char* picturesExtension = ".pictures.exr";

    StudyStore(std::filesystem::path folder, std::filesystem::path trash) : StudyStore(folder, trash, Limits()) {}
    StudyStore(std::filesystem::path folder, std::filesystem::path trash, Limits limits)
        : folder_(std::move(folder)), trash_(std::move(trash)), limits_(limits)
    {
    }
    /// Returns the store in `stateFolder()`.
    [[nodiscard]] static StudyStore standard();

    /// Lists the newest first, unreadable files last.
    [[nodiscard]] std::vector<StudyEntry> list() const;
    /// Keeps what `studyJson` made; `measured` is in the format of `KeptStudy::measured`. Returns its path.
    std::filesystem::path keep(render::Json study, const std::string& measured, bool complete) const;
    /// Keeps copies of the studies in another file after reading all of it. Names are their own, or that of the file or
    /// its folder. Returns the paths; a study that is kept already is not copied.
    std::vector<std::filesystem::path> add(const std::filesystem::path& from) const;
    void rename(const std::filesystem::path&, const std::string& name) const;
    /// Keeps the pictures of a kept study; an empty sheet adds none.
    void keepPictures(const std::filesystem::path& study, const ContactSheet&) const;
    /// Returns the pictures of a study; empty if none were kept.
    [[nodiscard]] ContactSheet pictures(const std::filesystem::path&, const KeptStudy&) const;
    /// Moves a study and its pictures to the trash.
    [[nodiscard]] RemovedDocument remove(const std::filesystem::path& path) const
    {
        return removeDocument(path, trash_, picturesExtension);
    }
    /// Moves a study back, with another file name if its own is taken. Returns the path.
    std::filesystem::path restore(const RemovedDocument& removed) const
    {
        return restoreDocument(removed, picturesExtension);
    }

private:
    std::filesystem::path write(const render::Json&) const;
    void makeRoomFor(std::uintmax_t bytes) const;
    void makeRoomForPictures(const std::filesystem::path& added) const;

    std::filesystem::path folder_, trash_;
    Limits limits_;
};

}  // namespace vitrine::study
