#pragma once

#include "exhibits/study/study_comparison.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLayout;
class QTableWidget;

namespace vitrine::ui {

class ComparisonChart;

/// Several kept studies: their fronts over each other, and a table of how each stands to the first. Deletes itself when
/// closed.
class ComparisonDialog final : public QDialog {
    Q_OBJECT

public:
    /// Of two or more.
    explicit ComparisonDialog(std::vector<KeptStudy>, QWidget* parent = nullptr);

    [[nodiscard]] ComparisonChart& chart() const { return *chart_; }
    /// All that is shown, as a file: .csv, .json, or the chart as .png or .svg.
    [[nodiscard]] QByteArray exported(const QString& suffix);

signals:
    void failed(const QString& why);

private:
    [[nodiscard]] QLayout* top();
    [[nodiscard]] QLayout* bottom();
    void showCost(const std::string& cost);
    void fillTable();

    std::vector<KeptStudy> studies_;
    std::vector<std::string> labels_;
    QComboBox* cost_;
    QLabel* why_;
    ComparisonChart* chart_;
    QTableWidget* table_;
};

/// The texts of the table's line for a difference, in the order of its columns.
[[nodiscard]] QStringList differenceTexts(const StudyComparison&, const StudyDifference&);
[[nodiscard]] QStringList differenceColumns(const StudyComparison&);

}  // namespace vitrine::ui
