#include "ui/parameters/parameter_panel.h"

#include "exhibits/framework/random_values.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/language.h"
#include "ui/kit/text.h"
#include "ui/kit/theme.h"
#include "ui/kit/type_size.h"
#include "ui/parameters/group_edits.h"
#include "ui/parameters/parameter_row.h"
#include "ui/parameters/parameter_section.h"
#include "ui/parameters/shown_text.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
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
    connect(&history_, &History::changed, this, &ParameterPanel::showRow);
    connect(&history_, &History::replaced, this, &ParameterPanel::showAll);
}

void ParameterPanel::showExhibit(std::size_t exhibit, const QString& name)
{
    const bool another = exhibit_ != exhibit || name_ != name;
    exhibit_ = exhibit;
    name_ = name;
    if (another) table_.reset();
    showAll();
}

void ParameterPanel::showAll()
{
    if (name_.isEmpty()) return;  // Nothing is shown yet.
    // A file that was read again gives another table, mostly of the same rows: their controls stay as they are.
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
    // While only changed rows are shown, a row that was just reset stays until the next look.
    if (!sameTable) applyFilter();
    if (!onlyRows) return;
    // The new rows have no place yet, and the bar no range.
    content_->layout()->activate();
    content_->resize(scroll_->viewport()->width(), content_->sizeHint().height());
    focusRow(focused);
    scroll_->verticalScrollBar()->setValue(scrolled);
}

void ParameterPanel::showRow(std::size_t exhibit, std::size_t row)
{
    if (exhibit != exhibit_ || rows_.empty()) return;
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
    // What asked for other rows may be one of those that go.
    if (QWidget* before = scroll_->takeWidget()) before->deleteLater();
    scroll_->setWidget(content_);
    content_->installEventFilter(this);
    makeRoom();
    orderTabs();
}

void ParameterPanel::makeRoom()
{
    // Rows are not scrolled across: the panel is as wide as the widest one needs, and the bar beside them.
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
    // From the filter straight into the rows, in their order: Qt would put what is made later behind everything else.
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
        // The marks stand before the controls.
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
    nothing_->setText(filter_->text().isEmpty() ? tr("All values are the initial ones.")
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
    history_.change(tr("Vary at random, seed %1").arg(seed_), next);
}

}  // namespace vitrine::ui

#include "moc_parameter_panel.cpp"
