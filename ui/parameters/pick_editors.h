#pragma once

#include "ui/parameters/value_editor.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QToolButton;

namespace vitrine::ui {

/// On or off.
class ToggleEditor final : public ValueEditor {
    Q_OBJECT

public:
    ToggleEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    QCheckBox* box_;
};

/// One of several names.
class ChoiceEditor final : public ValueEditor {
    Q_OBJECT

public:
    ChoiceEditor(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    QComboBox* box_;
};

/// Whether there is a text: what it says is edited elsewhere, and reset here.
class TextMark final : public ValueEditor {
    Q_OBJECT

public:
    TextMark(const ValueRef&, QWidget* parent);
    void showValue(const Value&) override;

private:
    QLabel* words_;
};

/// A text that is typed, or chosen from a list where some are offered.
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

/// A path: typed, chosen, or dropped on the row.
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
