#include "ui/tree/tree_overlay.h"

#include "exhibits/museum/museum.h"
#include "render/failure.h"
#include "ui/kit/progress_job.h"
#include "ui/kit/theme.h"
#include "ui/tree/tree_editor.h"
#include "ui/tree/tree_outline.h"
#include "ui/viewport/viewport.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include <glm/gtc/matrix_inverse.hpp>

namespace vitrine::ui {
namespace {

constexpr int outlineDelay = 40;  ///< Milliseconds without a change.

QColor colorOf(int axis)
{
    static const QColor colors[] = {QColor(0xe8, 0x5d, 0x4a), QColor(0x7d, 0xbb, 0x4c), QColor(0x5b, 0x93, 0xe6)};
    return colors[axis];
}

}  // namespace

TreeOverlay::TreeOverlay(const Museum& museum, TreeEditor& editor, Viewport& viewport)
    : QWidget(&viewport), museum_(museum), editor_(editor), viewport_(viewport), job_(new ProgressJob(this))
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
    setAccessibleName(tr("Handles of the selected shape"));
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    soon_.setSingleShot(true);
    soon_.setInterval(outlineDelay);
    connect(&soon_, &QTimer::timeout, this, &TreeOverlay::askForOutline);
    connect(&viewport, &Viewport::looked, this, &TreeOverlay::renew);
    connect(&viewport.interaction(), &Interaction::shapeClicked, this, &TreeOverlay::pick);
    connect(&editor, &TreeEditor::selectionChanged, this, &TreeOverlay::renew);
    connect(&editor, &TreeEditor::valuesChanged, this, &TreeOverlay::renew);
    lower();
    hide();
}

TreeOverlay::~TreeOverlay() = default;

void TreeOverlay::setMode(HandleMode mode)
{
    mode_ = mode;
    findHandles();
    update();
}

void TreeOverlay::pick(std::size_t exhibit, const QPointF& at)
{
    if (exhibit != editor_.subject() || !editor_.source()) return;
    const render::View view = viewport_.scene().view();
    const glm::dvec2 ndc(2 * at.x() / width() - 1, 1 - 2 * at.y() / height());
    const render::Ray ray{view.eye, glm::normalize(view.direction(ndc))};
    const glm::dmat4 exhibitFromWorld = glm::affineInverse(museum_.worldFromExhibit(exhibit));
    const std::string node =
        editor_.source()->pick({editor_.values(), viewport_.clock().time()}, ray.transformed(exhibitFromWorld));
    editor_.select(node);
    if (!node.empty()) emit editor_.shown();
}

void TreeOverlay::renew()
{
    const bool some = editor_.source() && !editor_.selected().empty() && !viewport_.covered();
    setVisible(some);
    if (!some) {
        job_->stop();
        soon_.stop();
        outline_.clear();
        handles_.clear();
        return;
    }
    findHandles();
    if (!soon_.isActive()) soon_.start();
    update();
}

std::optional<TreePlace> TreeOverlay::place() const
{
    return editor_.source()->placeOf({editor_.values(), viewport_.clock().time()}, editor_.selected());
}

void TreeOverlay::findHandles()
{
    handles_.clear();
    if (!editor_.source() || editor_.selected().empty() || viewport_.covered()) return;
    if (const auto place = this->place(); place && place->without.empty())
        handles_ = handlesOf(mode_, *place, museum_.worldFromExhibit(editor_.subject()), viewport_.scene().view(),
                             QSizeF(size()));
}

void TreeOverlay::askForOutline()
{
    if (!editor_.source() || editor_.selected().empty()) return;
    job_->start([this, source = editor_.source(), values = editor_.values(), time = viewport_.clock().time(),
                 node = editor_.selected(), view = viewport_.scene().view(), widget = QSizeF(size()),
                 world = museum_.worldFromExhibit(editor_.subject())](
                    const ProgressJob::Progress& progress) -> ProgressJob::Outcome {
        const auto shape = source->shapeOf({values, time}, node);
        bool goesOn = true;
        std::vector<QLineF> lines;
        if (shape) lines = outlineOf(*shape, view, world, widget, [&] { return goesOn = goesOn && progress(0); });
        if (!goesOn) throw Failure(ErrorKind::check, "stopped");
        return [this, lines, clip = view.clipFromWorld] {
            outline_ = lines;
            outlineView_ = clip;
            update();
            emit outlined();
        };
    });
}

void TreeOverlay::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QList<QLineF> lines;
    if (outlineView_ == viewport_.scene().view().clipFromWorld) lines = QList<QLineF>(outline_.begin(), outline_.end());
    for (const auto& [color, width] : {std::pair{QColor(0, 0, 0, 110), 4.0}, std::pair{theme().accent, 2.0}}) {
        painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
        painter.drawLines(lines);
    }
    for (const Handle& handle : handles_) {
        const QPolygonF line(QList<QPointF>(handle.line.begin(), handle.line.end()));
        for (const auto& [color, width] :
             {std::pair{QColor(0, 0, 0, 120), 5.0}, std::pair{colorOf(handle.axis), 2.5}}) {
            painter.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap));
            painter.drawPolyline(line);
        }
        if (mode_ == HandleMode::turn) continue;
        painter.setPen(QPen(QColor(0, 0, 0, 120), 1));
        painter.setBrush(colorOf(handle.axis));
        const QPointF end = handle.line.back();
        if (mode_ == HandleMode::scale)
            painter.drawRect(QRectF(end - QPointF(4.5, 4.5), QSizeF(9, 9)));
        else
            painter.drawEllipse(end, 5, 5);
    }
}

bool TreeOverlay::press(const QPointF& at)
{
    const auto grip = gripAt(handles_, at);
    const auto now = grip ? place() : std::nullopt;
    if (!now) return false;
    drag_ = Drag{handles_[grip->handle], grip->point, at, *now, newGesture()};
    return true;
}

void TreeOverlay::drag(const QPointF& at)
{
    const auto now = place();
    if (!now) return;
    // Changes the number of this axis only, because others may be animated.
    const TreePlace wanted = dragged(mode_, drag_->place, drag_->handle, drag_->point, at - drag_->from);
    const int axis = drag_->handle.axis;
    TreePlace to = *now;
    to.translate[axis] = mode_ == HandleMode::move ? wanted.translate[axis] : to.translate[axis];
    to.rotate[axis] = mode_ == HandleMode::turn ? wanted.rotate[axis] : to.rotate[axis];
    to.scale[axis] = mode_ == HandleMode::scale ? wanted.scale[axis] : to.scale[axis];
    if (to.translate == now->translate && to.rotate == now->rotate && to.scale == now->scale) return;
    const QString title = editor_.selectedTitle();
    editor_.setPlace(*now, to, drag_->gesture,
                     mode_ == HandleMode::move   ? tr("Move %1").arg(title)
                     : mode_ == HandleMode::turn ? tr("Turn %1").arg(title)
                                                 : tr("Scale %1").arg(title));
}

bool TreeOverlay::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Resize: setGeometry(viewport_.rect()); break;
    case QEvent::MouseButtonPress: {
        const auto& mouse = *static_cast<QMouseEvent*>(event);
        if (mouse.button() == Qt::LeftButton && press(mouse.position())) return true;
        break;
    }
    case QEvent::MouseMove:
        if (!drag_) break;
        drag(static_cast<QMouseEvent*>(event)->position());
        return true;
    case QEvent::MouseButtonRelease:
        if (!drag_) break;
        drag_.reset();
        return true;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace vitrine::ui

#include "moc_tree_overlay.cpp"
