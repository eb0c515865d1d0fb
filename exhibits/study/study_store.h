#pragma once

#include "exhibits/study/contact_sheet.h"
#include "exhibits/study/kept_study.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace vitrine {

/// A kept study as a list shows it.
struct StudyEntry {
    std::filesystem::path path;
    std::string problem;  ///< Why it cannot be read; empty where it can, and then the rest is filled in.
    KeptStudy study = {};
};

/// What a study without a name of its own is called after: its file, or the folder of a "study.json".
[[nodiscard]] std::string nameOfStudyFile(const std::filesystem::path&);

/// What `StudyStore::remove` moved away.
struct RemovedStudy {
    std::filesystem::path original, trashed;
};

/// The studies on disk, a file each, as `studyJson` writes them, with "measured", "complete" and a name beside it; the
/// pictures of "NAME.json", where they were kept, in "NAME.pictures.exr".
///
/// They are bounded in number and bytes: before a new one is kept, the oldest without a name go, and of pictures those
/// of the oldest without a name. One with a name, and a file that cannot be read, never go by themselves. Every
/// function throws Failure naming file and cause, and then has changed nothing.
class StudyStore {
public:
    struct Limits {
        std::size_t studies = 100;
        std::uintmax_t bytes = 32U << 20U;
        std::uintmax_t pictureBytes = 512U << 20U;
    };
    StudyStore(std::filesystem::path folder, std::filesystem::path trash) : StudyStore(folder, trash, Limits()) {}
    StudyStore(std::filesystem::path folder, std::filesystem::path trash, Limits limits)
        : folder_(std::move(folder)), trash_(std::move(trash)), limits_(limits)
    {
    }
    /// In `stateFolder()`.
    [[nodiscard]] static StudyStore standard();

    /// The newest first; those that cannot be read last.
    [[nodiscard]] std::vector<StudyEntry> list() const;
    /// Keeps what `studyJson` made; `measured` as `KeptStudy::measured`. Returns its path.
    std::filesystem::path keep(render::Json study, const std::string& measured, bool complete) const;
    /// Keeps copies of the studies of a file from elsewhere after reading all of it, under their own names, or that of
    /// the file or its folder; returns their paths, or those of the same studies where they are kept already.
    std::vector<std::filesystem::path> add(const std::filesystem::path& from) const;
    void rename(const std::filesystem::path&, const std::string& name) const;
    /// Keeps the pictures of a study that is kept; an empty sheet is none.
    void keepPictures(const std::filesystem::path& study, const ContactSheet&) const;
    /// Those of a study; empty where none were kept.
    [[nodiscard]] ContactSheet pictures(const std::filesystem::path&, const KeptStudy&) const;
    /// Moves it to the trash, and its pictures.
    [[nodiscard]] RemovedStudy remove(const std::filesystem::path&) const;
    /// Puts it back, under another file name where its own is taken by now; returns the path.
    std::filesystem::path restore(const RemovedStudy&) const;

private:
    std::filesystem::path write(const render::Json&) const;
    void makeRoomFor(std::uintmax_t bytes) const;
    void makeRoomForPictures(const std::filesystem::path& added) const;

    std::filesystem::path folder_, trash_;
    Limits limits_;
};

}  // namespace vitrine
