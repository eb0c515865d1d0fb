#pragma once

#include <QObject>
#include <QTimer>

namespace vitrine::ui {

class Viewport;

/// Returns free heap pages to the system some seconds after the last picture, on the render thread. Released pictures,
/// files and programs leave such pages, which the allocator would keep.
class HeapTrimmer final : public QObject {
    Q_OBJECT

public:
    /// The viewport must outlive this object.
    HeapTrimmer(Viewport&, QObject* parent);

private:
    QTimer rest_;
};

}  // namespace vitrine::ui
