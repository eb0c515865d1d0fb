#pragma once

#include "ui/study/picture_panes.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLayout;
class QToolButton;

namespace vitrine::ui {

/// The pictures of a study in a window of their own, as large as the screen if wanted.
class LargePictures final : public QDialog {
    Q_OBJECT

public:
    explicit LargePictures(QWidget* parent = nullptr);

    /// `caption`: which setting, with its numbers; `scale`: what the heat map goes to.
    void setPictures(PictureTriple, const QString& caption, const QString& scale);
    /// The views of the study, and which of them is shown.
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
