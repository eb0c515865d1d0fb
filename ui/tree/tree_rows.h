#pragma once

#include "exhibits/framework/tree.h"
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

/// The numbers of the selected node, each with its slider.
class TreeRowsView final : public QWidget, private ValueHolder {
    Q_OBJECT

public:
    /// The editor must outlive it.
    explicit TreeRowsView(TreeEditor&, QWidget* parent = nullptr);

    /// Null where the selected node has none of this name.
    [[nodiscard]] ParameterRow* row(std::string_view name) const;

protected:
    bool eventFilter(QObject*, QEvent*) override;

private:
    [[nodiscard]] const ParameterValues& heldValues() const override { return values_.value(); }
    void hold(std::size_t row, const Value&, Gesture, const QString& text) override;
    void refresh();
    void rebuild();

    TreeEditor& editor_;
    std::optional<ParameterValues> values_;  ///< Under the table that the controls were made of.
    QScrollArea* scroll_;
    QLabel* note_;
    std::vector<ParameterRow*> rows_;
    std::vector<ParameterSection*> sections_;
};

}  // namespace vitrine::ui
