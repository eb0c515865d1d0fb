#pragma once

#include "ui/window/picture_export.h"

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

/// Asks for size, samples, format and place of a picture and shows how it is made. Blocks nothing.
class ScreenshotDialog final : public QDialog {
    Q_OBJECT

public:
    ScreenshotDialog(Workbench&, QWidget* parent);
    void setPath(const QString&);
    [[nodiscard]] QString path() const;

signals:
    /// An export began, as this describes it.
    void begun(const vitrine::ui::ExportWish& wish);

public slots:
    /// Cancels what runs; closes the dialog where nothing does.
    void reject() override;

private:
    void fillInputs();
    void layOut();
    void takeFormat();
    void browse();
    void start();
    void write(const QString& path);
    void setBusy(bool);
    [[nodiscard]] ExportWish wish() const;

    Workbench& window_;
    QComboBox* sizes_;
    QSpinBox *width_, *height_, *samples_;
    QComboBox* format_;
    QCheckBox* transparent_;
    QLineEdit* path_;
    QString replaced_;  // The visitor agreed that this file may be replaced.
    QProgressBar* progress_;
    QLabel* left_;
    QString saved_;  // The last file that was written.
    QPushButton *folder_, *go_, *stop_;
    QPointer<PictureExport> running_;
};

}  // namespace vitrine::ui
