#pragma once

#include "exhibits/printing/print_plan.h"
#include "exhibits/printing/print_preview.h"
#include "exhibits/printing/print_views.h"
#include "ui/print/newest_job.h"

#include <QObject>

#include <filesystem>
#include <memory>

namespace vitrine::ui {

/// Computes the preview and the numbers of a print on other threads, for the newest settings.
class PrintPlanner final : public QObject {
    Q_OBJECT

public:
    /// Settings that are previewed and counted.
    struct Request {
        ParameterValues values;      ///< Settings of the print or of the chart.
        std::filesystem::path file;  ///< Output.
        bool chart = false;
        std::shared_ptr<const printing::PrintViews> views;    ///< Views of the preview; null: none.
        std::shared_ptr<const printing::PrintViews> counted;  ///< Views of the numbers; null: as many as are set.
    };

    explicit PrintPlanner(QObject* parent);

    void refresh(const Request&);
    [[nodiscard]] const printing::PrintPlan& plan() const { return plan_; }
    /// Returns whether the preview and the numbers are those of the last request.
    [[nodiscard]] bool settled() const { return asked_ == shown_ && !preview_.busy(); }

signals:
    /// Emitted with a new preview, null if there is none, and its viewing distance in meters.
    void previewed(const std::shared_ptr<const vitrine::printing::PrintPreview>& preview, double distance);
    /// Emitted when `plan` is new.
    void planned();
    void failed(const QString& why);

private:
    void preview(const Request&);
    void count(const Request&);

    printing::PrintPlan plan_;
    int asked_ = 0, shown_ = 0;  ///< Numbers of the last request and of the one that `plan_` belongs to.
    NewestJob preview_, count_;  ///< Two jobs: the numbers take longer with many views.
};

}  // namespace vitrine::ui
