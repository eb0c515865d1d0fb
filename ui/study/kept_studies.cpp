#include "ui/study/kept_studies.h"

#include "render/failure.h"
#include "render/files/read_file.h"
#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/name_dialog.h"
#include "ui/kit/picture_file.h"
#include "ui/kit/text.h"
#include "ui/model/history.h"
#include "ui/study/comparison_chart.h"
#include "ui/study/comparison_dialog.h"
#include "ui/study/study_chart.h"
#include "ui/study/study_export.h"
#include "ui/study/two_line_delegate.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QFileDialog>
#include <QKeyEvent>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <memory>

namespace vitrine::ui {
namespace {

constexpr int pathRole = Qt::UserRole;
constexpr int mostCompared = 8;  // Limited by the number of marks and colors that can be told apart.

QString words(const std::string& s)
{
    return QString::fromStdString(s);
}

/// Formats a time as "2026-11-25 01:43".
QString dayAndMinute(const std::string& measured)
{
    return words(measured).left(16).replace(QLatin1Char('T'), QLatin1Char(' '));
}

}  // namespace

KeptStudies::KeptStudies(Subjects subjects, History& history, study::StudyStore store, QWidget* parent)
    : QWidget(parent), subjects_(subjects), history_(history), store_(std::move(store)), list_(new QListWidget(this)),
      compare_(new QPushButton(tr("Compare"), this))
{
    list_->setAccessibleName(tr("Kept studies"));
    list_->setAccessibleDescription(tr("Enter shows one, Space ticks it, F2 renames it, Delete deletes it."));
    list_->setItemDelegate(new TwoLineDelegate(list_));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setContextMenuPolicy(Qt::ActionsContextMenu);
    list_->setMinimumWidth(180);
    list_->installEventFilter(this);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(4);
    all->addWidget(list_, 1);
    addButtons();
    connect(list_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { show(item->data(pathRole).toString()); });
    connect(list_, &QListWidget::itemChanged, this, &KeptStudies::noteTicks);
    noteTicks();
    pictures_.setMaxThreadCount(1);
}

KeptStudies::~KeptStudies()
{
    pictures_.waitForDone();  // All kept pictures are written.
}

void KeptStudies::addButtons()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    compare_->setToolTip(tr("Shows the fronts of the ticked studies over each other, and how they differ."));
    connect(compare_, &QPushButton::clicked, this, &KeptStudies::compare);
    auto* open = new QPushButton(tr("Open…"), this);
    open->setToolTip(tr("Keeps a copy of a study from elsewhere: the study.json of “vitrine study”."));
    open->setAccessibleName(tr("Open a study"));
    connect(open, &QPushButton::clicked, this, &KeptStudies::askForFile);
    auto* more = new QToolButton(this);
    more->setText(QStringLiteral("⋯"));
    more->setAccessibleName(tr("More for kept studies"));
    more->setToolTip(tr("Show, rename, delete, copy, save"));
    more->setPopupMode(QToolButton::InstantPopup);
    more->setFocusPolicy(Qt::StrongFocus);
    more->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    auto* menu = new QMenu(more);
    const auto add = [&](const QString& text, void (KeptStudies::*work)()) {
        QAction* action = menu->addAction(text);
        connect(action, &QAction::triggered, this, work);
        list_->addAction(action);
    };
    QAction* showIt = menu->addAction(tr("Show"));
    connect(showIt, &QAction::triggered, this, [this] { show(selected()); });
    list_->addAction(showIt);
    add(tr("Rename…"), &KeptStudies::rename);
    add(tr("Delete"), &KeptStudies::remove);
    add(tr("Copy the ticked as a table"), &KeptStudies::copy);
    add(tr("Save the ticked…"), &KeptStudies::save);
    more->setMenu(menu);
    row->addWidget(compare_, 1);
    row->addWidget(open, 1);
    row->addWidget(more);
    for (QWidget* button : std::initializer_list<QWidget*>{compare_, open, more}) button->setFixedHeight(26);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void KeptStudies::trySafely(const std::function<void()>& work)
{
    try {
        work();
    } catch (const std::exception& thrown) {
        emit failed(messageOf(thrown));
    }
}

QString KeptStudies::titleOf(const study::KeptStudy& study) const
{
    if (!study.name.empty()) return words(study.name);
    QString exhibit = words(study.exhibit);
    for (const auto& subject : subjects_)
        if (subject->name() == study.exhibit) exhibit = text(subject->title());
    return study.parameters.size() > 2 ? tr("%1: all parameters").arg(exhibit)
                                       : tr("%1: %2").arg(exhibit, translatedText(study.parameterNames()));
}

QListWidgetItem* KeptStudies::itemFor(const study::StudyEntry& entry) const
{
    auto* item = new QListWidgetItem;
    item->setData(pathRole, words(entry.path.string()));
    if (!entry.problem.empty()) {
        item->setText(words(entry.path.filename().string()));
        item->setData(TwoLineDelegate::secondLine, tr("Cannot be opened"));
        item->setToolTip(words(entry.problem));
        return item;
    }
    const study::KeptStudy& study = entry.study;
    item->setText(titleOf(study));
    QStringList facts{dayAndMinute(study.measured), tr("points: %1").arg(study.measuredPoints()),
                      study.complete ? QString() : tr("stopped early"), words(study.renderer)};
    facts.removeAll(QString());
    item->setData(TwoLineDelegate::secondLine, facts.join(QStringLiteral(" · ")));
    QStringList lines{titleOf(study), tr("Exhibit: %1").arg(words(study.exhibit)),
                      tr("Parameters: %1").arg(translatedText(study.parameterNames())),
                      facts.join(QStringLiteral(" · ")),
                      tr("%1 × %2 pixels, clock: %3").arg(study.size.x).arg(study.size.y).arg(words(study.clock))};
    item->setToolTip(lines.join(QLatin1Char('\n')));
    item->setData(Qt::AccessibleTextRole, titleOf(study) + QStringLiteral(", ") + facts.join(QStringLiteral(", ")));
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setCheckState(Qt::Unchecked);
    return item;
}

void KeptStudies::refresh()
{
    const QString current = selected();
    const QSignalBlocker quiet(list_);
    QStringList ticked;
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->checkState() == Qt::Checked) ticked << list_->item(i)->data(pathRole).toString();
    list_->clear();
    for (const study::StudyEntry& entry : store_.list()) {
        QListWidgetItem* item = itemFor(entry);
        const QString path = item->data(pathRole).toString();
        if (ticked.contains(path)) item->setCheckState(Qt::Checked);
        list_->addItem(item);
        if (path == current) list_->setCurrentItem(item);
    }
    if (!list_->currentItem()) list_->setCurrentRow(0);
    noteTicks();
}

void KeptStudies::showEvent(QShowEvent* event)
{
    refresh();
    QWidget::showEvent(event);
}

int KeptStudies::count() const
{
    return list_->count();
}

bool KeptStudies::eventFilter(QObject* object, QEvent* event)
{
    const bool asks = event->type() == QEvent::ShortcutOverride;
    if (object == list_ && (asks || event->type() == QEvent::KeyPress)) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (asks && key == Qt::Key_Space) {
            event->accept();  // Space ticks an entry; the window's shortcut would pause the clock.
            return true;
        }
        if (key == Qt::Key_F2 || key == Qt::Key_Delete) {
            event->accept();  // The window's shortcuts for these keys apply to presets.
            if (!asks) key == Qt::Key_F2 ? rename() : remove();
            return true;
        }
        if (!asks && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            show(selected());
            return true;
        }
    }
    return QWidget::eventFilter(object, event);
}

QString KeptStudies::selected() const
{
    const QListWidgetItem* item = list_->currentItem();
    return item ? item->data(pathRole).toString() : QString();
}

QStringList KeptStudies::chosen() const
{
    QStringList paths;
    for (int i = 0; i < list_->count(); ++i)
        if (list_->item(i)->checkState() == Qt::Checked) paths << list_->item(i)->data(pathRole).toString();
    if (paths.isEmpty() && !selected().isEmpty()) paths << selected();
    return paths;
}

std::vector<study::KeptStudy> KeptStudies::chosenStudies() const
{
    std::vector<study::KeptStudy> studies;
    for (const QString& path : chosen()) studies.push_back(study::readStudy(path.toStdString()));
    return studies;
}

void KeptStudies::noteTicks()
{
    int ticked = 0;
    for (int i = 0; i < list_->count(); ++i) ticked += list_->item(i)->checkState() == Qt::Checked ? 1 : 0;
    compare_->setEnabled(ticked >= 2 && ticked <= mostCompared);
    compare_->setText(ticked >= 2 ? tr("Compare %n", nullptr, ticked) : tr("Compare"));
    compare_->setAccessibleName(tr("Compare the ticked studies"));
}

void KeptStudies::keep(render::Json study, bool complete, study::ContactSheet pictures)
{
    trySafely([&] {
        const QString now = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss"));
        const std::filesystem::path path = store_.keep(std::move(study), now.toStdString(), complete);
        if (pictures.empty()) return;
        pictures_.start(
            [this, store = store_, path, sheet = std::make_shared<study::ContactSheet>(std::move(pictures))] {
                try {
                    store.keepPictures(path, *sheet);
                } catch (const std::exception& thrown) {
                    QMetaObject::invokeMethod(
                        this, [this, why = messageOf(thrown)] { emit failed(why); }, Qt::QueuedConnection);
                }
            });
    });
    if (isVisible()) refresh();
}

void KeptStudies::show(const QString& path)
{
    if (path.isEmpty()) return;
    trySafely([&] {
        const std::string json = render::readFile(path.toStdString(), study::studyLimits.bytes);
        const study::KeptStudy study =
            study::parseStudy(render::parseJson(json, path.toStdString(), study::studyLimits));
        emit showAsked(study, json);
        readPictures(path, study);
    });
}

void KeptStudies::readPictures(const QString& path, const study::KeptStudy& study)
{
    pictures_.start([this, store = store_, path = path.toStdString(), study, number = ++shown_] {
        study::ContactSheet sheet;
        QString why;
        try {
            sheet = store.pictures(path, study);
        } catch (const std::exception& thrown) {
            why = messageOf(thrown);
        }
        const auto take = [this, sheet = std::move(sheet), why, number] {
            if (!why.isEmpty()) emit failed(why);
            if (number == shown_ && !sheet.empty()) emit picturesRead(sheet);
        };
        QMetaObject::invokeMethod(this, take, Qt::QueuedConnection);
    });
}

void KeptStudies::askForFile()
{
    auto* dialog = new QFileDialog(window(), tr("Open a study"), QString(), tr("Studies (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &KeptStudies::openFile);
    dialog->open();
}

void KeptStudies::openFile(const QString& path)
{
    trySafely([&] {
        const QString kept = words(store_.add(path.toStdString()).front().string());
        refresh();
        for (int i = 0; i < list_->count(); ++i)
            if (list_->item(i)->data(pathRole).toString() == kept) list_->setCurrentRow(i);
        show(kept);
    });
}

void KeptStudies::rename()
{
    const QString path = selected();
    if (path.isEmpty()) return;
    trySafely([&] {
        const QString before = titleOf(study::readStudy(path.toStdString()));
        auto* ask = new NameDialog(tr("Rename the study"), before, window());
        connect(ask, &NameDialog::named, this, [this, path](const QString& name) {
            trySafely([&] { store_.rename(path.toStdString(), name.toStdString()); });
            refresh();
        });
        ask->openOver(*list_);
    });
}

void KeptStudies::remove()
{
    const QString path = selected();
    if (path.isEmpty()) return;
    trySafely([&] {
        pictures_.waitForDone();  // Pictures are removed together with the study.
        // An undeletable file throws here, before there is an undo step.
        const QString title = list_->currentItem()->text();
        auto removed = std::make_shared<RemovedDocument>(store_.remove(path.toStdString()));
        auto first = std::make_shared<bool>(true);
        history_.record(
            tr("Delete the study %1").arg(title),
            [this, removed, first] {
                if (!std::exchange(*first, false)) trySafely([&] { *removed = store_.remove(removed->original); });
                refresh();
            },
            [this, removed] {
                trySafely([&] { removed->original = store_.restore(*removed); });
                refresh();
            });
    });
}

void KeptStudies::compare()
{
    trySafely([&] {
        auto* dialog = new ComparisonDialog(chosenStudies(), window());
        connect(dialog, &ComparisonDialog::failed, this, &KeptStudies::failed);
        dialog->show();
    });
}

QByteArray KeptStudies::exported(const QString& suffix) const
{
    const std::vector<study::KeptStudy> studies = chosenStudies();
    if (suffix == QLatin1String("csv")) return QByteArray::fromStdString(study::keptCsv(studies));
    if (suffix == QLatin1String("json")) {
        if (studies.size() == 1)
            return QByteArray::fromStdString(
                render::readFile(chosen().front().toStdString(), study::studyLimits.bytes));
        std::vector<render::Json> all;
        for (const QString& path : chosen())
            all.push_back(render::readJson(path.toStdString(), study::studyLimits).root());
        return QByteArray::fromStdString(render::writeJson(study::studiesJson(all)));
    }
    std::unique_ptr<LogChart> chart;
    if (studies.size() == 1) {
        auto one = std::make_unique<StudyChart>();
        const bool timed = std::any_of(studies[0].points.begin(), studies[0].points.end(),
                                       [](const study::KeptPoint& point) { return point.time.has_value(); });
        one->showStudy(
            charted(studies[0], titleOf(studies[0]), study::usualCostAxis(studies[0].clockTrusted && timed)));
        chart = std::move(one);
    } else {
        const std::vector<std::string> costs = study::sharedCosts(studies);
        if (costs.empty())
            throw Failure(ErrorKind::check,
                          "These studies share no count of work, so no chart can show them together.");
        auto several = std::make_unique<ComparisonChart>();
        several->setComparison(study::compareStudies(studies, study::labelsOf(studies), costs.front()));
        chart = std::move(several);
    }
    return chartFile(suffix, *chart);
}

void KeptStudies::save()
{
    if (chosen().isEmpty()) return;
    const QString why = askAndSaveStudy(this, [this](const QString& suffix) { return exported(suffix); });
    if (!why.isEmpty()) emit failed(why);
}

void KeptStudies::copy()
{
    if (chosen().isEmpty()) return;
    trySafely([&] { QApplication::clipboard()->setText(QString::fromUtf8(exported(QStringLiteral("csv")))); });
}

}  // namespace vitrine::ui

#include "moc_kept_studies.cpp"
