#pragma once

#include "render/files/asset_store.h"

#include <QElapsedTimer>
#include <QTimer>

#include <functional>
#include <vector>

namespace vitrine::ui {

class Overlay;

/// Notice over the picture: names the files that are being read for it, their sizes and the time so far.
class ReadingNotice final : public QObject {
    Q_OBJECT

public:
    /// `pending` returns the files that are still to be read or made. It is polled while there are any.
    ReadingNotice(QWidget* viewport, std::function<std::vector<render::PendingAsset>()> pending);

    /// Starts polling, because something is pending.
    void start();
    /// Places the notice. Call after the viewport's size changed.
    void place();

private:
    void look();

    std::function<std::vector<render::PendingAsset>()> pending_;
    Overlay* words_;
    QTimer timer_;
    QElapsedTimer since_;
};

}  // namespace vitrine::ui
