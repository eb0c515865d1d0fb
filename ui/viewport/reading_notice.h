#pragma once

#include "render/files/asset_store.h"

#include <QElapsedTimer>
#include <QTimer>

#include <functional>
#include <vector>

namespace vitrine::ui {

class Overlay;

/// Says over the picture which files are being read for it, how large they are and for how long that has been going on.
class ReadingNotice final : public QObject {
    Q_OBJECT

public:
    /// `pending`: what is still to be read or made, asked for again and again while anything is.
    ReadingNotice(QWidget* viewport, std::function<std::vector<render::PendingAsset>()> pending);

    /// Something is pending.
    void start();
    /// After the viewport's size changed.
    void place();

private:
    void look();

    std::function<std::vector<render::PendingAsset>()> pending_;
    Overlay* words_;
    QTimer timer_;
    QElapsedTimer since_;
};

}  // namespace vitrine::ui
