#include "ui/kit/type_size.h"

#include <QBoxLayout>
#include <QEvent>
#include <QFontMetrics>
#include <QScreen>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr double usualHeight =
    15;  // Line height in pixels of the font for which the window was laid out: 9 points at 96 dpi.

class TypeFollower final : public QObject {
public:
    TypeFollower(QWidget& widget, std::function<void()> work) : QObject(&widget), work_(std::move(work))
    {
        widget.installEventFilter(this);
        work_();
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (watched == parent() && event->type() == QEvent::FontChange) work_();
        return false;
    }

private:
    std::function<void()> work_;
};

}  // namespace

int grown(int pixels, const QFontMetrics& metrics)
{
    return static_cast<int>(std::lround(pixels * std::max(1.0, metrics.height() / usualHeight)));
}

int grown(int pixels, const QWidget& widget)
{
    return grown(pixels, widget.fontMetrics());
}

void followType(QWidget& widget, std::function<void()> work)
{
    new TypeFollower(widget, std::move(work));
}

void growHeight(QWidget& widget, int fixed)
{
    followType(widget, [&widget, fixed] { widget.setFixedHeight(grown(fixed, widget)); });
}

void growWidth(QWidget& widget, int fixed)
{
    followType(widget, [&widget, fixed] { widget.setFixedWidth(grown(fixed, widget)); });
}

void growWidth(QWidget& widget, int fixed, int mostOfScreen)
{
    followType(widget, [&widget, fixed, mostOfScreen] {
        const int most = widget.screen()->availableSize().width() * mostOfScreen / 100;
        widget.setFixedWidth(std::min(grown(fixed, widget), std::max(fixed, most)));
    });
}

void growSize(QWidget& widget, int fixedWidth, int fixedHeight)
{
    growWidth(widget, fixedWidth);
    growHeight(widget, fixedHeight);
}

void growMinimumWidth(QWidget& widget, int least)
{
    followType(widget, [&widget, least] { widget.setMinimumWidth(grown(least, widget)); });
}

void growMinimumSize(QWidget& widget, int leastWidth, int leastHeight)
{
    followType(widget, [&widget, leastWidth, leastHeight] {
        widget.setMinimumSize(grown(leastWidth, widget), grown(leastHeight, widget));
    });
}

bool isLargeType(const QWidget& widget)
{
    constexpr int largest = 130;  // Percent of the usual font size up to which one line is enough.
    return grown(100, widget) > largest;
}

void stackWhenLarge(QBoxLayout& row, QWidget& widget)
{
    followType(widget, [&row, &widget] {
        row.setDirection(isLargeType(widget) ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    });
}

}  // namespace vitrine::ui
