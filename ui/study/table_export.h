#pragma once

#include "ui/viewport/render_thread.h"

#include <QElapsedTimer>
#include <QObject>

#include <memory>

class QProgressDialog;
class QWidget;

namespace vitrine {
class MeasuresTable;
}

namespace vitrine::ui {

class Workbench;

/// Measures the table of the visited exhibit (`MeasuresTable`) on the render thread, and saves it as CSV. Deletes
/// itself when it is done, canceled or failed.
class TableExport final : public QObject {
    Q_OBJECT

public:
    /// Asks for a file name and starts. Shows a message if the visited exhibit has no table. Returns at once.
    static void ask(Workbench&, QWidget* window);

    /// Starts measuring. All must outlive this object.
    TableExport(Workbench&, const MeasuresTable&, QString path, QWidget* window);
    ~TableExport() override;

    /// Cancels without writing a file.
    void cancel();

private:
    struct Work;
    void note(double part);
    void end(const QString& failure);

    Workbench& window_;
    QString path_;
    QByteArray csv_;
    QElapsedTimer elapsed_;
    QProgressDialog* shown_;
    RenderThread::Task task_;
};

}  // namespace vitrine::ui
