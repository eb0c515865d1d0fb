#pragma once

#include "ui/kit/quiet_dialog.h"

class QLineEdit;

namespace vitrine::ui {

/// Asks for a name.
class NameDialog final : public QuietDialog {
    Q_OBJECT

public:
    /// `suggestion` is selected: typing replaces it.
    NameDialog(const QString& heading, const QString& suggestion, QWidget* parent);

    [[nodiscard]] QString name() const;

signals:
    /// Never empty.
    void named(const QString& name);

private:
    QLineEdit* name_;
};

}  // namespace vitrine::ui
