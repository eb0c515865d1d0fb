#include "ui/window/heap_trimmer.h"

#include "render/measure/memory.h"
#include "ui/viewport/viewport.h"

namespace vitrine::ui {
namespace {

constexpr int restBeforeTrimming = 5000;  // Milliseconds after the last picture.

}  // namespace

HeapTrimmer::HeapTrimmer(Viewport& viewport, QObject* parent) : QObject(parent)
{
    rest_.setSingleShot(true);
    rest_.setInterval(restBeforeTrimming);
    connect(&rest_, &QTimer::timeout, this, [&viewport] {
        viewport.renderThread().post([] {
            render::trimHeap();
            return std::function<void()>();
        });
    });
    connect(&viewport, &Viewport::drawn, &rest_, qOverload<>(&QTimer::start));
}

}  // namespace vitrine::ui

#include "moc_heap_trimmer.cpp"
