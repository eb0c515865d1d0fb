#pragma once

#include "exhibits/framework/scene/chart.h"

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

/// Dock with the charts of the chosen exhibit's present values, side by side. They are computed on another thread, and
/// only while the dock is visible.
class ChartsDock final : public QWidget {
    Q_OBJECT

public:
    /// Both must outlive the dock.
    ChartsDock(const Museum&, History&, QWidget* parent = nullptr);
    ~ChartsDock() override;

    void setSubject(std::size_t exhibit);
    /// Charts on display; empty while the first are computed, and if the exhibit has none.
    [[nodiscard]] const std::vector<Chart>& charts() const { return charts_; }
    [[nodiscard]] const std::vector<QCustomPlot*>& plots() const { return plots_; }
    /// Text shown in place of charts; empty if there are charts.
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
    QTimer soon_;  // Delays the computation, so that dragging a slider starts only one.
    ProgressJob* job_;
};

}  // namespace vitrine::ui
