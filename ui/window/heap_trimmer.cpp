#include "ui/window/heap_trimmer.h"

#include "render/measure/memory.h"
#include "ui/viewport/renderers.h"
#include "ui/viewport/viewport.h"

namespace vitrine::ui {
namespace {

// Milliseconds after the last picture.
constexpr int restBeforeTrimming = 5000;
constexpr int restBeforeReleasing = 30000;

}  // namespace

HeapTrimmer::HeapTrimmer(Viewport& viewport, Renderers& renderers, QObject* parent) : QObject(parent)
{
    rest_.setInterval(restBeforeTrimming);
    longRest_.setInterval(restBeforeReleasing);
    connect(&rest_, &QTimer::timeout, this, [&viewport] {
        viewport.renderThread().post([] {
            render::trimHeap();
            return std::function<void()>();
        });
    });
    connect(&longRest_, &QTimer::timeout, this, [&viewport, &renderers] {
        viewport.renderThread().post([&renderers] {
            renderers.releaseUnused();
            render::trimHeap();
            return std::function<void()>();
        });
    });
    for (QTimer* timer : {&rest_, &longRest_}) {
        timer->setSingleShot(true);
        connect(&viewport.pictures(), &ViewportPictures::drawn, timer, qOverload<>(&QTimer::start));
    }
}

}  // namespace vitrine::ui

#include "moc_heap_trimmer.cpp"
