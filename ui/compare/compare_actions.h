#pragma once

#include "ui/compare/compare_mode.h"

#include <QList>
#include <QObject>

#include <array>
#include <utility>
#include <vector>

class QAction;
class QMenu;

namespace vitrine::ui {

class CompareDesk;

/// The commands of the comparison: menu, palette and bar are made of these.
class CompareActions final : public QObject {
    Q_OBJECT

public:
    explicit CompareActions(CompareDesk&);

    /// In the order of the menu; null is a separator.
    [[nodiscard]] const QList<QAction*>& all() const { return all_; }
    [[nodiscard]] QAction& mode(CompareMode mode) const { return *modes_.at(static_cast<std::size_t>(mode)); }
    /// "Selected preset as B": for the list of presets, too.
    [[nodiscard]] QAction* preset() const { return preset_; }
    [[nodiscard]] QAction& otherAlone() const { return *otherAlone_; }
    [[nodiscard]] QAction& swap() const { return *swap_; }
    [[nodiscard]] QAction& takeAll() const { return *takeAll_; }
    [[nodiscard]] QAction& giveAll() const { return *giveAll_; }
    [[nodiscard]] QAction& letGo() const { return *letGo_; }
    /// Where B may come from: what is on show, a preset, a file, an undo step. Filled when it opens.
    [[nodiscard]] QMenu& sources() const { return *sources_; }

    /// Shows what is held and how it is shown.
    void refresh();
    /// Lists what the visited subject offers to be compared with.
    void refreshOffers();

private:
    QAction* add(const QString& text, const QKeySequence&, const QString& tip);
    /// Gives each an id, by which the visitor's own shortcuts are kept.
    void nameAll();
    void addSources();
    void addOffers();
    void addModes();
    void fillSources();

    CompareDesk& desk_;
    QList<QAction*> all_;
    QAction* hold_ = nullptr;
    QAction* preset_ = nullptr;
    QAction* file_ = nullptr;
    QAction* step_ = nullptr;
    std::vector<std::pair<std::size_t, QAction*>> offers_;  // With the subject that offers it.
    std::array<QAction*, 6> modes_{};                       // By mode; that of `off` is null.
    QAction* otherAlone_ = nullptr;
    QAction* swap_ = nullptr;
    QAction* takeAll_ = nullptr;
    QAction* giveAll_ = nullptr;
    QAction* letGo_ = nullptr;
    QMenu* sources_ = nullptr;
};

}  // namespace vitrine::ui
