#pragma once

#include "exhibits/jobs/kit/job.h"
#include "ui/jobs/job_runner.h"

#include <QObject>
#include <QStringList>

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>

namespace vitrine::ui {

class Workbench;

/// Repeats the window's last export of a picture with the present view: the same size, samples and format, under the
/// next free name in the same folder. Exports wait for each other.
class ExportAgain final : public QObject {
    Q_OBJECT

public:
    /// Returns the scene as it is now, for the job.
    using SceneSource = std::function<jobs::JobScene(const jobs::Job&)>;

    /// The workbench must outlive this object.
    ExportAgain(Workbench&, SceneSource, QObject& parent);

    /// Remembers an export that the visitor began.
    void note(const ParameterValues&, const QString& path);
    /// Returns whether there was an export yet.
    [[nodiscard]] bool possible() const { return values_.has_value(); }
    /// Begins the export and reports its end. Does nothing if there was none yet.
    void run();
    /// Returns the names of the files that are still to be written.
    [[nodiscard]] QStringList unfinished() const;
    /// Cancels all exports.
    void stop();

signals:
    /// Emitted when an export was remembered.
    void noted();
    /// Emitted at the end of an export. `written`: the file was written.
    void ended(bool written);

private:
    void goOn();

    Workbench& window_;
    SceneSource scene_;
    JobRunner runner_;
    std::optional<ParameterValues> values_;
    QString last_;                       ///< Path of the last export.
    std::deque<jobs::JobOrder> orders_;  ///< The first one is running.
};

}  // namespace vitrine::ui
