#pragma once

#include "ui/kit/quiet_dialog.h"

#include <QStringList>

class QLabel;
class QLineEdit;

namespace vitrine::ui {

class TagChips;

/// Asks for the tags of a preset: typed, separated by commas, or picked among those in use.
class TagsDialog final : public QuietDialog {
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
    QStringList tags_;  ///< As far as they are good.
};

}  // namespace vitrine::ui
