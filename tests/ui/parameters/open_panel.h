#pragma once

#include "tests/ui/sample_tables.h"

#include "ui/kit/theme.h"
#include "ui/model/history.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/value_slider.h"

#include <QApplication>
#include <QMenu>
#include <QTest>
#include <QWheelEvent>

#include <clocale>
#include <memory>

namespace vitrine::test {

/// Test of the parameter panel over a table with a parameter of every kind.
class OpenPanel : public QObject {
protected:
    const SampleTable table_{};
    const IdleTable idle_{};
    const EssentialTable essentials_{};
    std::unique_ptr<ui::History> history_;
    std::unique_ptr<ui::ParameterPanel> panel_;

    [[nodiscard]] const ParameterValues& values() const { return history_->sceneState().values[0]; }
    template <typename T> T* in(std::string_view row) { return panel_->row(row)->findChild<T*>(); }
    ui::NumberField* field(std::string_view row) { return in<ui::NumberField>(row); }
    ui::ValueSlider* slider(std::string_view row) { return in<ui::ValueSlider>(row); }
    ui::ResetDot* dot(std::string_view row) { return in<ui::ResetDot>(row); }
    static void wheel(QWidget* widget, int delta)
    {
        const QPointF at = QRectF(widget->rect()).center();
        QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(widget, &event);
    }
    void type(std::string_view row, const QString& text)
    {
        QTest::mouseClick(field(row), Qt::LeftButton);
        QTest::keyClicks(field(row), text);
        QTest::keyClick(field(row), Qt::Key_Return);
    }
    void drag(QWidget* widget, QPoint from, int pixels, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(widget, Qt::LeftButton, modifiers, from);
        const int sign = pixels < 0 ? -1 : 1;
        for (int x = 0; x != pixels + sign; x += sign) {
            QMouseEvent move(QEvent::MouseMove, from + QPoint(x, 0), widget->mapToGlobal(QPointF(from) + QPointF(x, 0)),
                             Qt::NoButton, Qt::LeftButton, modifiers);
            QApplication::sendEvent(widget, &move);
        }
    }
    void showIdleTable() { history_->restart(SceneState{{idle_.initial()}, {}}); }
    void showEssentialTable() { history_->restart(SceneState{{essentials_.initial()}, {}}); }
    static void prepare()
    {
        std::setlocale(LC_NUMERIC, "C");
        ui::applyTheme(*qApp, ui::darkTheme());
    }
    void open()
    {
        history_ = std::make_unique<ui::History>(SceneState{{table_.initial()}, {}});
        panel_ = std::make_unique<ui::ParameterPanel>(*history_);
        panel_->showExhibit(0, "sample");
        panel_->resize(360, 400);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get(), patience));
        panel_->activateWindow();
    }
    /// Returns the contrast of a parameter's label: the largest difference from its background, 0 to 255.
    [[nodiscard]] int ink(ui::ParameterRow* row)
    {
        const QImage seen = row->findChild<ui::RowLabel*>()->grab().toImage();
        const int back = qGray(seen.pixel(seen.width() - 1, 0));
        int most = 0;
        for (int y = 0; y < seen.height(); ++y)
            for (int x = 0; x < seen.width(); ++x) most = std::max(most, std::abs(qGray(seen.pixel(x, y)) - back));
        return most;
    }
    /// Chooses an entry of the parameter's menu.
    void choose(std::string_view row, const char* entry)
    {
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, panel_->row(row)->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(panel_->row(row), &event);
        auto* menu = panel_->findChildren<QMenu*>().constLast();
        for (QAction* action : menu->actions())
            if (action->text() == QLatin1String(entry)) action->trigger();
        menu->close();
    }
    void release(QWidget* widget, QPoint at) { QTest::mouseRelease(widget, Qt::LeftButton, {}, at); }
};

}  // namespace vitrine::test
