#include "ui/parameters/parameter_panel.h"

#include "exhibits/framework/table/acting.h"
#include "exhibits/framework/table/random_values.h"
#include "exhibits/framework/time/animation.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/language.h"
#include "ui/kit/menu_text.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/model/other_settings.h"
#include "ui/parameters/group_edits.h"
#include "ui/parameters/motion_dialog.h"
#include "ui/parameters/number_field.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/parameter_section.h"
#include "ui/parameters/shown_text.h"
#include "ui/parameters/value_slider.h"
#include "ui/parameters/way_to_act.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMetaMethod>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
ParameterPanel::ParameterPanel(History& history, QWidget* parent)
    : QWidget(parent), history_(history), filter_(new QLineEdit(this)), onlyChanged_(new QToolButton(this)),
      elsewhere_(new QToolButton(this)), scroll_(new QScrollArea(this)), nothing_(new QLabel(this))
{
    filter_->setPlaceholderText(tr("Find a parameter"));
    filter_->setAccessibleName(tr("Find a parameter"));
    filter_->setToolTip(
        tr("Shows only parameters whose name, group, help or choices contain these words. Enter goes to the first, "
           "Esc clears, Esc again leaves."));
    filter_->setProperty(IdleUndo::searches, true);
    filter_->setClearButtonEnabled(true);
    growHeight(*filter_, 26);
    filter_->setTextMargins(4, 0, 4, 0);
    filter_->installEventFilter(this);
    onlyChanged_->setText(tr("Changed"));
    onlyChanged_->setAccessibleName(tr("Only changed"));
    onlyChanged_->setToolTip(tr("Shows only parameters whose value is not the initial one."));
    onlyChanged_->setCheckable(true);
    growHeight(*onlyChanged_, 26);
    onlyChanged_->setFocusPolicy(Qt::StrongFocus);
    elsewhere_->setAccessibleName(tr("Matches in the other tab"));
    elsewhere_->setToolTip(tr("Goes to the tab that has these parameters."));
    elsewhere_->setFocusPolicy(Qt::StrongFocus);
    elsewhere_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    growHeight(*elsewhere_, 26);
    elsewhere_->hide();
    connect(elsewhere_, &QToolButton::clicked, this, &ParameterPanel::elsewhereAsked);
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
    top->addWidget(filter_, 1);
    top->addWidget(onlyChanged_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(top);
    layout->addWidget(elsewhere_);
    layout->addWidget(nothing_);
    layout->addWidget(scroll_, 1);
    setMinimumWidth(leastWidth);

    connect(filter_, &QLineEdit::textChanged, this, [this] {
        applyFilter();
        emit filtered();
    });
    connect(onlyChanged_, &QToolButton::toggled, this, &ParameterPanel::applyFilter);
    watch();
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
    const bool sameTable = table_ && table_->hasRowsOf(values().table());
    const bool onlyRows = table_ && !sameTable;  // Of the same exhibit: a file gave others.
    const std::string focused = onlyRows ? focusedRow() : std::string();
    const int scrolled = onlyRows ? scroll_->verticalScrollBar()->value() : 0;
    if (!sameTable) {
        table_ = values().sharedTable();
        rebuild();
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) showValue(i);
    showWhatActs();
    for (ParameterSection* section : sections_) section->refresh();
    // With the filter for changed parameters, a parameter that was just reset stays visible until the filter is applied
    // again.
    if (!sameTable) applyFilter();
    if (!onlyRows) return;
    // The layout is activated first, because new rows have no position yet, and the scroll bar no range.
    content_->layout()->activate();
    content_->resize(scroll_->viewport()->width(), content_->sizeHint().height());
    focusRow(focused);
    scroll_->verticalScrollBar()->setValue(scrolled);
}

void ParameterPanel::showRow(std::size_t row)
{
    if (rows_.empty()) return;
    showValue(row);
    showWhatActs();
    sectionOf_[row]->refresh();
}

void ParameterPanel::showValue(std::size_t row)
{
    const ParameterInfo& info = values().rows()[row];
    const Motion* motion = values().motion(row);
    rows_[row]->setMotion(motion ? said(describe(info, *motion)) : QString());
    rows_[row]->showValue(motion ? valueOf(info, *motion, moment_) : values().row(row));
}

void ParameterPanel::showMoment(const MotionMoment& moment)
{
    moment_ = moment;
    if (values().motions().empty()) return;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (values().motion(i)) showValue(i);
}

void ParameterPanel::showWhatActs()
{
    for (std::size_t i = 0; i < rows_.size(); ++i)
        rows_[i]->setIdle(acts(values(), i) ? QString() : QString::fromStdString(actsWhen(values(), i)));
}

void ParameterPanel::rebuild()
{
    rows_.clear();
    sections_.clear();
    sectionOf_.clear();
    foldedAtFirst_.clear();
    content_ = new QWidget;
    auto* layout = new QVBoxLayout(content_);
    layout->setContentsMargins(0, 0, 4, 8);
    layout->setSpacing(0);
    for (std::size_t i = 0; i < values().rows().size(); ++i) {
        const ParameterInfo& info = values().rows()[i];
        if (i == 0 || info.group != values().rows()[i - 1].group) addSection(info);
        addRow(i);
    }
    layout->addStretch(1);
    showLocks();
    // Deleted later, because the sender of this call may be one of the rows that are deleted.
    if (QWidget* before = scroll_->takeWidget()) before->deleteLater();
    scroll_->setWidget(content_);
    content_->installEventFilter(this);
    makeRoom();
    orderTabs();
}

void ParameterPanel::makeRoom()
{
    // Rows are not scrolled sideways: the panel is as wide as the widest row and the scroll bar.
    const int needed = content_->minimumSizeHint().width() + scroll_->verticalScrollBar()->sizeHint().width();
    setMinimumWidth(std::max(leastWidth, needed));
}

void ParameterPanel::addSection(const ParameterInfo& first)
{
    auto* section = new ParameterSection(said(first.group), content_);
    connect(section, &ParameterSection::menuAsked, this,
            [this, section](const QPoint& at) { openGroupMenu(section, at); });
    const QString key = name_ + QLatin1Char('/') + section->title();
    foldedAtFirst_.push_back(first.groupFolded);
    section->setFolded(folded_.contains(key) != first.groupFolded);
    connect(section, &ParameterSection::foldedByVisitor, this, [this, key, atFirst = first.groupFolded](bool folded) {
        if (folded != atFirst)
            folded_.insert(key);
        else
            folded_.remove(key);
    });
    sections_.push_back(section);
    content_->layout()->addWidget(section);
}

void ParameterPanel::addRow(std::size_t i)
{
    auto* row = new ParameterRow(ValueRef(edits(), i), sections_.back());
    row->setGaugeShown(gauges_);
    sections_.back()->add(row);
    rows_.push_back(row);
    sectionOf_.push_back(sections_.back());
    connect(row, &ParameterRow::accuracyAsked, this, [this, i] { emit accuracyAsked(i); });
    connect(row, &ParameterRow::wayAsked, this, [this, i](const QPoint& at) { openWay(i, at); });
    row->installEventFilter(this);
    for (QWidget* child : row->findChildren<QWidget*>()) child->installEventFilter(this);
}

void ParameterPanel::orderTabs()
{
    // Tab leads from the filter to the rows in their order. By default, Qt would put new widgets at the end.
    QWidget* before = elsewhere_;
    setTabOrder(filter_, onlyChanged_);
    setTabOrder(onlyChanged_, elsewhere_);
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

void ParameterPanel::focusFirst()
{
    for (const ParameterRow* row : rows_)
        if (row->isVisible() && focusIn(*row)) return;
}

std::string ParameterPanel::focusedRow() const
{
    const std::optional<std::size_t> row = rowAt(QApplication::focusWidget());
    return row ? std::string(table_->rows()[*row].name) : std::string();
}

void ParameterPanel::focusRow(std::string_view name)
{
    if (const ParameterRow* found = row(name)) focusIn(*found);
}

QString ParameterPanel::filterText() const
{
    return filter_->text();
}

void ParameterPanel::clearFilter()
{
    filter_->clear();
}

void ParameterPanel::offerElsewhere(const QString& what)
{
    elsewhere_->setText(fontMetrics().elidedText(what, Qt::ElideRight, std::max(width() - 32, 200)));
    elsewhere_->setVisible(!what.isEmpty());
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
    if (changed) applyFilter();
}

void ParameterPanel::setGaugesShown(bool shown)
{
    gauges_ = shown;
    for (ParameterRow* row : rows_) row->setGaugeShown(shown);
}

QStringList ParameterPanel::foldedGroups() const
{
    QStringList all(folded_.begin(), folded_.end());
    all.sort();
    return all;
}

void ParameterPanel::setFoldedGroups(const QStringList& groups)
{
    folded_ = QSet<QString>(groups.begin(), groups.end());
    for (std::size_t i = 0; i < sections_.size(); ++i)
        sections_[i]->setFolded(folded_.contains(name_ + QLatin1Char('/') + sections_[i]->title()) !=
                                foldedAtFirst_[i]);
}

void ParameterPanel::find(const QString& words)
{
    filter_->setText(words);
}

void ParameterPanel::focusFilter()
{
    filter_->setFocus(Qt::ShortcutFocusReason);
    filter_->selectAll();
}

void ParameterPanel::applyFilter()
{
    int shown = 0;
    for (ParameterSection* section : sections_) shown += section->filter(filter_->text(), onlyChanged_->isChecked());
    nothing_->setVisible(shown == 0 && table_);
    nothing_->setText(filter_->text().isEmpty() ? tr("All parameters have their initial values.")
                                                : tr("No parameter matches \"%1\".").arg(filter_->text()));
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
    if (event->type() == QEvent::Wheel && object != filter_ && !widget->hasFocus()) {
        event->ignore();  // Scrolling the panel never changes a value.
        return true;
    }
    if (event->type() == QEvent::KeyPress && object == filter_) {
        switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Escape:
            if (!filter_->text().isEmpty())
                filter_->clear();
            else if (isSignalConnected(QMetaMethod::fromSignal(&ParameterPanel::filterLeft)))
                emit filterLeft();
            else
                return false;  // A dialog is closed.
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Down: focusFirst(); return true;
        default: break;
        }
    }
    if (object == content_ && event->type() == QEvent::LayoutRequest) makeRoom();
    if (event->type() == QEvent::ContextMenu) {
        if (const auto i = rowAt(object)) {
            openMenu(*i, static_cast<QContextMenuEvent*>(event)->globalPos());
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

void ParameterPanel::showLocks()
{
    for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i]->setLocked(isLocked(i));
    showGroups();
}

QStringList ParameterPanel::lockedRows() const
{
    QStringList all(locked_.begin(), locked_.end());
    all.sort();
    return all;
}

void ParameterPanel::setLockedRows(const QStringList& rows)
{
    locked_ = QSet<QString>(rows.begin(), rows.end());
    showLocks();
    emit locksChanged();
}

void ParameterPanel::vary()
{
    SceneState next = history_.sceneState();
    next.values[exhibit_] = variation(values(), ++seed_, [this](std::size_t row) { return isLocked(row); });
    history_.change(tr("Randomize parameters, seed %1").arg(seed_), next);
}

namespace {

QString rowLabel(const ParameterInfo& row)
{
    return said(label(row));
}

}  // namespace

void ParameterPanel::openMenu(std::size_t row, const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const ParameterInfo& info = values().rows()[row];
    QAction* reset =
        menu->addAction(tr("Reset to %1").arg(shownText(info, info.initial)), rows_[row], &ParameterRow::reset);
    reset->setEnabled(!values().isInitial(row) || values().motion(row));
    addWayTo(*menu, row);
    menu->addSeparator();
    if (gauges_ && info.qualityReference)
        menu->addAction(tr("What does accuracy cost?"), this, [this, row] { emit accuracyAsked(row); });
    menu->addAction(tr("Copy value"), this, [this, row] { copy(row); });
    menu->addAction(tr("Paste"), this, [this, row] { paste(row); });
    menu->addAction(tr("Copy all as JSON"), this, [this] { copyAll(); });
    menu->addAction(tr("Paste all"), this, [this, row] { pasteAll(row); });
    addMotionTo(*menu, row);
    addOtherTo(*menu, row);
    addLocksTo(*menu, row);
    menu->popup(at);
}

void ParameterPanel::openWay(std::size_t row, const QPoint& at)
{
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(menuText(rows_[row]->whyIdle()))->setEnabled(false);
    addWayTo(*menu, row);
    menu->popup(at);
}

void ParameterPanel::addWayTo(QMenu& menu, std::size_t row)
{
    const std::optional<RowChanges> changes = changesToAct(values(), row);
    if (!changes || changes->empty()) return;
    QStringList parts;
    for (const auto& [other, value] : *changes) {
        const ParameterInfo& info = values().rows()[other];
        parts << tr("“%1”: %2").arg(rowLabel(info), shownText(info, value));
    }
    const QString words = tr("Set %1").arg(parts.join(QStringLiteral("; ")));
    menu.addAction(menuText(words), this, [this, words, changes = *changes] {
        SceneState next = history_.sceneState();
        for (const auto& [other, value] : changes) next.values[exhibit_].setRow(other, value);
        history_.change(words, next);
    });
}

void ParameterPanel::addMotionTo(QMenu& menu, std::size_t row)
{
    const ParameterInfo& info = values().rows()[row];
    menu.addSeparator();
    const std::string_view why = whyUnmoved(info);
    QAction* animate = menu.addAction(tr("Animate…"), this, [this, row] {
        (new MotionDialog(history_, exhibit_, edits().rowsWith(row), this))->openOver(*rows_[row]);
    });
    animate->setEnabled(why.empty());
    animate->setToolTip(said(why));
    menu.setToolTipsVisible(true);
    const Motion* motion = values().motion(row);
    if (!motion) return;
    const QString name = rowLabel(info).toLower();
    const Motion next = motion->heldAt ? resumed(*motion, moment_) : held(*motion, moment_);
    const Value now = valueOf(info, *motion, moment_);
    menu.addAction(
        motion->heldAt ? tr("Move on") : tr("Hold"), this,
        [this, row, next, base = values().row(row),
         words = (motion->heldAt ? tr("Move %1 on") : tr("Hold %1")).arg(name)] { setMotion(row, words, next, base); });
    menu.addAction(tr("Stop here"), this,
                   [this, row, now, words = tr("Stop %1").arg(name)] { setMotion(row, words, std::nullopt, now); });
}

void ParameterPanel::setMotion(std::size_t row, const QString& words, const std::optional<Motion>& motion,
                               const Value& base)
{
    edits().setMotion(row, words, motion, base);
}

void ParameterPanel::addLocksTo(QMenu& menu, std::size_t row)
{
    const std::vector<std::size_t> group = rowsOf(sectionOf_[row]);
    const bool all = allLocked(group);
    menu.addSeparator();
    menu.addAction(isLocked(row) ? tr("Unlock") : tr("Exclude from randomizing"), this,
                   [this, row] { lock({row}, !isLocked(row)); });
    menu.addAction(all ? tr("Unlock the group") : tr("Lock the group"), this,
                   [this, group, all] { lock(group, !all); });
}

void ParameterPanel::lock(const std::vector<std::size_t>& rows, bool locked)
{
    for (const std::size_t row : rows) {
        if (locked)
            locked_.insert(keyOf(row));
        else
            locked_.remove(keyOf(row));
    }
    showLocks();
    emit locksChanged();
}

void ParameterPanel::addOtherTo(QMenu& menu, std::size_t row)
{
    if (!other_ || !other_->held()) return;
    const ParameterInfo& info = values().rows()[row];
    const ParameterValues& others = other_->sceneState().values[exhibit_];
    const std::optional<std::size_t> twin = others.table().find(info.name);
    if (!twin || others.rows()[*twin].kind != info.kind) return;
    menu.addSeparator();
    const std::string name(info.name);
    QAction* take = menu.addAction(menuText(tr("Copy from B: %1").arg(shownText(info, others.row(*twin)))), this,
                                   [this, name] { other_->take(exhibit_, name); });
    QAction* give = menu.addAction(tr("Copy to B"), this, [this, name] { other_->give(exhibit_, name); });
    for (QAction* action : {take, give}) action->setEnabled(!(others.row(*twin) == values().row(row)));
}

void ParameterPanel::copy(std::size_t row) const
{
    QApplication::clipboard()->setText(exactText(values().rows()[row], values().row(row)));
}

void ParameterPanel::paste(std::size_t row)
{
    QString problem;
    const std::optional<Value> value =
        typedValue(values().rows()[row], QApplication::clipboard()->text().trimmed(), &problem);
    if (value) edits().hold(row, *value, newGesture(), tr("Paste %1").arg(rowLabel(values().rows()[row]).toLower()));
    if (!problem.isEmpty()) tell(row, problem);
}

void ParameterPanel::pasteAll(std::size_t row)
{
    QString problem;
    const std::optional<ParameterValues> pasted =
        allFromJson(values().table(), name_, QApplication::clipboard()->text(), &problem);
    if (!problem.isEmpty()) tell(row, problem);
    if (!pasted) return;
    SceneState next = history_.sceneState();
    next.values[exhibit_] = *pasted;
    history_.change(tr("Paste all values"), next, newGesture());
}

void ParameterPanel::tell(std::size_t row, const QString& words)
{
    QToolTip::showText(rows_[row]->mapToGlobal(QPoint(16, rows_[row]->height())), words, rows_[row]);
}

void ParameterPanel::copyAll() const
{
    QApplication::clipboard()->setText(allAsJson(values(), name_));
}

GroupEdits& ParameterPanel::edits()
{
    GroupEdits*& made = edits_[exhibit_];
    if (!made) {
        made = new GroupEdits(history_, exhibit_, this);
        connect(made, &GroupEdits::changed, this, &ParameterPanel::showGroups);
    }
    return *made;
}

std::vector<std::size_t> ParameterPanel::rowsOf(const ParameterSection* section) const
{
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < sectionOf_.size(); ++i)
        if (sectionOf_[i] == section) rows.push_back(i);
    return rows;
}

void ParameterPanel::openGroupMenu(ParameterSection* section, const QPoint& at)
{
    const std::vector<std::size_t> rows = rowsOf(section);
    if (rows.empty()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setAccessibleName(tr("Menu of %1").arg(section->title()));
    const bool locked = allLocked(rows);
    menu->addAction(locked ? tr("Unlock the group") : tr("Lock the group"), this,
                    [this, rows, locked] { lock(rows, !locked); });
    addArrayTo(*menu, values().rows()[rows.front()]);
    menu->popup(at);
}

void ParameterPanel::addArrayTo(QMenu& menu, const ParameterInfo& first)
{
    GroupEdits& edit = edits();
    const std::string array(first.array);
    const std::size_t here = first.element;
    const std::vector<GroupEdits::Group> groups = edit.groupsOf(array);
    if (groups.size() < 2) return;
    menu.addSeparator();
    QAction* together = menu.addAction(tr("Edit all %n together", nullptr, static_cast<int>(groups.size())));
    together->setCheckable(true);
    together->setChecked(edit.together(array));
    connect(together, &QAction::triggered, this, [&edit, array](bool on) { edit.setTogether(array, on); });
    QAction* give =
        menu.addAction(tr("Copy to the others"), this, [&edit, array, here] { edit.copyToOthers(array, here); });
    give->setEnabled(std::any_of(groups.begin(), groups.end(), [&](const GroupEdits::Group& group) {
        return group.element != here && !edit.alike(array, here, group.element);
    }));
    for (const GroupEdits::Group& group : groups) {
        if (group.element == here) continue;
        QAction* take = menu.addAction(menuText(tr("Copy from %1").arg(said(group.heading))), this,
                                       [&edit, array, from = group.element, here] { edit.copy(array, from, here); });
        take->setEnabled(!edit.alike(array, group.element, here));
    }
}

bool ParameterPanel::allLocked(const std::vector<std::size_t>& rows) const
{
    return std::all_of(rows.begin(), rows.end(), [this](std::size_t row) { return isLocked(row); });
}

void ParameterPanel::showGroups()
{
    for (ParameterSection* section : sections_) {
        const std::vector<std::size_t> rows = rowsOf(section);
        if (rows.empty()) continue;
        const std::string_view array = values().rows()[rows.front()].array;
        const bool together = !array.empty() && edits().together(array);
        section->setTogether(together ? static_cast<int>(edits().groupsOf(array).size()) : 0);
        section->setLocked(allLocked(rows));
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
    const auto count = static_cast<std::ptrdiff_t>(rows_.size());
    std::ptrdiff_t next = now ? static_cast<std::ptrdiff_t>(*now) + step : 0;
    for (; next >= 0 && next<count; next += step> 0 || !now ? 1 : -1) {
        const ParameterRow& row = *rows_[static_cast<std::size_t>(next)];
        if (row.isVisible() && focusIn(row)) return;
    }
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
