#include "ui/parameters/parameter_panel.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/framework/time/animation.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/controlled_parameters.h"
#include "ui/parameters/group_edits.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/panel_choices.h"
#include "ui/parameters/parameter_menus.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/parameter_section.h"
#include "ui/parameters/value_slider.h"
#include "ui/parameters/way_to_act.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
ParameterPanel::ParameterPanel(History& history, QWidget* parent)
    : QWidget(parent), history_(history), onlyChanged_(new QToolButton(this)), scroll_(new QScrollArea(this)),
      nothing_(new QLabel(tr("All parameters have their initial values."), this)), choices_(new PanelChoices(this)),
      menus_(new ParameterMenus(history, *this, *choices_))
{
    onlyChanged_->setText(tr("Changed"));
    onlyChanged_->setAccessibleName(tr("Only changed"));
    onlyChanged_->setToolTip(tr("Shows only parameters whose value is not the initial one."));
    onlyChanged_->setCheckable(true);
    growHeight(*onlyChanged_, 26);
    onlyChanged_->setFocusPolicy(Qt::StrongFocus);
    nothing_->setTextFormat(Qt::PlainText);
    nothing_->setWordWrap(true);
    nothing_->setMargin(16);
    nothing_->setEnabled(false);
    nothing_->hide();
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll_->setFocusPolicy(Qt::NoFocus);

    auto* top = new QHBoxLayout;
    top->setContentsMargins(8, 8, 8, 8);
    top->setSpacing(8);
    top->addStretch(1);
    top->addWidget(onlyChanged_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(top);
    layout->addWidget(nothing_);
    layout->addWidget(scroll_, 1);
    setMinimumWidth(leastWidth);

    connect(onlyChanged_, &QToolButton::toggled, this, &ParameterPanel::showOnlyWanted);
    connect(choices_, &PanelChoices::changed, this, &ParameterPanel::showChoice);
    connect(menus_, &ParameterMenus::accuracyAsked, this, &ParameterPanel::accuracyAsked);
    connect(menus_, &ParameterMenus::groupsChanged, this, &ParameterPanel::showGroups);
    connect(menus_, &ParameterMenus::foldingAsked, this, &ParameterPanel::foldAll);
    watch();
}

void ParameterPanel::showController(const QString& key)
{
    const QString exhibit = name_ + QLatin1Char('/');
    const ControlledParameters* controllers = menus_->controllers();
    if (!controllers || !table_ || !key.startsWith(exhibit)) return;
    if (ParameterRow* shown = row(key.mid(exhibit.size()).toStdString())) shown->setController(controllers->note(key));
}

void ParameterPanel::showControllers()
{
    for (std::size_t i = 0; i < rows_.size(); ++i) showController(keyOf(i));
}

void ParameterPanel::setHeading(QWidget* heading)
{
    auto* top = static_cast<QHBoxLayout*>(layout()->itemAt(0)->layout());
    top->setContentsMargins(0, 8, 8, 8);
    delete top->takeAt(0);
    top->insertWidget(0, heading, 1);
}

void ParameterPanel::watch()
{
    disconnect(watched_);
    watched_ =
        history_.watch(exhibit_, this, [this](std::optional<std::size_t> row) { row ? showRow(*row) : showAll(); });
}

void ParameterPanel::showExhibit(std::size_t exhibit, const QString& name)
{
    const bool another = exhibit_ != exhibit || name_ != name;
    exhibit_ = exhibit;
    name_ = name;
    watch();
    if (another) table_.reset();
    showAll();
}

void ParameterPanel::showAll()
{
    if (name_.isEmpty()) return;  // Nothing is shown yet.
    // A file that was read again gives a new table, usually with the same parameters; their controls are then kept.
    if (table_ && table_->hasParametersOf(values().table())) {
        showValues();
    } else if (table_) {
        rearrange();  // Another file of the same exhibit has other parameters.
    } else {
        rebuild();
    }
}

void ParameterPanel::showValues()
{
    for (std::size_t i = 0; i < rows_.size(); ++i) showValue(i);
    showWhatActs();
    for (ParameterSection* section : sections_) section->refresh();
}

void ParameterPanel::rearrange()
{
    const std::string focused = focusedParameter();
    const int scrolled = scroll_->verticalScrollBar()->value();
    rebuild();
    placeRows();
    if (const ParameterRow* before = row(focused)) focusIn(*before);
    scroll_->verticalScrollBar()->setValue(scrolled);
}

void ParameterPanel::placeRows()
{
    // The layout is activated first, because new rows have no position yet, and the scroll bar no range.
    content_->layout()->activate();
    content_->resize(scroll_->viewport()->width(), content_->sizeHint().height());
}

void ParameterPanel::showRow(std::size_t row)
{
    if (rows_.empty()) return;
    showValue(row);
    showWhatActs();
    sections_[groupShowing(row)]->refresh();
}

void ParameterPanel::showValue(std::size_t row)
{
    const ParameterInfo& info = values().rows()[row];
    const Motion* motion = values().motion(row);
    rows_[row]->setMotion(motion ? translatedText(describe(info, *motion)) : QString());
    rows_[row]->showValue(motion ? valueOf(info, *motion, menus_->moment()) : values().row(row));
}

void ParameterPanel::showMoment(const AnimationTime& moment)
{
    menus_->setMoment(moment);
    if (values().motions().empty()) return;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (values().motion(i)) showValue(i);
}

void ParameterPanel::showWhatActs()
{
    for (std::size_t i = 0; i < rows_.size(); ++i)
        rows_[i]->setIdle(acts(values(), i) ? QString() : QString::fromStdString(actsWhen(values(), i)));
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        if (!groups_[i].foldedAtFirst) continue;
        const std::optional<IdleGroup> idle = idleGroup(values(), groups_[i].rows);
        if (!idle) {
            sections_[i]->setIdle({}, {});
            continue;
        }
        sections_[i]->setIdle(QString::fromStdString(actsWhen(values(), idle->row)),
                              changesText(values(), idle->changes));
    }
}

void ParameterPanel::rebuild()
{
    table_ = values().sharedTable();
    rows_.assign(table_->rows().size(), nullptr);
    sections_.clear();
    groups_ = panelGroups(table_->rows(), [this](std::size_t row) { return isPinned(row); });
    content_ = new QWidget;
    auto* layout = new QVBoxLayout(content_);
    layout->setContentsMargins(0, 0, 4, 8);
    layout->setSpacing(0);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        addSection(i);
        for (const std::size_t row : groups_[i].rows) addRow(row);
    }
    layout->addStretch(1);
    showLocks();
    // Deleted later, because the sender of this call may be one of the rows that are deleted.
    if (QWidget* before = scroll_->takeWidget()) before->deleteLater();
    scroll_->setWidget(content_);
    content_->installEventFilter(this);
    makeRoom();
    orderTabs();
    showValues();
    showControllers();
    showOnlyWanted();
}

void ParameterPanel::makeRoom()
{
    // Rows are not scrolled sideways: the panel is as wide as the widest row and the scroll bar.
    const int needed = content_->minimumSizeHint().width() + scroll_->verticalScrollBar()->sizeHint().width();
    setMinimumWidth(std::max(leastWidth, needed));
}

QString ParameterPanel::titleOf(const PanelGroup& group) const
{
    switch (group.kind) {
    case PanelGroup::Kind::essentials: return tr("Essentials");
    case PanelGroup::Kind::pinned: return tr("Pinned");
    case PanelGroup::Kind::table: break;
    }
    return translatedText(group.title);
}

void ParameterPanel::addSection(std::size_t i)
{
    const PanelGroup& group = groups_[i];
    auto* section = new ParameterSection(titleOf(group), content_);
    const QString key = keyOf(group);
    connect(section, &ParameterSection::menuAsked, this,
            [this, i](const QPoint& at) { menus_->openGroup(groups_[i], sections_[i]->title(), at); });
    connect(section, &ParameterSection::foldedByVisitor, this, [this, key, atFirst = group.foldedAtFirst](bool folded) {
        choices_->set(PanelChoice::toggled, {key}, folded != atFirst);
    });
    connect(section, &ParameterSection::actAsked, this, [this, i] {
        if (const std::optional<IdleGroup> idle = idleGroup(values(), groups_[i].rows)) menus_->make(idle->changes);
    });
    section->setFolded(choices_->has(PanelChoice::toggled, key) != group.foldedAtFirst);
    sections_.push_back(section);
    content_->layout()->addWidget(section);
}

void ParameterPanel::addRow(std::size_t i)
{
    const bool ownHeading = groups_[sections_.size() - 1].kind == PanelGroup::Kind::table;
    auto* row = new ParameterRow(ValueRef(menus_->edits(), i), sections_.back(),
                                 ownHeading ? ParameterRow::Label::underHeading : ParameterRow::Label::whole);
    row->setGaugeShown(menus_->gaugesShown());
    sections_.back()->add(row);
    rows_[i] = row;
    connect(row, &ParameterRow::accuracyAsked, this, [this, i] { emit accuracyAsked(i); });
    if (menus_->hasPush(i)) row->addButton();
    connect(row, &ParameterRow::pushed, this, [this, i] { menus_->push(i); });
    connect(row, &ParameterRow::wayAsked, this, [this, i](const QPoint& at) { menus_->openWay(i, at); });
    row->installEventFilter(this);
    for (QWidget* child : row->findChildren<QWidget*>()) child->installEventFilter(this);
}

std::size_t ParameterPanel::groupShowing(std::size_t row) const
{
    const auto shown = std::find_if(groups_.begin(), groups_.end(), [row](const PanelGroup& group) {
        return std::find(group.rows.begin(), group.rows.end(), row) != group.rows.end();
    });
    return static_cast<std::size_t>(shown - groups_.begin());
}

std::vector<std::size_t> ParameterPanel::groupOf(std::size_t row) const
{
    for (const PanelGroup& group : groups_)
        if (group.kind == PanelGroup::Kind::table &&
            std::find(group.members.begin(), group.members.end(), row) != group.members.end())
            return group.members;
    return {row};  // All parameters of its group are in the essential group.
}

std::vector<std::size_t> ParameterPanel::inOrder() const
{
    std::vector<std::size_t> rows;
    for (const PanelGroup& group : groups_) rows.insert(rows.end(), group.rows.begin(), group.rows.end());
    return rows;
}

void ParameterPanel::orderTabs()
{
    // Tab leads to the rows in their order. By default, Qt would put new widgets at the end.
    QWidget* before = onlyChanged_;
    QList<QWidget*> stops;
    qsizetype firstOfRow = 0, marks = 0;
    for (QWidget* child : content_->findChildren<QWidget*>()) {
        if (qobject_cast<ParameterRow*>(child)) {
            firstOfRow = stops.size();
            marks = 0;
        }
        if (child->focusPolicy() == Qt::NoFocus || child->window() != window())
            continue;  // Choices have windows of their own.
        // Marks are placed before the controls.
        const bool mark = qobject_cast<GaugeMark*>(child) || qobject_cast<IdleMark*>(child);
        stops.insert(mark ? firstOfRow + marks++ : stops.size(), child);
    }
    for (QWidget* stop : std::as_const(stops)) {
        setTabOrder(before, stop);
        before = stop;
    }
}

bool ParameterPanel::focusIn(const ParameterRow& row)
{
    for (QWidget* child : row.findChildren<QWidget*>())
        if ((child->focusPolicy() & Qt::TabFocus) && child->isEnabled() && child->isVisible()) {
            child->setFocus(Qt::TabFocusReason);
            return true;
        }
    return false;
}

std::string ParameterPanel::focusedParameter() const
{
    const std::optional<std::size_t> row = rowAt(QApplication::focusWidget());
    return row ? std::string(table_->rows()[*row].name) : std::string();
}

ParameterRow* ParameterPanel::row(std::string_view name) const
{
    const std::optional<std::size_t> i = table_ ? table_->find(name) : std::nullopt;
    return i ? rows_[*i] : nullptr;
}

void ParameterPanel::setOffers(const std::map<std::string, std::vector<std::string>, std::less<>>& offers)
{
    for (const auto& [name, texts] : offers) {
        QStringList list;
        for (const std::string& text : texts) list << QString::fromStdString(text);
        if (ParameterRow* named = row(name)) named->setOffers(list);
    }
}

void ParameterPanel::setWanted(const std::function<bool(const ParameterInfo&)>& wanted)
{
    bool changed = false;
    for (ParameterRow* row : rows_) {
        const bool now = !wanted || wanted(row->info());
        changed = changed || now != row->wanted();
        row->setWanted(now);
    }
    if (changed) showOnlyWanted();
}

void ParameterPanel::setGaugesShown(bool shown)
{
    menus_->setGaugesShown(shown);
    for (ParameterRow* row : rows_) row->setGaugeShown(shown);
}

void ParameterPanel::showChoice(PanelChoice choice)
{
    if (!table_) return;
    switch (choice) {
    case PanelChoice::toggled:
        for (std::size_t i = 0; i < groups_.size(); ++i)
            sections_[i]->setFolded(choices_->has(choice, keyOf(groups_[i])) != groups_[i].foldedAtFirst);
        break;
    case PanelChoice::locked: showLocks(); break;
    case PanelChoice::pinned: rearrange(); break;
    }
}

void ParameterPanel::foldAll(bool folded)
{
    QStringList closed, open;
    for (const PanelGroup& group : groups_)
        if (group.kind == PanelGroup::Kind::table) (group.foldedAtFirst ? closed : open) << keyOf(group);
    choices_->set(PanelChoice::toggled, closed, !folded);
    choices_->set(PanelChoice::toggled, open, folded);
}

bool ParameterPanel::reveal(std::string_view name)
{
    const std::optional<std::size_t> row = table_ ? table_->find(name) : std::nullopt;
    if (!row || !rows_[*row]->wanted()) return false;
    onlyChanged_->setChecked(false);
    const PanelGroup& group = groups_[groupShowing(*row)];
    choices_->set(PanelChoice::toggled, {keyOf(group)}, group.foldedAtFirst);
    placeRows();
    return focusIn(*rows_[*row]);
}

void ParameterPanel::pinFocused()
{
    if (const std::optional<std::size_t> row = rowAt(QApplication::focusWidget())) menus_->togglePin(*row);
}

void ParameterPanel::showOnlyWanted()
{
    int shown = 0;
    for (ParameterSection* section : sections_) shown += section->showOnlyChanged(onlyChanged_->isChecked());
    nothing_->setVisible(shown == 0 && table_);
}

std::optional<std::size_t> ParameterPanel::rowAt(QObject* object) const
{
    for (; object && object != this; object = object->parent())
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (rows_[i] == object) return i;
    return std::nullopt;
}

bool ParameterPanel::eventFilter(QObject* object, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(object);
    if (event->type() == QEvent::Wheel && !widget->hasFocus()) {
        event->ignore();  // Scrolling the panel never changes a value.
        return true;
    }
    if (object == content_ && event->type() == QEvent::LayoutRequest) makeRoom();
    if (event->type() == QEvent::ContextMenu) {
        if (const auto i = rowAt(object)) {
            menus_->openRow(*i, static_cast<QContextMenuEvent*>(event)->globalPos());
            return true;
        }
    }
    if (event->type() == QEvent::FocusIn && rowAt(object)) scroll_->ensureWidgetVisible(widget, 0, 24);
    return QWidget::eventFilter(object, event);
}

QString ParameterPanel::keyOf(std::size_t row) const
{
    return name_ + QLatin1Char('/') + text(values().rows()[row].name);
}

QString ParameterPanel::keyOf(const PanelGroup& group) const
{
    return name_ + QLatin1Char('/') + text(group.title);
}

bool ParameterPanel::isLocked(std::size_t row) const
{
    return choices_->has(PanelChoice::locked, keyOf(row));
}

bool ParameterPanel::isPinned(std::size_t row) const
{
    return choices_->has(PanelChoice::pinned, keyOf(row));
}

bool ParameterPanel::mayPin(std::size_t row) const
{
    return !groups_.empty() && groups_.front().kind == PanelGroup::Kind::essentials && !values().rows()[row].essential;
}

void ParameterPanel::showLocks()
{
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->setLocked(isLocked(i));
    showGroups();
}

void ParameterPanel::vary()
{
    SceneState next = history_.sceneState();
    next.values[exhibit_] = variation(values(), ++seed_, [this](std::size_t row) { return isLocked(row); });
    history_.change(tr("Randomize parameters, seed %1").arg(seed_), next);
}

void ParameterPanel::showGroups()
{
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        const PanelGroup& group = groups_[i];
        const std::string_view array = values().rows()[group.members.front()].array;
        const bool together =
            group.kind == PanelGroup::Kind::table && !array.empty() && menus_->edits().together(array);
        sections_[i]->setTogether(together ? static_cast<int>(menus_->edits().groupsOf(array).size()) : 0);
        sections_[i]->setLocked(menus_->allLocked(group.members));
    }
}

namespace {

void type(QWidget& control, int key, bool again)
{
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier, {}, again);
    QApplication::sendEvent(&control, &press);
}

}  // namespace

void ParameterPanel::stepRow(int step)
{
    const std::optional<std::size_t> now = rowAt(QApplication::focusWidget());
    std::vector<std::size_t> rows = inOrder();
    if (now && step < 0) std::reverse(rows.begin(), rows.end());
    auto next = now ? std::find(rows.begin(), rows.end(), *now) + 1 : rows.begin();
    for (; next != rows.end(); ++next)
        if (rows_[*next]->isVisible() && focusIn(*rows_[*next])) return;
}

void ParameterPanel::nudge(int step, bool again)
{
    QWidget* control = QApplication::focusWidget();
    if (!rowAt(control)) return;
    if (qobject_cast<ValueSlider*>(control)) {
        type(*control, step > 0 ? Qt::Key_Right : Qt::Key_Left, again);
    } else if (qobject_cast<NumberField*>(control)) {
        type(*control, step > 0 ? Qt::Key_Up : Qt::Key_Down, again);
    } else if (qobject_cast<QComboBox*>(control)) {
        type(*control, step > 0 ? Qt::Key_Down : Qt::Key_Up, again);
    } else if (auto* button = qobject_cast<QAbstractButton*>(control)) {
        // A step up switches on, a step down off. Other buttons are pressed once, and not again while the key is held.
        if (!again && (!button->isCheckable() || button->isChecked() != (step > 0))) button->click();
    }
}

}  // namespace vitrine::ui

#include "moc_parameter_panel.cpp"
