#pragma once

#include "exhibits/printing/print_views.h"
#include "ui/kit/progress_job.h"
#include "ui/print/print_setup.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace vitrine::ui {

class ShownViews;

/// Gets the views of a print: reads pictures, or renders what the window shows, small at first and in full for the
/// print.
class ViewLoader final : public QObject {
    Q_OBJECT

public:
    /// `shown` renders views of what the window shows; taken over, and null where there is no such window.
    ViewLoader(ShownViews* shown, QObject* parent);

    /// Gets the views that this asks for, in place of those before.
    void load(const PrintState&);
    /// Views are rendered as soon as a print of them can be made.
    void setPossible(bool);
    /// Renders the views of the last `load` as large as the print takes them; `readyForPrint` follows, or `failed`.
    void renderInFull();
    void stop();

    /// Null until there are any.
    [[nodiscard]] const std::shared_ptr<const printing::PrintViews>& views() const { return views_; }
    /// Of rendered views.
    [[nodiscard]] const std::optional<printing::SceneDepth>& depth() const { return depth_; }
    /// The views are those of the print, and not small ones to look at.
    [[nodiscard]] bool inFull() const { return views_ && !draft_; }
    [[nodiscard]] bool reading() const { return read_.running(); }
    [[nodiscard]] bool busy() const;

signals:
    /// "16 views", how far it is, or why there are none.
    void said(const QString&);
    /// Other views, or none.
    void changed();
    void readyForPrint();
    /// Of rendering in full: `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    void failed(const QString& why);

private:
    void connectShown();
    void read();
    void take(std::shared_ptr<const printing::PrintViews>, const std::optional<printing::SceneDepth>&, bool draft);
    [[nodiscard]] bool fromWindow() const;

    PrintState state_;
    std::shared_ptr<const printing::PrintViews> views_;
    std::optional<printing::SceneDepth> depth_;
    bool draft_ = false;   ///< The views are small ones, to look at.
    bool full_ = false;    ///< What is being rendered is for the print.
    bool wanted_ = false;  ///< To be rendered as soon as the print is possible.
    bool possible_ = false;

    ShownViews* shown_;
    ProgressJob read_;
    QTimer soon_;  ///< Not at every step of a slider.
};

}  // namespace vitrine::ui
