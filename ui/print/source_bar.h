#pragma once

#include "exhibits/printing/print_table.h"

#include <QStringList>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;

namespace vitrine::ui {

class PlaceBar;
class PrintSetup;

/// Where the views of a print come from, and what came of it.
class SourceBar final : public QWidget {
    Q_OBJECT

public:
    /// `canShow`: there is a picture in the window to render views from. The setup must outlive it.
    SourceBar(bool canShow, PrintSetup&, QWidget* parent);

    void showOrigin(printing::ViewOrigin);
    /// "16 views" or why there are none.
    void say(const QString&);
    [[nodiscard]] QString said() const;
    /// Fields for turn and shift of single pictures.
    [[nodiscard]] PlaceBar& places() const { return *places_; }

signals:
    void originChosen(vitrine::printing::ViewOrigin);
    void filesChosen(const QStringList&);
    void renderAsked();

private:
    void chooseFolder();
    void chooseFiles();

    QComboBox* origin_;
    QPushButton *render_, *folder_, *files_;
    QLabel* said_;
    PlaceBar* places_;
    printing::ViewOrigin shown_ = printing::ViewOrigin::files;
};

}  // namespace vitrine::ui
