#pragma once

#include "ui/parameters/value_editor.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace vitrine::ui {

/// Editor of a toggle: a check box.
class ToggleEditor final : public ValueEditor {
    Q_OBJECT

public:
    ToggleEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    QCheckBox* box_;
};

/// Editor of a choice: a combo box.
class ChoiceEditor final : public ValueEditor {
    Q_OBJECT

public:
    ChoiceEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    QComboBox* box_;
};

/// Editor of a text that is edited elsewhere: shows whether there is one, and resets it.
class TextMark final : public ValueEditor {
    Q_OBJECT

public:
    TextMark(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    QLabel* words_;
};

/// Editor of a text: typed, or chosen from offered values.
class TextEditor final : public ValueEditor {
    Q_OBJECT

public:
    TextEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;
    void setOffers(const QStringList&) override;

private:
    QComboBox* box_;
    QString shown_;
};

/// Editor of a path: typed, chosen in a dialog, or dropped on the row.
class FileEditor final : public ValueEditor {
    Q_OBJECT

public:
    FileEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

protected:
    void dragEnterEvent(QDragEnterEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    void browse();
    void take(const QString& path);

    QLineEdit* path_;
    QToolButton* browse_;
    QString shown_;
};

}  // namespace vitrine::ui
