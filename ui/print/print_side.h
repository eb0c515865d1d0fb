#pragma once

#include <QWidget>

class QTabBar;

namespace vitrine::ui {

class ParameterPanel;
class PrintSetup;
class SheetBar;
class SourceBar;

/// Left column of the print dialog: print or chart, the origin of the views, the lens sheet, and the parameters.
class PrintSide final : public QWidget {
    Q_OBJECT

public:
    /// `canShow`: views can be rendered from the window's picture. The setup must outlive it.
    PrintSide(bool canShow, PrintSetup&, QWidget* parent);

    [[nodiscard]] SourceBar& source() { return *source_; }
    [[nodiscard]] SheetBar& sheets() { return *sheets_; }
    /// Shows the tab and the parameters of the print or of the chart, as far as they have an effect.
    void showChart(bool chart);

signals:
    void chartChosen(bool chart);

private:
    [[nodiscard]] QTabBar* makeTabs();

    PrintSetup& setup_;
    QTabBar* tabs_;
    SourceBar* source_;
    SheetBar* sheets_;
    ParameterPanel* panel_;
};

}  // namespace vitrine::ui
