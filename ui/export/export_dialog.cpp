#include "ui/export/export_dialog.h"

#include "exhibits/framework/files/state_folder.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/message_strip.h"
#include "ui/kit/type_size.h"
#include "ui/kit/window_place.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int kindsWidth = 150;         // Pixels.
constexpr int kindsShareOfScreen = 18;  // Percent.
constexpr int idRole = Qt::UserRole;

QSettings exportPlaces()
{
    return {iniPath(QString::fromStdString((stateFolder() / "jobs.ini").string())), QSettings::IniFormat};
}

}  // namespace

ExportDialog::ExportDialog(std::vector<ExportKind> kinds, QWidget* parent)
    : QDialog(parent), kinds_(std::move(kinds)), list_(new QListWidget(this)), stack_(new QStackedWidget(this)),
      presets_(new ExportPresetList(this)), messages_(new MessageStrip(this))
{
    setWindowTitle(tr("Export"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    list_->setObjectName(QStringLiteral("kinds"));
    list_->setAccessibleName(tr("Kind of export"));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setSpacing(4);
    list_->setWordWrap(true);
    list_->setResizeMode(QListView::Adjust);
    for (const ExportKind& kind : kinds_) {
        auto* item = new QListWidgetItem(kind.title, list_);
        item->setData(idRole, kind.id);
        item->setToolTip(kind.unavailable);
        if (!kind.unavailable.isEmpty()) item->setFlags(Qt::NoItemFlags);
    }
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(buildColumn());
    layout->addWidget(stack_, 1);
    messages_->lieOver(stack_);
    connect(list_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item) showKind(item->data(idRole).toString());
    });
    // With a title bar, the usual size fits 1280 x 720.
    constexpr QSize around(32, 48);
    resize(QSize(grown(1150, *this), grown(680, *this))
               .boundedTo((screen()->availableSize() - around).expandedTo(QSize(1150, 680))));
    restorePlace(*this, exportPlaces().value(QStringLiteral("export/geometry")).toByteArray());
}

QWidget* ExportDialog::buildColumn()
{
    auto* column = new QWidget(this);
    growWidth(*column, kindsWidth, kindsShareOfScreen);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(list_, 1);
    layout->addWidget(presets_);
    connect(presets_, &ExportPresetList::failed, this, [this](const QString& why) {
        messages_->setProblems(QStringLiteral("presets"), why.isEmpty() ? QStringList() : QStringList(why));
    });
    connect(presets_, &ExportPresetList::noted, this,
            [this](const QString& note) { messages_->say(MessageStrip::Mood::notice, note); });
    return column;
}

QDialog* ExportDialog::page(const ExportKind& kind)
{
    if (const auto known = pages_.find(kind.id); known != pages_.end()) return known->second;
    QDialog* page = kind.makePage(stack_);  // Kept only after this, which may throw.
    pages_[kind.id] = page;
    page->setWindowFlags(Qt::Widget);
    page->setAccessibleName(kind.title);
    stack_->addWidget(page);
    connect(page, &QDialog::finished, this, [this, id = kind.id] { endPage(id); });
    return page;
}

QDialog* ExportDialog::showKind(const QString& id)
{
    const auto kind = std::find_if(kinds_.begin(), kinds_.end(), [&](const ExportKind& each) { return each.id == id; });
    if (kind == kinds_.end() || !kind->unavailable.isEmpty()) return nullptr;
    QDialog* shown = page(*kind);
    stack_->setCurrentWidget(shown);
    shown->show();
    if (kind->settings)
        presets_->show(kind->settings(*shown));
    else
        presets_->clear();
    const QSignalBlocker quiet(list_);
    list_->setCurrentRow(static_cast<int>(kind - kinds_.begin()));
    return shown;
}

QString ExportDialog::shownKind() const
{
    const QListWidgetItem* item = list_->currentItem();
    return item ? item->data(idRole).toString() : QString();
}

bool ExportDialog::isExporting(const QString& id) const
{
    const auto page = pages_.find(id);
    const auto kind = std::find_if(kinds_.begin(), kinds_.end(), [&](const ExportKind& each) { return each.id == id; });
    return page != pages_.end() && kind != kinds_.end() && kind->exporting(*page->second);
}

void ExportDialog::endPage(const QString& id)
{
    presets_->clear();
    pages_.erase(id);  // A finished page deletes itself.
    QDialog::reject();
    exportPlaces().setValue(QStringLiteral("export/geometry"), saveGeometry());
    // While another page exports, no page is deleted.
    if (std::any_of(pages_.begin(), pages_.end(), [this](const auto& each) { return isExporting(each.first); })) return;
    for (const auto& [name, page] : pages_) page->deleteLater();
    pages_.clear();
}

void ExportDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    list_->setFocus(Qt::OtherFocusReason);  // The page, which is shown before, has taken the focus.
}

void ExportDialog::reject()
{
    const auto shown = pages_.find(shownKind());
    if (shown != pages_.end())
        shown->second->reject();
    else
        endPage({});
}

}  // namespace vitrine::ui

#include "moc_export_dialog.cpp"
