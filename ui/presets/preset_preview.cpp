#include "ui/presets/preset_preview.h"

#include "ui/kit/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>

namespace vitrine::ui {
namespace {

constexpr int restTime = 700;  // Milliseconds that the pointer rests on a line before its preview opens.
constexpr QSize largest(384, 240);
constexpr int mostDifferences = 12;

}  // namespace

PresetPreview::PresetPreview(QListWidget& list, int idRole)
    : QFrame(&list, Qt::ToolTip), list_(list), idRole_(idRole), picture_(new QLabel(this)), name_(new QLabel(this)),
      words_(new QLabel(this))
{
    setFrameShape(QFrame::Box);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Preview of a preset"));
    setAttribute(Qt::WA_ShowWithoutActivating);
    QFont bold = name_->font();
    bold.setWeight(QFont::DemiBold);
    name_->setFont(bold);
    for (QLabel* label : {name_, words_}) {
        label->setTextFormat(Qt::PlainText);
        label->setWordWrap(true);
        label->setFixedWidth(largest.width());
    }
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(8, 8, 8, 8);
    all->setSpacing(6);
    all->setSizeConstraint(QLayout::SetFixedSize);
    for (QLabel* label : {picture_, name_, words_}) all->addWidget(label);
    rest_.setSingleShot(true);
    rest_.setInterval(restTime);
    connect(&rest_, &QTimer::timeout, this, [this] {
        byKey_ = false;
        askFor(list_.indexAt(pointer_));
    });
    connect(&list_, &QListWidget::currentItemChanged, this, [this] {
        if (isVisible() && byKey_) askFor(list_.currentIndex());
    });
    connect(list_.model(), &QAbstractItemModel::modelAboutToBeReset, this, &PresetPreview::close);
    list_.installEventFilter(this);
    list_.viewport()->installEventFilter(this);
    close();
}

void PresetPreview::askFor(const QModelIndex& index)
{
    if (!index.isValid() || !list_.isVisible()) return close();
    about_ = index;
    emit asked(index.data(idRole_).toString());
}

void PresetPreview::show(const PresetFacts& facts)
{
    picture_->setVisible(!facts.picture.isNull());
    if (!facts.picture.isNull())
        picture_->setPixmap(facts.picture.scaled(largest, Qt::KeepAspectRatio, Qt::SmoothTransformation));
    name_->setText(facts.name);
    QStringList lines{facts.problem, facts.origin};
    if (!facts.tags.isEmpty()) lines << tr("Tags: %1").arg(facts.tags.join(QStringLiteral(", ")));
    lines.removeAll(QString());
    if (facts.differences.isEmpty() && facts.problem.isEmpty())
        lines << tr("All parameters have their initial values.");
    if (!facts.differences.isEmpty()) {
        lines << QString() << tr("Changed parameters:");
        lines << facts.differences.mid(0, mostDifferences);
        if (const auto more = facts.differences.size() - mostDifferences; more > 0)
            lines << tr("and %n more", nullptr, static_cast<int>(more));
    }
    words_->setText(lines.join(QLatin1Char('\n')));
    list_.setAccessibleDescription(facts.name + QStringLiteral(". ") + lines.join(QStringLiteral(". ")));
    QFrame::show();
    adjustSize();
    place();
}

void PresetPreview::place()
{
    const QRect line = list_.visualRect(about_);
    const QRect over(list_.viewport()->mapToGlobal(line.topLeft()), line.size());
    const QRect room = list_.screen()->availableGeometry();
    const int right = over.right() + 9;
    const int x = right + width() <= room.right() ? right : over.left() - 8 - width();
    move(std::max(x, room.left()), std::clamp(over.top(), room.top(), std::max(room.top(), room.bottom() - height())));
}

void PresetPreview::close()
{
    rest_.stop();
    byKey_ = false;
    about_ = QModelIndex();
    list_.setAccessibleDescription(tr("Space opens a large preview."));
    hide();
}

bool PresetPreview::takesKey(QEvent* event)
{
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool opens = key == Qt::Key_Space && list_.currentIndex().isValid();
    if (!opens && !(key == Qt::Key_Escape && isVisible())) return false;
    event->accept();  // The window's shortcuts must not get these keys.
    if (event->type() == QEvent::ShortcutOverride) return true;
    if (isVisible() || !opens) {
        close();
    } else {
        byKey_ = true;
        askFor(list_.currentIndex());
    }
    return true;
}

bool PresetPreview::eventFilter(QObject* object, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress: return object == &list_ && takesKey(event);
    case QEvent::MouseMove:
        pointer_ = static_cast<QMouseEvent*>(event)->position().toPoint();
        if (isVisible() && about_ == list_.indexAt(pointer_)) break;
        if (!byKey_) close();
        rest_.start();
        break;
    case QEvent::Leave:
        rest_.stop();
        if (!byKey_) close();
        break;
    case QEvent::FocusOut:
    case QEvent::Hide:
    case QEvent::MouseButtonPress:
    case QEvent::Wheel: close(); break;
    default: break;
    }
    return QFrame::eventFilter(object, event);
}

}  // namespace vitrine::ui

#include "moc_preset_preview.cpp"
