#include "ui/compare/compare_actions.h"

#include "exhibits/museum/museum.h"
#include "ui/compare/compare_controller.h"
#include "ui/compare/compare_overlay.h"
#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/model/settings_b.h"
#include "ui/model/workbench.h"

#include <QAction>
#include <QCursor>
#include <QMenu>
#include <QUndoStack>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int mostSteps = 20;  ///< Number of undo steps in the menu, the last ones.

struct ModeWords {
    CompareMode mode;
    const char* id;
    const char* text;
    const char* tip;
};

constexpr std::array<ModeWords, 5> modeWords{
    {{CompareMode::wipe, "compare-wipe", QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "&Wipe"),
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "A to the left of a line, B to the right; drag the line. If "
                                                       "there is no B yet, the current settings become B.")},
     {CompareMode::sideBySide, "compare-side-by-side",
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "Side by &side"),
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "Whole pictures of A and B, side by side.")},
     {CompareMode::flicker, "compare-flicker", QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "A/B &flicker"),
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions",
                        "A, with B kept ready: hold the key B in the picture to see it.")},
     {CompareMode::flip, "compare-flip", QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "FLI&P"),
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions",
                        "Difference that an eye sees when flipping between A and B: black is none, white is large.")},
     {CompareMode::signedDifference, "compare-signed-difference",
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions", "Signed &difference"),
      QT_TRANSLATE_NOOP("vitrine::ui::CompareActions",
                        "Difference of B and A: gray where both are equal, brighter or darker where B is.")}}};

}  // namespace

CompareActions::CompareActions(CompareController& controller) : QObject(&controller), controller_(controller)
{
    addSources();
    all_ << nullptr;
    addOffers();
    all_ << nullptr;
    addModes();
    all_ << nullptr;
    swap_ = add(tr("Sw&ap A and B"), {},
                tr("Exchanges A and B: B is shown and can be edited, and the current settings become B."));
    takeAll_ = add(tr("Copy all fro&m B"), {}, tr("Copies all settings of B to A. Can be undone."));
    giveAll_ = add(tr("Copy all &to B"), {}, tr("Copies all settings of A to B. Can be undone."));
    letGo_ = add(tr("&End the comparison"), {}, tr("Ends the comparison and shows A alone."));
    nameAll();
    connect(swap_, &QAction::triggered, this, [this] { controller_.other().swap(); });
    connect(takeAll_, &QAction::triggered, this, [this] { controller_.other().takeAll(); });
    connect(giveAll_, &QAction::triggered, this, [this] { controller_.other().giveAll(); });
    connect(letGo_, &QAction::triggered, this, [this] { controller_.letGo(); });
    refresh();
}

QAction* CompareActions::add(const QString& text, const QKeySequence& key, const QString& tip)
{
    auto* action = new QAction(text, this);
    action->setShortcut(key);
    action->setStatusTip(tip);
    const auto showKey = [action, tip] {
        const QKeySequence now = action->shortcut();
        action->setToolTip(now.isEmpty() ? tip : tr("%1 (%2)").arg(tip, now.toString(QKeySequence::NativeText)));
    };
    showKey();
    connect(action, &QAction::changed, this, showKey);  // The visitor may change the shortcut.
    all_ << action;
    return action;
}

void CompareActions::nameAll()
{
    for (const auto& [action, id] :
         {std::pair(hold_, "hold"), std::pair(preset_, "preset"), std::pair(file_, "file"), std::pair(step_, "step"),
          std::pair(otherAlone_, "other-alone"), std::pair(swap_, "swap"), std::pair(takeAll_, "take-all"),
          std::pair(giveAll_, "give-all"), std::pair(letGo_, "end")})
        action->setObjectName(QStringLiteral("compare-") + QLatin1String(id));
    for (const ModeWords& words : modeWords) mode(words.mode).setObjectName(QLatin1String(words.id));
}

void CompareActions::addSources()
{
    hold_ = add(tr("&Hold the current settings as B"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_B),
                tr("Sets B to the current values of all parameters; edit A further and compare."));
    preset_ = add(tr("Selected p&reset as B"), {}, tr("Sets B to the preset selected in the list."));
    file_ = add(tr("&Open as B…"), {}, tr("Sets B to a preset, an exhibition, or the settings inside a picture."));
    step_ = add(tr("&Undo step as B…"), {}, tr("Sets B to the parameters before or after an edit."));
    connect(hold_, &QAction::triggered, this, [this] { controller_.setToCurrent(); });
    connect(preset_, &QAction::triggered, this, [this] { controller_.holdSelectedPreset(); });
    connect(file_, &QAction::triggered, this, [this] { controller_.chooseFile(); });
    connect(step_, &QAction::triggered, this, [this] {
        fillSources();
        for (QAction* action : sources_->actions())
            if (action->menu() && action->menu()->objectName() == QLatin1String("steps"))
                action->menu()->popup(QCursor::pos());
    });
    for (QAction* source : {preset_, file_, step_}) {
        all_.removeOne(source);
        more_ << source;
    }
    sources_ = new QMenu(tr("Ta&ke B from"), controller_.window());
    sources_->setAccessibleName(tr("Where B comes from"));
    connect(sources_, &QMenu::aboutToShow, this, &CompareActions::fillSources);
}

void CompareActions::addOffers()
{
    const Museum& museum = controller_.workbench().museum();
    for (std::size_t subject = 0; subject < museum.subjects().size(); ++subject)
        for (const OfferedComparison& offered : compare::offeredComparisons(museum.subject(subject))) {
            QAction* action = add(tr("Compare with: %1").arg(menuText(translatedText(offered.title))), {},
                                  tr("%1 B follows the current settings; drag the line between the two.")
                                      .arg(translatedText(offered.help)));
            action->setObjectName(
                QStringLiteral("compare-%1-with-%2")
                    .arg(QString::fromUtf8(museum.subject(subject).name()), QString::fromStdString(offered.name)));
            connect(action, &QAction::triggered, this,
                    [this, subject, offered] { controller_.compareWith(subject, offered); });
            offers_.emplace_back(subject, action);
        }
    refreshOffers();
}

void CompareActions::refreshOffers()
{
    const std::size_t chosen = controller_.workbench().chosen();
    for (const auto& [subject, action] : offers_) {
        action->setVisible(subject == chosen);
        action->setEnabled(subject == chosen);
    }
}

QAction* CompareActions::firstOffer() const
{
    const std::size_t chosen = controller_.workbench().chosen();
    for (const auto& [subject, action] : offers_)
        if (subject == chosen) return action;
    return nullptr;
}

void CompareActions::addModes()
{
    for (const ModeWords& words : modeWords) {
        const QKeySequence key = words.mode == CompareMode::wipe ? QKeySequence(Qt::CTRL | Qt::Key_W) : QKeySequence();
        QAction* action = add(tr(words.text), key, tr(words.tip));
        action->setCheckable(true);
        modes_.at(static_cast<std::size_t>(words.mode)) = action;
        connect(action, &QAction::triggered, this,
                [this, mode = words.mode](bool on) { controller_.setMode(on ? mode : CompareMode::off); });
    }
    otherAlone_ =
        add(tr("Show B a&lone"), {}, tr("Shows B instead of A. Holding the key B in the picture does the same."));
    otherAlone_->setCheckable(true);
    connect(otherAlone_, &QAction::triggered, this, [this](bool on) { controller_.overlay().setOtherAlone(on); });
}

void CompareActions::fillSources()
{
    for (QMenu* menu : sources_->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly)) menu->deleteLater();
    sources_->clear();
    sources_->addAction(hold_);
    for (const auto& [subject, action] : offers_)
        if (action->isVisible()) sources_->addAction(action);
    QMenu* presets = sources_->addMenu(tr("&Preset"));
    for (const auto& [name, id] : controller_.presets())
        presets->addAction(menuText(name), this, [this, id = id] { controller_.holdFile(id); });
    presets->setEnabled(!presets->isEmpty());
    QMenu* steps = sources_->addMenu(tr("&Undo step"));
    steps->setObjectName(QStringLiteral("steps"));
    const QUndoStack& stack = controller_.steps();
    const int last = stack.count();
    for (int step = last; step >= std::max(0, last - mostSteps); --step) {
        const QString what = step == 0 ? tr("At the start") : tr("After “%1”").arg(stack.text(step - 1));
        steps->addAction(menuText(step == stack.index() ? tr("%1 (current)").arg(what) : what), this,
                         [this, step, what] { controller_.holdStep(step, what); });
    }
    sources_->addAction(file_);
    sources_->addSeparator();
    sources_->addAction(takeAll_);
    sources_->addAction(giveAll_);
}

void CompareActions::refresh()
{
    const bool held = controller_.other().isSet();
    for (QAction* action : {otherAlone_, swap_, takeAll_, giveAll_, letGo_}) action->setEnabled(held);
    for (const CompareMode mode : compareModes) this->mode(mode).setChecked(controller_.overlay().mode() == mode);
    otherAlone_->setChecked(held && controller_.overlay().otherAlone());
}

}  // namespace vitrine::ui

#include "moc_compare_actions.cpp"
