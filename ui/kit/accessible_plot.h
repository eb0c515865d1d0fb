#pragma once

#include "ui/kit/accessible_content.h"

#include <qcustomplot.h>

namespace vitrine::ui {

/// Plot for screen readers: takes the focus, shows that it has it, and has sentences on its content.
class AccessiblePlot : public QCustomPlot, public AccessibleContent {
    Q_OBJECT

public:
    explicit AccessiblePlot(QWidget* parent = nullptr);

    void setSentences(const QString&);
    /// Gives background, axes, grid and legend the colors of the theme.
    void applyTheme();
    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Chart; }
    [[nodiscard]] QString accessibleText() const override { return sentences_; }

protected:
    void paintEvent(QPaintEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;

private:
    QString sentences_;
};

}  // namespace vitrine::ui
