#pragma once

#include "exhibits/printing/print_views.h"
#include "ui/kit/progress_job.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace vitrine::ui {

class ShownViews;

/// Loads the views of a print: reads pictures, or renders them from the window's picture. Rendered views are small
/// drafts at first, and full-size for the print.
class ViewLoader final : public QObject {
    Q_OBJECT

public:
    /// `shown` renders views of the window's picture; this object owns it. Null if there is no such window.
    ViewLoader(ShownViews* shown, QObject* parent);

    /// Loads the views of these settings, which replace the present ones.
    void load(const ParameterValues&);
    /// Sets whether a print of the views can be made. Views are rendered only then.
    void setPossible(bool);
    /// Renders the views of the last `load` at the size of the print. Emits `readyForPrint` or `failed`.
    void renderInFull();
    void stop();

    /// Returns the views; null until there are any.
    [[nodiscard]] const std::shared_ptr<const printing::PrintViews>& views() const { return views_; }
    /// Returns the depth of rendered views.
    [[nodiscard]] const std::optional<printing::SceneDepth>& depth() const { return depth_; }
    /// Returns whether the views have the size of the print, and are no drafts.
    [[nodiscard]] bool inFull() const { return views_ && !draft_; }
    [[nodiscard]] bool reading() const { return read_.running(); }
    [[nodiscard]] bool busy() const;

signals:
    /// Emitted with a status: "16 views", the progress, or why there are none.
    void said(const QString&);
    /// Emitted when the views were replaced or removed.
    void changed();
    void readyForPrint();
    /// Emitted while rendering for the print. `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    void failed(const QString& why);

private:
    void connectShown();
    void read();
    void take(std::shared_ptr<const printing::PrintViews>, const std::optional<printing::SceneDepth>&, bool draft);
    [[nodiscard]] bool fromWindow() const;

    ParameterValues values_ = printing::printTable().initial();
    std::shared_ptr<const printing::PrintViews> views_;
    std::optional<printing::SceneDepth> depth_;
    bool draft_ = false;   ///< The views are small drafts.
    bool full_ = false;    ///< The rendering that runs is for the print.
    bool wanted_ = false;  ///< Whether to render the views as soon as the print is possible.
    bool possible_ = false;

    ShownViews* shown_;
    ProgressJob read_;
    QTimer soon_;  ///< Delays loading while a slider moves.
};

}  // namespace vitrine::ui
