#pragma once

#include <QObject>
#include <QTimer>

namespace vitrine::ui {

class Renderers;
class Viewport;

/// Returns memory to the system after the last picture, on the render thread. After some seconds: free heap pages,
/// which released pictures, files and programs leave and the allocator would keep. After half a minute: also what is
/// kept only because it may be needed again.
class HeapTrimmer final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    HeapTrimmer(Viewport&, Renderers&, QObject* parent);

private:
    QTimer rest_, longRest_;
};

}  // namespace vitrine::ui
