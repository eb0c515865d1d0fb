#pragma once

#include <QObject>
#include <QPointer>

class QFocusFrame;

namespace vitrine::ui {

/// Draws a ring around scrolling areas (lists, trees, tables, texts) that got the focus by keyboard. All other controls
/// show the focus in their own edge.
class FocusRing final : public QObject {
    Q_OBJECT

public:
    explicit FocusRing(QObject* parent);
    ~FocusRing() override;

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    QPointer<QFocusFrame> frame_;  ///< Deleted with its window.
};

}  // namespace vitrine::ui
