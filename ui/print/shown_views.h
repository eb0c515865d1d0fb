#pragma once

#include "exhibits/printing/print_views.h"
#include "ui/viewport/gallery.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace vitrine::ui {

class Workbench;

/// Renders the views of a print from what the window shows, step by step between the window's other work.
class ShownViews final : public QObject {
    Q_OBJECT

public:
    ShownViews(Workbench&, QObject* parent);
    ~ShownViews() override;

    /// From where the visitor stands now; stops what was being rendered.
    void start(const ParameterValues&, bool draft);
    void stop();
    [[nodiscard]] bool running() const { return timer_.isActive(); }

signals:
    /// `part` is 0 to 1; `secondsLeft` is negative while unknown.
    void progressed(double part, double secondsLeft);
    void finished(std::shared_ptr<const vitrine::printing::PrintViews> views, const vitrine::printing::SceneDepth& depth);
    void failed(const QString& why);

private:
    void step();
    void begin(std::size_t picture);
    void take();
    void fail(const QString& why);

    Workbench& window_;
    std::optional<ParameterValues> values_;
    std::vector<printing::ViewShot> pictures_;  ///< The quick one for depth, then the views.
    std::size_t next_ = 0;
    std::shared_ptr<printing::PrintViews> views_;
    printing::SceneDepth depth_;
    PictureJob job_;
    QTimer timer_;
    QElapsedTimer elapsed_;
};

}  // namespace vitrine::ui
