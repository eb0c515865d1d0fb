#pragma once

#include "ui/kit/inline_dialog.h"

class QLineEdit;

namespace vitrine::ui {

/// Dialog that asks for a name.
class NameDialog final : public InlineDialog {
    Q_OBJECT

public:
    /// `suggestion` is selected at first: typing replaces it.
    NameDialog(const QString& heading, const QString& suggestion, QWidget* parent);

    [[nodiscard]] QString name() const;

signals:
    /// Emitted with the chosen name, which is never empty.
    void named(const QString& name);

private:
    QLineEdit* name_;
};

}  // namespace vitrine::ui
