#pragma once

#include "exhibits/framework/chart.h"

#include <QTimer>
#include <QWidget>

#include <cstddef>
#include <vector>

class QCustomPlot;
class QHBoxLayout;
class QLabel;

namespace vitrine {
class Museum;
}

namespace vitrine::ui {

class History;
class ProgressJob;

/// The charts that the chosen exhibit offers of its present values, side by side. They are made on another thread, and
/// only while they can be seen.
class ChartsDock final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive it.
    ChartsDock(const Museum&, History&, QWidget* parent = nullptr);
    ~ChartsDock() override;

    void setSubject(std::size_t exhibit);
    /// What is shown; empty while the first are made, and where the exhibit has none.
    [[nodiscard]] const std::vector<Chart>& charts() const { return charts_; }
    [[nodiscard]] const std::vector<QCustomPlot*>& plots() const { return plots_; }
    /// What is said in place of charts; empty where there are some.
    [[nodiscard]] QString note() const;

signals:
    void renewed();

protected:
    void showEvent(QShowEvent*) override;
    void changeEvent(QEvent*) override;

private:
    void ask();
    void renew();
    void take(std::vector<Chart>);
    void draw();
    void sayWhyEmpty();
    void say(const QString&);

    const Museum& museum_;
    History& history_;
    std::size_t exhibit_ = 0;
    std::vector<Chart> charts_;
    std::vector<QCustomPlot*> plots_;
    QHBoxLayout* row_;
    QLabel* note_;
    QTimer soon_;  // So that a slider that is dragged asks once.
    ProgressJob* job_;
};

}  // namespace vitrine::ui
