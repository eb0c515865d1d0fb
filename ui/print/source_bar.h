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

/// Bar with the source of a print's views, and the result of reading or rendering them.
class SourceBar final : public QWidget {
    Q_OBJECT

public:
    /// `canShow`: views can be rendered from the window's picture. The setup must outlive the bar.
    SourceBar(bool canShow, PrintSetup&, QWidget* parent);

    void showOrigin(printing::ViewOrigin);
    /// Shows "16 views", or why there are none.
    void say(const QString&);
    [[nodiscard]] QString said() const;
    /// Returns the fields for turn and shift of single pictures.
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
