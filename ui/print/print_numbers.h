#pragma once

#include "exhibits/printing/print_plan.h"
#include "ui/kit/accessible_content.h"

#include <QWidget>

#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QLayout;
class QPushButton;

namespace vitrine::ui {

/// Bar chart of crosstalk: for each view, the share of other views at its own angle.
class CrosstalkBars final : public QWidget, public AccessibleContent {
    Q_OBJECT

public:
    explicit CrosstalkBars(QWidget* parent);
    void showShares(std::vector<double> ownShare);

    [[nodiscard]] QAccessible::Role accessibleRole() const override { return QAccessible::Chart; }
    [[nodiscard]] QString accessibleText() const override;

protected:
    void paintEvent(QPaintEvent*) override;

private:
    std::vector<double> own_;
};

/// Numbers that a printer asks for, warnings, and reasons why a print cannot be made.
class PrintNumbersView final : public QWidget {
    Q_OBJECT

public:
    explicit PrintNumbersView(QWidget* parent = nullptr);

    /// Shows a plan. The scene's depth is known for rendered views only.
    void showPlan(const printing::PrintPlan&, const std::optional<printing::SceneDepth>&);
    /// Returns the text shown beside a label such as "Pixels per lens".
    [[nodiscard]] QString shown(const QString& label) const;
    [[nodiscard]] QString messages() const;

signals:
    /// Emitted when the scene is too deep for the print. `strength`: the strength of the rig that fits.
    void fitAsked(double strength);

private:
    void buildNumbers();
    /// Places the numbers in two columns, or in one if the type is large.
    void layOutNumbers(QGridLayout&);
    [[nodiscard]] QLayout* buildCrosstalk();
    [[nodiscard]] QLayout* buildMessages();
    void showNumbers(const printing::PrintPlan&, const std::optional<printing::SceneDepth>&);
    QLabel* addNumber(const QString& label, const QString& help);

    std::vector<std::pair<QLabel*, QLabel*>> numbers_;
    QLabel *perLens_, *lpi_, *views_, *zone_, *depth_, *scene_, *size_, *bytes_;
    CrosstalkBars* bars_;
    QLabel* crosstalk_;
    QLabel* messages_;
    QPushButton* fit_;
    double fitting_ = 1;
};

}  // namespace vitrine::ui
