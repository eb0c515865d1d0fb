#pragma once

#include "exhibits/study/study_comparison.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLayout;
class QTableWidget;

namespace vitrine::ui {

class ComparisonChart;

/// Dialog that compares kept studies: their fronts in one chart, and a table with each one's difference from the first.
/// Deletes itself when closed.
class ComparisonDialog final : public QDialog {
    Q_OBJECT

public:
    /// Requires two or more studies.
    explicit ComparisonDialog(std::vector<study::KeptStudy>, QWidget* parent = nullptr);

    [[nodiscard]] ComparisonChart& chart() const { return *chart_; }
    /// Returns the content of a file with all that is shown: .csv, .json, or the chart as .png or .svg.
    [[nodiscard]] QByteArray exported(const QString& suffix);

signals:
    void failed(const QString& why);

private:
    [[nodiscard]] QLayout* top();
    [[nodiscard]] QLayout* bottom();
    void showCost(const std::string& cost);
    void fillTable();

    std::vector<study::KeptStudy> studies_;
    std::vector<std::string> labels_;
    QComboBox* cost_;
    QLabel* why_;
    ComparisonChart* chart_;
    QTableWidget* table_;
};

/// Returns the cells of the table's line for a difference, in the order of the columns.
[[nodiscard]] QStringList differenceTexts(const study::StudyComparison&, const study::StudyDifference&);
[[nodiscard]] QStringList differenceColumns(const study::StudyComparison&);

}  // namespace vitrine::ui
