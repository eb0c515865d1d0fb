#include "ui/record/record_dialog.h"

#include "exhibits/framework/state_folder.h"
#include "exhibits/recording/tour.h"
#include "render/failure.h"
#include "ui/kit/export_bar.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/message_of.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/scroll_room.h"
#include "ui/kit/type_size.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/record/bookmarks.h"
#include "ui/viewport/viewport.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QStandardPaths>

#include <numbers>

namespace vitrine::ui {
namespace {

QString filmPlaces()
{
    return QString::fromStdString((stateFolder() / "films.ini").string());
}

/// Numbers that the dialog keeps, by the names of their fields.
QList<QDoubleSpinBox*> keptNumbers(const QDialog& dialog)
{
    return dialog.findChildren<QDoubleSpinBox*>();
}

/// Throws Failure where the way round leads into something.
void requireFreeWay(const Obstacles& obstacles, const CameraMotion& motion)
{
    if (firstCollision(obstacles, motion) >= 0)
        throw Failure(
            Blame::usage,
            "On its way round the camera runs into a wall or what stands in the hall; turn by a smaller angle.");
}

}  // namespace

RecordDialog::RecordDialog(Workbench& window, const Bookmarks& bookmarks, QWidget* parent)
    : QDialog(parent), window_(window), bookmarks_(bookmarks),
      maker_(window.museum(), window.renderers(), window.viewport().renderThread(), this), way_(new QComboBox(this)),
      angle_(new QDoubleSpinBox(this)), seconds_(new QDoubleSpinBox(this)), rate_(new QDoubleSpinBox(this)),
      shutter_(new QDoubleSpinBox(this)), width_(new QSpinBox(this)), height_(new QSpinBox(this)),
      samples_(new QSpinBox(this)), about_(new QLabel(this)),
      export_(new ExportBar({tr("The film: .mp4, .webm, .gif, .webp or .apng, or frames as in frames/%04d.png."),
                             tr("Record"), tr("Films (*.mp4 *.webm *.gif *.webp *.apng)"), QStringLiteral("mp4")},
                            this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Record"));
    build();
    layOut();
    connect(way_, &QComboBox::currentIndexChanged, this, &RecordDialog::showPossible);
    connect(&bookmarks_, &Bookmarks::changed, this, &RecordDialog::showPossible);
    connect(export_, &ExportBar::goAsked, this, &RecordDialog::startRecording);
    connect(export_, &ExportBar::exportAsked, this, &RecordDialog::begin);
    connect(export_, &ExportBar::stopAsked, this, &RecordDialog::reject);
    connect(&maker_, &FilmMaker::progressed, export_, &ExportBar::showProgress);
    connect(&maker_, &FilmMaker::finished, this, [this] {
        const QString saved = tr("Saved %1.").arg(QFileInfo(path()).fileName());
        export_->setPath(nextFreePath(path()));
        endRecording(saved, true);
    });
    connect(&maker_, &FilmMaker::failed, this, [this](const QString& why) {
        endRecording(tr("Nothing was written."), false);
        about_->setText(why);
    });
    recall();
    setWay(bookmarks.tour().bookmarks.size() > 1 ? Way::bookmarks : Way::round);
    showPossible();
}

void RecordDialog::build()
{
    way_->addItems(
        {tr("Along the bookmarks"), tr("Round what you look at"), tr("Past all exhibits"), tr("Not at all")});
    way_->setAccessibleName(tr("Camera"));
    const auto number = [](QDoubleSpinBox* box, const char* name, double low, double high, double value, int decimals,
                           const QString& suffix, const QString& title) {
        box->setObjectName(QString::fromUtf8(name));
        box->setDecimals(decimals);
        box->setRange(low, high);
        box->setValue(value);
        box->setSuffix(suffix);
        box->setAccessibleName(title);
        box->setFocusPolicy(Qt::StrongFocus);
    };
    number(angle_, "angle", -360, 360, 60, 0, tr("°"), tr("Angle"));
    number(seconds_, "seconds", 0.1, 3600, 8, 1, tr(" s"), tr("Length"));
    number(rate_, "rate", 1, 240, 30, 2, tr(" frames a second"), tr("Frame rate"));
    number(shutter_, "shutter", 0, 1, 0, 2, {}, tr("Motion blur"));
    shutter_->setSingleStep(0.1);
    shutter_->setToolTip(tr("The share of a frame's time for which it is exposed, by eight pictures; 0: none."));
    for (QSpinBox* side : {width_, height_}) {
        side->setRange(2, 16383);
        side->setSingleStep(2);
        side->setSuffix(tr(" px"));
        side->setFocusPolicy(Qt::StrongFocus);
    }
    width_->setValue(1280);
    height_->setValue(720);
    width_->setAccessibleName(tr("Width"));
    height_->setAccessibleName(tr("Height"));
    samples_->setRange(1, 64);
    samples_->setValue(4);
    samples_->setFocusPolicy(Qt::StrongFocus);
    samples_->setToolTip(tr("Samples per pixel: edges are stairs at 1, smooth at 16."));
    about_->setTextFormat(Qt::PlainText);
    about_->setWordWrap(true);
    followType(*about_, [this] { about_->setMinimumHeight(2 * about_->fontMetrics().height()); });
}

void RecordDialog::layOut()
{
    auto* size = new QHBoxLayout;
    size->setSpacing(8);
    size->addWidget(width_);
    size->addWidget(new QLabel(QStringLiteral("×"), this));
    size->addWidget(height_);
    size->addStretch(1);
    auto* form = new QFormLayout(this);
    form->setContentsMargins(16, 16, 16, 16);
    form->setSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft);
    form->addRow(tr("Camera moves"), way_);
    form->addRow(tr("Angle"), angle_);
    form->addRow(tr("Length"), seconds_);
    form->addRow(tr("Frame rate"), rate_);
    form->addRow(tr("Size"), size);
    form->addRow(tr("Samples per pixel"), samples_);
    form->addRow(tr("Motion blur"), shutter_);
    form->addRow(about_);
    form->addRow(export_);
    growMinimumWidth(*this, 480);
    scrollWhenTight(*this);
}

void RecordDialog::recall()
{
    const QSettings places(iniPath(filmPlaces()), QSettings::IniFormat);
    QString folder = places.value(QStringLiteral("folder")).toString();
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
    QDir().mkpath(folder);
    const QString path = QDir(folder).filePath(QStringLiteral("vitrine.mp4"));
    export_->setPath(QFileInfo::exists(path) ? nextFreePath(path) : path);
    for (QDoubleSpinBox* box : keptNumbers(*this))
        box->setValue(places.value(box->objectName(), box->value()).toDouble());
    width_->setValue(places.value(QStringLiteral("width"), width_->value()).toInt());
    height_->setValue(places.value(QStringLiteral("height"), height_->value()).toInt());
    samples_->setValue(places.value(QStringLiteral("samples"), samples_->value()).toInt());
}

void RecordDialog::remember() const
{
    QSettings places(iniPath(filmPlaces()), QSettings::IniFormat);
    places.setValue(QStringLiteral("folder"), QFileInfo(path()).absolutePath());
    for (const QDoubleSpinBox* box : keptNumbers(*this)) places.setValue(box->objectName(), box->value());
    places.setValue(QStringLiteral("width"), width_->value());
    places.setValue(QStringLiteral("height"), height_->value());
    places.setValue(QStringLiteral("samples"), samples_->value());
}

RecordDialog::Way RecordDialog::way() const
{
    return static_cast<Way>(way_->currentIndex());
}

void RecordDialog::setWay(Way way)
{
    way_->setCurrentIndex(static_cast<int>(way));
}

void RecordDialog::setPath(const QString& path)
{
    export_->setPath(path);
}

QString RecordDialog::path() const
{
    return export_->path();
}

QString RecordDialog::status() const
{
    return export_->status();
}

void RecordDialog::showPossible()
{
    const bool busy = maker_.running();
    const bool lacks = way() == Way::bookmarks && bookmarks_.tour().bookmarks.size() < 2;
    for (QWidget* input : std::initializer_list<QWidget*>{way_, seconds_, rate_, width_, height_, samples_, shutter_})
        input->setEnabled(!busy);
    angle_->setEnabled(!busy && way() == Way::round);
    if (!busy)
        about_->setText(
            lacks ? tr("Set two bookmarks at least: one where you stand, then another elsewhere (Bookmarks menu).")
                  : QString());
    export_->showPossible(busy, !lacks);
}

RecordingRequest RecordDialog::request() const
{
    RecordingRequest request;
    request.picture.frame.raster.size = {width_->value(), height_->value()};
    request.picture.frame.time = window_.viewport().time();
    request.picture.frame.needsFiles = true;
    request.picture.samples = samples_->value();
    request.picture.largestTile = RenderThread::taskTile;
    request.seconds = seconds_->value();
    request.framesPerSecond = rate_->value();
    request.shutter = shutter_->value();
    request.closed = way() == Way::still || way() == Way::tour;
    return request;
}

FilmWish RecordDialog::wish() const
{
    FilmWish wish{window_.history().sceneState(), window_.chosen(), {}, path().toStdString()};
    RecordingRequest request = this->request();
    requireRecordable(request, wish.path);
    const render::Camera camera = wish.sceneState.camera;
    const double angle = angle_->value() * std::numbers::pi / 180;
    if (way() == Way::still) {
        request.camera = [camera](double) { return camera; };
    } else if (way() == Way::round) {
        request.closed = isWholeTurns(angle);
        request.camera = turntable(camera, angle, request.closed ? Pace::constant : Pace::eased);
        requireFreeWay(window_.museum().obstacles(wish.sceneState), request.camera);
    }
    wish.request = [request] { return request; };
    if (way() != Way::bookmarks && way() != Way::tour) return wish;
    const Tour tour = way() == Way::tour ? museumTour(window_.museum(), wish.sceneState) : bookmarks_.tour();
    wish.request = [request, tour, &museum = window_.museum(), sceneState = wish.sceneState] {
        RecordingRequest along = request;
        along.camera = [path = tourPath(museum.obstacles(sceneState), tour), pace = tour.pace](double part) {
            return path.at(paced(pace, part));
        };
        return along;
    };
    return wish;
}

void RecordDialog::startRecording()
{
    if (maker_.running()) return;
    try {
        static_cast<void>(wish());
    } catch (const std::exception& failure) {
        about_->setText(messageOf(failure));
        return;
    }
    about_->clear();
    export_->ask({});
}

void RecordDialog::begin()
{
    if (maker_.running()) return;
    maker_.start(wish());
    export_->showStatus(tr("Recording"));
    showPossible();
}

void RecordDialog::endRecording(const QString& words, bool written)
{
    export_->showStatus(words);
    showPossible();
    emit recordingEnded(written);
}

void RecordDialog::reject()
{
    if (!maker_.running()) {
        QDialog::reject();
        return;
    }
    maker_.stop();
    endRecording(tr("Canceled; whole frames stay, a video leaves no file."), false);
}

void RecordDialog::done(int result)
{
    maker_.stop();
    remember();
    QDialog::done(result);
}

}  // namespace vitrine::ui

#include "moc_record_dialog.cpp"
