#pragma once

#include <QObject>
#include <QPointer>

class QFocusFrame;

namespace vitrine::ui {

/// Shows around lists, trees, tables, texts and other areas that scroll that they have the focus, when it came by the
/// keyboard. All other controls show it in their own edge.
class FocusRing final : public QObject {
    Q_OBJECT

public:
    explicit FocusRing(QObject* parent);
    ~FocusRing() override;

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    QPointer<QFocusFrame> frame_;  ///< Deleted with the window that it is in.
};

}  // namespace vitrine::ui
