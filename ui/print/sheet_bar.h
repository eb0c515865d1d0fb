#pragma once

#include "exhibits/printing/sheet.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace vitrine::ui {

/// The list of lens sheets: choose one, save the numbers below as one of your own, delete one of your own.
class SheetBar final : public QWidget {
    Q_OBJECT

public:
    explicit SheetBar(QWidget* parent);

    /// Shipped sheets first. `current` is the name of the sheet that the numbers are; empty: none of the list.
    void showSheets(const std::vector<printing::Sheet>&, const std::string& current);
    [[nodiscard]] QString current() const;

signals:
    void chosen(const QString& name);
    void saveAsked(const QString& name);
    void removeAsked(const QString& name);

private:
    void askName();

    QComboBox* list_;
    QToolButton *save_, *remove_;
    std::vector<printing::Sheet> sheets_;
};

}  // namespace vitrine::ui
