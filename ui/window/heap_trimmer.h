#pragma once

#include <QObject>
#include <QTimer>

namespace vitrine::ui {

class Viewport;

/// Gives the heap's free pages back to the system some seconds after the last picture, on the render thread: pictures,
/// files and programs that were let go leave holes, which a rest of any length kept before.
class HeapTrimmer final : public QObject {
    Q_OBJECT

public:
    /// The viewport must outlive it.
    HeapTrimmer(Viewport&, QObject* parent);

private:
    QTimer rest_;
};

}  // namespace vitrine::ui
