#pragma once

#include "render/files/asset_store.h"

#include <functional>
#include <memory>
#include <vector>

class QString;
class QWidget;

namespace vitrine::ui {

class Overlay;
class ReadingNotice;

/// Texts over the picture. Empty text hides a notice.
class ViewportNotices {
public:
    /// `pending` returns the files that are still to be read for the picture.
    ViewportNotices(QWidget* viewport, std::function<std::vector<render::PendingAsset>()> pending);
    ~ViewportNotices();

    /// Hint of the first start.
    void sayHint(const QString&);
    /// Destination, until its picture is shown.
    void sayDestination(const QString&);
    /// Button that the visitor looks at.
    void sayButton(const QString&);
    void sayShaderProblems(const QString&);
    /// Starts to name the files that are being read.
    void startReading();
    /// Places all notices. Call after the viewport's size changed.
    void place();

private:
    Overlay* hint_;
    Overlay* destination_;
    Overlay* button_;
    Overlay* problems_;
    std::unique_ptr<ReadingNotice> reading_;
};

}  // namespace vitrine::ui
