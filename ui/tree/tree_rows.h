#pragma once

#include "exhibits/framework/scene/tree.h"
#include "ui/model/value_ref.h"

#include <QWidget>

#include <optional>
#include <string_view>
#include <vector>

class QLabel;
class QScrollArea;

namespace vitrine::ui {

class ParameterRow;
class ParameterSection;
class TreeEditor;

/// Numbers of the selected node, each with a slider.
class TreeRowsView final : public QWidget, private ValueOwner {
    Q_OBJECT

public:
    /// The editor must outlive the view.
    explicit TreeRowsView(TreeEditor&, QWidget* parent = nullptr);

    /// Returns the control of a number; null if the selected node has none of this name.
    [[nodiscard]] ParameterRow* row(std::string_view name) const;

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    [[nodiscard]] const ParameterValues& currentValues() const override { return values_.value(); }
    void setValue(std::size_t row, const Value&, Gesture, const QString& text) override;
    void refresh();
    void rebuild();

    TreeEditor& editor_;
    std::optional<ParameterValues> values_;  ///< Values under the table from which the controls were made.
    QScrollArea* scroll_;
    QLabel* note_;
    std::vector<ParameterRow*> rows_;
    std::vector<ParameterSection*> sections_;
};

}  // namespace vitrine::ui
