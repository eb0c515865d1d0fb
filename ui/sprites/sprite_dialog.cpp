#include "ui/sprites/sprite_dialog.h"

#include "exhibits/framework/state_folder.h"
#include "render/failure.h"
#include "render/image/srgb.h"
#include "ui/kit/export_bar.h"
#include "ui/kit/idle_undo.h"
#include "ui/kit/ini_file.h"
#include "ui/kit/language.h"
#include "ui/kit/replace_question.h"
#include "ui/kit/scroll_room.h"
#include "ui/kit/type_size.h"
#include "ui/kit/window_place.h"
#include "ui/parameters/parameter_panel.h"
#include "ui/sprites/sprite_preview.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QSettings>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::ui {
namespace {

constexpr int spritePanelWidth = 376;
constexpr int lookAfter = 250;                   // Milliseconds.
constexpr std::int64_t draftPixels = 1U << 20U;  // Of all frames that are drawn to be looked at.

/// Cause of the problems of an export: they leave with the next one.
QString spriteExportCause()
{
    return QStringLiteral("export");
}

QString spritePlaces()
{
    return QString::fromStdString((stateFolder() / "sprites.ini").string());
}

/// Fewer frames, and fewer sides, where there are more than are worth waiting for.
ParameterValues draftOf(ParameterValues values)
{
    const SpriteTable& t = spriteTable();
    const std::int64_t each = std::int64_t{values[t.width]} * values[t.height];
    while (each * values[t.frames] * values[t.directions] > draftPixels) {
        if (values[t.frames] > 8)
            values.set(t.frames, values[t.frames] / 2);
        else if (values[t.directions] > 4)
            values.set(t.directions, values[t.directions] / 2);
        else if (values[t.frames] > 1)
            values.set(t.frames, values[t.frames] / 2);
        else if (values[t.directions] > 1)
            values.set(t.directions, 1);
        else
            break;
    }
    return values;
}

QImage pictureOf(const render::Image& sheet)
{
    QImage picture(sheet.width, sheet.height, QImage::Format_ARGB32);
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x) {
            const auto code = [&](int k) { return static_cast<int>(render::srgb8FromLinear(sheet.at(x, y, k))); };
            const auto opacity = static_cast<int>(std::lround(255 * std::clamp(sheet.at(x, y, 3), 0.0F, 1.0F)));
            picture.setPixel(x, y, opacity > 0 ? qRgba(code(0), code(1), code(2), opacity) : 0U);
        }
    return picture;
}

std::shared_ptr<const SpritePreview::Shown> shownOf(const SpriteSheet& sheet, const ParameterValues& values,
                                                    double frameSeconds)
{
    const SpriteTable& t = spriteTable();
    auto shown = std::make_shared<SpritePreview::Shown>();
    shown->picture = pictureOf(sheet.color);
    shown->cells = sheet.cells;
    for (const glm::ivec2 pivot : sheet.pivots) shown->pivots.emplace_back(pivot.x, pivot.y);
    shown->frame = {values[t.width], values[t.height]};
    shown->frames = values[t.frames];
    shown->seconds = frameSeconds;
    return shown;
}

}  // namespace

SpriteDialog::SpriteDialog(ParameterValues look, Renderers& renderers, RenderThread& thread, QWidget* parent)
    : QDialog(parent), look_(std::move(look)), setup_(this), draft_(renderers, thread, this),
      full_(renderers, thread, this), read_(this), sheet_(this), write_(this)
{
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Export sprites"));
    soon_.setSingleShot(true);
    soon_.setInterval(lookAfter);
    build();
    buildUndo();
    connectParts();
    recall();
}

SpriteDialog::~SpriteDialog()
{
    if (!remembered_) remember();  // The window took it along.
}

void SpriteDialog::build()
{
    panel_ = new ParameterPanel(setup_.history(), this);
    panel_->showExhibit(0, QStringLiteral("sprites"));
    animation_ = new QComboBox(this);
    animation_->setAccessibleName(tr("Animation"));
    animation_->setFocusPolicy(Qt::StrongFocus);
    numbers_ = new QLabel(this);
    numbers_->setTextFormat(Qt::PlainText);
    numbers_->setWordWrap(true);
    preview_ = new SpritePreview(this);
    export_ = new ExportBar({tr("The sheet: .png. Further sheets and the description take its name."),
                             tr("Export sprites"), tr("PNG (*.png)"), QStringLiteral("png")},
                            this);

    auto* motion = new QHBoxLayout;
    motion->setContentsMargins(8, 8, 8, 0);
    motion->setSpacing(8);
    auto* label = new QLabel(tr("Animation"), this);
    label->setBuddy(animation_);
    motion->addWidget(label);
    motion->addWidget(animation_, 1);
    auto* side = new QWidget(this);
    auto* left = new QVBoxLayout(side);
    left->setContentsMargins(0, 0, 0, 0);
    left->setSpacing(0);
    left->addLayout(motion);
    left->addWidget(panel_, 1);
    growWidth(*side, spritePanelWidth);
    auto* content = new QWidget;
    auto* right = new QVBoxLayout(content);
    right->setContentsMargins(8, 8, 16, 16);
    right->setSpacing(8);
    right->addWidget(preview_, 1);
    right->addWidget(numbers_);
    right->addWidget(export_);
    auto* sides = new QHBoxLayout;
    sides->setSpacing(8);
    sides->addWidget(side);
    auto* room = new ScrollRoom(content, this);
    sides->addWidget(room, 1);
    messages_ = new MessageStrip(this);
    messages_->lieOver(room);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(sides, 1);
    resize(1000, 680);  // With a title bar it fits 1280 x 720.
}

void SpriteDialog::buildUndo()
{
    QUndoStack& stack = setup_.history().stack();
    QAction* undo = stack.createUndoAction(this);
    undo->setShortcuts(QKeySequence::Undo);
    QAction* redo = stack.createRedoAction(this);
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    addActions({undo, redo});
    new IdleUndo(this);
}

void SpriteDialog::connectParts()
{
    connect(&setup_, &SpriteSetup::changed, this, &SpriteDialog::follow);
    connect(&soon_, &QTimer::timeout, this, &SpriteDialog::lookAgain);
    connect(animation_, &QComboBox::activated, this,
            [this] { setup_.setAnimation(animation_->currentText().toStdString()); });
    connect(&read_, &ProgressJob::failed, this, [this](const QString& why) {
        subject_.reset();
        complain(why);
        follow();
    });
    connect(&draft_, &SpriteDrawer::finished, this, &SpriteDialog::showDraft);
    connect(&draft_, &SpriteDrawer::failed, this, &SpriteDialog::complain);
    connect(&sheet_, &ProgressJob::failed, this, &SpriteDialog::complain);
    connect(&full_, &SpriteDrawer::progressed, export_, &ExportBar::showProgress);
    connect(&full_, &SpriteDrawer::finished, this, &SpriteDialog::write);
    connect(&full_, &SpriteDrawer::failed, this, [this](const QString& why) {
        endExport(tr("Nothing was written."));
        complain(why);
    });
    connect(&write_, &ProgressJob::stopped, this, [this] { endExport(tr("Canceled; no file was written.")); });
    connect(&write_, &ProgressJob::failed, this, [this](const QString& why) {
        endExport(tr("Nothing was written."));
        messages_->setProblems(spriteExportCause(), {why});
    });
    connect(export_, &ExportBar::goAsked, this, &SpriteDialog::startExport);
    connect(export_, &ExportBar::exportAsked, this, &SpriteDialog::begin);
    connect(export_, &ExportBar::stopAsked, this, &SpriteDialog::reject);
}

void SpriteDialog::recall()
{
    const QSettings places(iniPath(spritePlaces()), QSettings::IniFormat);
    restorePlace(*this, places.value(QStringLiteral("geometry")).toByteArray());
    QString folder = places.value(QStringLiteral("folder")).toString();
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    const QString path = QDir(folder).filePath(QStringLiteral("sprites.png"));
    export_->setPath(QFileInfo::exists(path) ? nextFreePath(path) : path);
    setup_.recall();
}

void SpriteDialog::remember()
{
    remembered_ = true;
    try {
        setup_.remember();
        QSettings places(iniPath(spritePlaces()), QSettings::IniFormat);
        places.setValue(QStringLiteral("geometry"), saveGeometry());
        places.setValue(QStringLiteral("folder"), QFileInfo(path()).absolutePath());
    } catch (const std::exception& failure) {
        qWarning("%s", failure.what());  // The dialog is closing; nothing else depends on it.
    }
}

void SpriteDialog::complain(const QString& why)
{
    messages_->setProblems(QStringLiteral("object"), why.isEmpty() ? QStringList() : QStringList(why));
}

void SpriteDialog::follow()
{
    if (setup_.values()[spriteTable().model] != model_) {
        readObject();
        return;
    }
    if (subject_) complain({});
    showAnimations();
    showButtons();
    draft_.stop();
    sheet_.stop();
    soon_.start();
}

void SpriteDialog::readObject()
{
    model_ = setup_.values()[spriteTable().model];
    subject_.reset();
    draft_.stop();
    numbers_->setText(tr("Reading"));
    showButtons();
    read_.start([this, values = setup_.values()](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        const std::shared_ptr<const SpriteSubject> subject = spriteSubject(values);
        return [this, subject] { takeObject(subject); };
    });
}

void SpriteDialog::takeObject(const std::shared_ptr<const SpriteSubject>& subject)
{
    subject_ = subject;
    for (const std::string& warning : subject->warnings()) messages_->say(MessageStrip::Mood::notice, said(warning));
    const std::vector<std::string> names = subject->animations();
    if (std::find(names.begin(), names.end(), setup_.animation()) == names.end())
        setup_.setAnimation(names.empty() ? "" : names.front());
    follow();
}

void SpriteDialog::showAnimations()
{
    animation_->clear();
    if (subject_)
        for (const std::string& name : subject_->animations()) animation_->addItem(QString::fromStdString(name));
    animation_->setCurrentIndex(animation_->findText(QString::fromStdString(setup_.animation())));
    animation_->setEnabled(animation_->count() > 1 && !exporting_);
    // What cannot be chosen says why.
    const bool own = setup_.values()[spriteTable().model].empty();
    animation_->setPlaceholderText(own ? tr("its own turn") : tr("none in this file"));
    animation_->setToolTip(animation_->count() > 1    ? tr("Of the file, by its name.")
                           : animation_->count() == 1 ? tr("The file has no other animation.")
                           : own                      ? tr("The torus over its pillar always tumbles.")
                                 : tr("The file has no animation: all frames of a direction are alike."));
}

std::string SpriteDialog::whyNot() const
{
    return whyNoSheet(setup_.values());
}

void SpriteDialog::showButtons()
{
    export_->showPossible(exporting_, subject_ && whyNot().empty());
    panel_->setEnabled(!exporting_);
    animation_->setEnabled(animation_->count() > 1 && !exporting_);
}

bool SpriteDialog::settled() const
{
    return !read_.running() && !soon_.isActive() && !draft_.running() && !sheet_.running();
}

void SpriteDialog::lookAgain()
{
    const std::string why = whyNot();
    if (!subject_ || !why.empty()) {
        preview_->setShown(nullptr);
        numbers_->setText(said(why));
        return;
    }
    draft_.start(look_, subject_, spriteRequest(draftOf(setup_.values()), setup_.animation()));
}

void SpriteDialog::showDraft(const SpriteDrawer::Frames& frames)
{
    sheet_.start([this, frames, subject = subject_, all = setup_.values(),
                  animation = setup_.animation()](const ProgressJob::Progress&) -> ProgressJob::Outcome {
        const ParameterValues values = draftOf(all);
        const SpriteSheet sheet = sheetOf(*frames, values, animation, *subject, "preview.png");
        const SpriteTable& t = spriteTable();
        // Fewer frames take as long as all of them.
        const double seconds = sheet.frameSeconds *
                               (all[t.framesPerSecond] > 0 ? static_cast<double>(all[t.frames]) / values[t.frames] : 1);
        const auto shown = shownOf(sheet, values, seconds);
        const bool drawnInFull = values == all;
        return [this, shown, drawnInFull, colors = sheet.palette.size(), warnings = sheet.warnings] {
            preview_->setShown(shown);
            const ParameterValues& set = setup_.values();
            const QString frameText =
                tr("%1 frames, %2 colors").arg(set[spriteTable().frames] * set[spriteTable().directions]).arg(colors);
            numbers_->setText(drawnInFull ? tr("%1, a sheet of %2 × %3 pixels")
                                                .arg(frameText)
                                                .arg(shown->picture.width())
                                                .arg(shown->picture.height())
                                          : tr("%1; a part of them is shown here").arg(frameText));
            for (const std::string& warning : warnings)
                numbers_->setText(numbers_->text() + QLatin1Char('\n') + said(warning));
        };
    });
}

void SpriteDialog::setPath(const QString& path)
{
    export_->setPath(path);
}

QString SpriteDialog::path() const
{
    return export_->path();
}

void SpriteDialog::startExport()
{
    if (exporting_ || !subject_ || !whyNot().empty()) return;
    messages_->setProblems(spriteExportCause(), {});
    if (QFileInfo(path()).suffix().toLower() != QLatin1String("png")) {
        messages_->setProblems(
            spriteExportCause(),
            {tr("%1 was not written: sheets of sprites are PNG files; give a name with .png.").arg(path())});
        return;
    }
    QStringList beside;
    for (const auto& file : sheetFiles(setup_.values(), path().toStdString()))
        beside << QString::fromStdString(file.string());
    beside.removeFirst();
    export_->ask(beside);
}

void SpriteDialog::begin()
{
    if (exporting_) return;
    exporting_ = true;
    export_->showStatus(tr("Starting"));
    showButtons();
    full_.start(look_, subject_, spriteRequest(setup_.values(), setup_.animation()));
}

void SpriteDialog::write(const SpriteDrawer::Frames& frames)
{
    export_->showStatus(tr("Writing"), 1);
    write_.start([this, frames, look = look_, subject = subject_, values = setup_.values(),
                  animation = setup_.animation(), file = std::filesystem::path(path().toStdString())](
                     const ProgressJob::Progress& progress) -> ProgressJob::Outcome {
        SpriteSheet sheet = sheetOf(*frames, values, animation, *subject, file.filename().string());
        sheet.settings = lookPreset(look);
        if (!progress(1)) throw Failure(Blame::check, "stopped");
        writeSheet(sheet, values, file);
        return [this, file, files = sheetFiles(values, file).size()] {
            const QString name = QString::fromStdString(file.string());
            messages_->say(MessageStrip::Mood::notice,
                           files == 1 ? tr("Saved %1.").arg(name)
                                      : tr("Saved %1, and %2 files beside it.").arg(name).arg(files - 1),
                           {}, {}, name);
            export_->setPath(nextFreePath(path()));
            endExport(QString());
        };
    });
}

void SpriteDialog::endExport(const QString& words)
{
    exporting_ = false;
    export_->showStatus(words);
    showButtons();
    emit exportEnded(words.isEmpty());
}

void SpriteDialog::reject()
{
    if (!exporting_) {
        QDialog::reject();
    } else if (write_.running()) {
        export_->showStatus(tr("Stopping"));
        write_.stop();
    } else {
        full_.stop();
        endExport(tr("Canceled; no file was written."));
    }
}

void SpriteDialog::done(int result)
{
    full_.stop();
    draft_.stop();
    write_.stop();
    remember();
    QDialog::done(result);
}

}  // namespace vitrine::ui

#include "moc_sprite_dialog.cpp"
