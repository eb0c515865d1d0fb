#pragma once

#include "ui/study/picture_panes.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLayout;
class QToolButton;

namespace vitrine::ui {

/// Window with a study's pictures, which can fill the screen.
class LargePictures final : public QDialog {
    Q_OBJECT

public:
    explicit LargePictures(QWidget* parent = nullptr);

    /// Shows pictures. `caption`: the setting with its numbers; `scale`: range of the heat map.
    void setPictures(PictureTriple, const QString& caption, const QString& scale);
    /// Sets the views of the study and the one that is shown.
    void setViews(const QStringList&, int shown);
    [[nodiscard]] PicturePanes& panes() const { return *panes_; }

signals:
    void viewChosen(int view);

private:
    [[nodiscard]] QLayout* buttons();
    QToolButton* addButton(QLayout*, const QString& text, const QString& help);
    void showZoom();

    QComboBox* view_;
    QToolButton* wipe_;
    QLabel* zoom_;
    QLabel* caption_;
    QLabel* reading_;
    QLabel* scale_;
    PicturePanes* panes_;
};

}  // namespace vitrine::ui
