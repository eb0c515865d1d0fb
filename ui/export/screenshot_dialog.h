#pragma once

#include "ui/export/picture_export.h"

#include <QDialog>
#include <QPointer>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace vitrine::ui {

/// Dialog for the export of a picture: asks for size, samples, format and file, and shows the progress. Does not block.
class ScreenshotDialog final : public QDialog {
    Q_OBJECT

public:
    ScreenshotDialog(Workbench&, QWidget* parent);
    void setPath(const QString&);
    [[nodiscard]] QString path() const;

signals:
    /// Emitted when an export began, with its request.
    void begun(const vitrine::ui::ExportRequest& exportRequest);

public slots:
    /// Cancels the running export, or closes the dialog if there is none.
    void reject() override;

private:
    void fillInputs();
    void layOut();
    void takeFormat();
    void browse();
    void start();
    void write(const QString& path);
    void setBusy(bool);
    [[nodiscard]] render::PictureFormat format() const;
    [[nodiscard]] ExportRequest exportRequest() const;

    Workbench& window_;
    QComboBox* sizes_;
    QSpinBox *width_, *height_, *samples_;
    QComboBox* format_;
    QCheckBox* transparent_;
    QLineEdit* path_;
    QString replaced_;  // File that the visitor agreed to replace.
    QProgressBar* progress_;
    QLabel* left_;
    QString saved_;  // The last written file.
    QPushButton *folder_, *go_, *stop_;
    QPointer<PictureExport> running_;
};

}  // namespace vitrine::ui
