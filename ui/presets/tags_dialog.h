#pragma once

#include "ui/kit/inline_dialog.h"

#include <QStringList>

class QLabel;
class QLineEdit;

namespace vitrine::ui {

class TagChips;

/// Dialog for the tags of a preset: typed with commas between them, or picked from those in use.
class TagsDialog final : public InlineDialog {
    Q_OBJECT

public:
    TagsDialog(const QString& preset, const QStringList& tags, const QStringList& inUse, QWidget* parent);

signals:
    void given(const QStringList& tags);

private:
    void check();
    void pick();

    QLineEdit* text_;
    QLabel* why_;
    TagChips* chips_;
    QStringList tags_;  ///< Typed tags, as far as they are valid.
};

}  // namespace vitrine::ui
