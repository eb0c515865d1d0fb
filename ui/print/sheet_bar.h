#pragma once

#include "exhibits/printing/sheet_list.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QToolButton;

namespace vitrine::ui {

class PrintSetup;

/// The list of lens sheets: choose one, save the numbers below as one of your own, delete one of your own.
class SheetBar final : public QWidget {
    Q_OBJECT

public:
    /// Changes the sheet of `setup`, which must outlive it, and shows which one that has.
    SheetBar(PrintSetup& setup, QWidget* parent);

    /// Of the list; empty where the numbers are those of none.
    [[nodiscard]] QString current() const;

public slots:
    void choose(const QString& name);
    void save(const QString& name);
    void remove(const QString& name);

signals:
    /// The list could not be read or written, or a sheet cannot be; `why` is for people.
    void failed(const QString& why);

private:
    void connectParts();
    void change(const std::function<void()>& work);
    void showSheets();
    void askName();

    PrintSetup& setup_;
    printing::SheetList sheets_;
    std::size_t count_ = 0;  ///< Entries of the list that are sheets.
    QComboBox* list_;
    QToolButton *save_, *remove_;
};

}  // namespace vitrine::ui
