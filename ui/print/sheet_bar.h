#pragma once

#include "exhibits/printing/sheet_list.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QToolButton;

namespace vitrine::ui {

class PrintSetup;

/// List of lens sheets: chooses one, saves the present numbers as a new one, deletes one of the visitor's own.
class SheetBar final : public QWidget {
    Q_OBJECT

public:
    /// Shows and changes the sheet of `setup`, which must outlive the bar.
    SheetBar(PrintSetup& setup, QWidget* parent);

    /// Returns the name of the chosen sheet; empty if the numbers match none.
    [[nodiscard]] QString current() const;

public slots:
    void choose(const QString& name);
    void save(const QString& name);
    void remove(const QString& name);

signals:
    /// Emitted when the list could not be read or written, or a sheet is impossible. `why` is a sentence for people.
    void failed(const QString& why);

private:
    void connectParts();
    void change(const std::function<void()>& work);
    void showSheets();
    void askName();

    PrintSetup& setup_;
    printing::SheetList sheets_;
    std::size_t count_ = 0;  ///< Number of list entries that are sheets.
    QComboBox* list_;
    QToolButton *save_, *remove_;
};

}  // namespace vitrine::ui
