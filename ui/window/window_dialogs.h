#pragma once

#include "ui/export/export_dialog.h"

#include <QObject>
#include <QString>

#include <cstddef>

class QWidget;

namespace vitrine::jobs {
class Job;
}

namespace vitrine::ui {

class Bookmarks;
class ExportAgain;
class LessonController;
class SettingsB;
class Workbench;

/// Opener of the window's dialogs. A dialog that is open already is raised instead of a second one.
class WindowDialogs final : public QObject {
    Q_OBJECT

public:
    /// The window is the parent of all dialogs. `other`: settings that a comparison shows beside those of the window.
    /// `again` notes the exports of pictures. All must outlive this object.
    WindowDialogs(Workbench&, QWidget& window, SettingsB& other, Bookmarks&, LessonController&, ExportAgain& again);

    void openAbout();
    /// Opens the print dialog, with this print if the path is not empty.
    void openPrint(const QString& print = {});
    /// Opens the dialog of a job. The museum must have the exhibit that it needs.
    void openJob(const jobs::Job&);
    /// Asks for a file, and writes the bookmarks to it.
    void saveTour();
    /// Opens the page about this subject.
    void openPage(std::size_t subject);
    /// Opens the page of this name: that of an exhibit, or "syllabus".
    void openPage(const QString& page);
    /// Ends all dialogs and exports that draw. Call before the viewport and its render thread are destroyed.
    void closeAll();

private:
    [[nodiscard]] std::vector<ExportKind> exportKinds();
    [[nodiscard]] QDialog* makeJobPage(const jobs::Job&, QWidget* parent);
    /// Shows this kind of export and returns its page.
    QDialog* openExport(const QString& kind);

    Workbench& workbench_;
    QWidget& window_;
    SettingsB& other_;
    Bookmarks& bookmarks_;
    LessonController& lessons_;
    ExportAgain& again_;
    double secondsPerSample_ = 0;  ///< Time of the last picture of the window per pixel.
};

}  // namespace vitrine::ui
