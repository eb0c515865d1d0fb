#pragma once

#include "exhibits/jobs/kit/job_document.h"

#include <QString>
#include <QStringList>

#include <filesystem>

namespace vitrine::ui {

/// The visitor's presets of one job's settings: settings documents in a folder of their own, named after the presets.
class ExportPresets {
public:
    /// The job must outlive this object.
    explicit ExportPresets(const jobs::Job&);

    /// Returns the names in alphabetical order, also those of files that cannot be read.
    [[nodiscard]] QStringList names() const;
    /// Returns the file of a preset, whether it exists or not.
    [[nodiscard]] std::filesystem::path file(const QString& name) const;
    /// Writes a preset, in place of one with this name. Throws Failure.
    void save(const QString& name, const ParameterValues&) const;
    /// Reads a preset. Throws Failure naming file and key if it is no settings document of the job.
    [[nodiscard]] jobs::JobDocument read(const QString& name) const;
    /// Deletes a preset. Throws Failure.
    void remove(const QString& name) const;

private:
    const jobs::Job& job_;
};

}  // namespace vitrine::ui
