#include "ui/viewport/viewport.h"

#include "ui/kit/language.h"
#include "ui/kit/message_of.h"
#include "ui/kit/numbers.h"
#include "ui/kit/text.h"
#include "ui/viewport/picture_place.h"
#include "ui/viewport/shader_problems_text.h"
#include "ui/viewport/viewport_format.h"

#include <QPainter>

#include <utility>

namespace vitrine::ui {
namespace {

constexpr QColor emptyRoom(0x26, 0x23, 0x20);  // Color without a picture.

}  // namespace

Viewport::Viewport(const Museum& museum, Renderers& renderers, History& history, QWidget* parent)
    : QOpenGLWidget(parent), history_(history), clock_(museum.subjects().size()),
      visitor_(museum, history, [this]() -> const Prepared& { return scene_.prepared(); }),
      scene_(*this, museum, history, visitor_, clock_), interaction_(*this, scene_, visitor_, clock_),
      input_(*this, visitor_.control(), [this](const QPointF& at) { return interaction_.pointedAt(at); }),
      notices_(this,
               [this] {
                   scene_.lookAgain();
                   return pictures_.shown().image().isNull() ? std::vector<render::PendingAsset>()
                                                             : scene_.prepared().pending;
               }),
      thread_(std::make_unique<RenderThread>(renderers)), pictures_(scene_, clock_, visitor_, input_, *thread_),
      shaders_(renderers, *thread_)
{
    setFormat(viewportFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 90);
    setAccessibleName(tr("Museum"));
    setAccessibleDescription(tr("The picture. W A S D walk, Ctrl and the arrows look around, Enter visits."));
    connectParts();
    connectInput();
}

Viewport::~Viewport()
{
    thread_.reset();  // Its tasks use the parts.
}

void Viewport::connectParts()
{
    connect(&visitor_, &Visitor::moved, this, &Viewport::cameraChanged);
    connect(&visitor_, &Visitor::departed, this, [this] { notifyText(*this); });
    connect(&visitor_, &Visitor::headedFor, this, [this](std::size_t subject) {
        notices_.sayDestination(tr("Going to %1 …").arg(translatedText(scene_.museum().subject(subject).title())));
    });
    connect(&interaction_, &Interaction::nothingAhead, this,
            [this] { notices_.sayHint(tr("There is no exhibit in the middle of the picture.")); });
    connect(&scene_, &PresentScene::reading, this, [this] { notices_.startReading(); });
    connect(&scene_, &PresentScene::rested, this, [this] {
        const bool isShown = scene_.canBeSeen() && !pictures_.shown().image().isNull();
        if (isShown) shaders_.specialize(scene_.state(), scene_.request());
    });
    connect(&pictures_, &ViewportPictures::updated, this, [this](bool time) {
        if (time) emit looked();
        update();
    });
    connect(&pictures_, &ViewportPictures::arrived, this, [this](const DrawnPicture& picture) {
        noteArrival(picture);
        showProblems(picture.problems);
    });
    connect(&shaders_, &ShaderBuilds::reloaded, this,
            [this](bool changed, const std::vector<render::gl::ShaderProblem>& problems) {
                if (changed) scene_.change();
                showProblems(problems);
            });
}

void Viewport::connectInput()
{
    connect(&input_, &ViewportInput::turned, this, [this] { cameraChanged(false); });
    connect(&input_, &ViewportInput::clicked, &interaction_, &Interaction::click);
    connect(&input_, &ViewportInput::pressAsked, &interaction_, &Interaction::press);
    connect(&input_, &ViewportInput::actAsked, &interaction_, &Interaction::act);
    connect(&input_, &ViewportInput::walkOnAsked, &visitor_, &Visitor::walkOn);
    connect(&input_, &ViewportInput::goBackAsked, &visitor_, &Visitor::goBack);
}

void Viewport::paintGL()
{
    const QImage& image = pictures_.shown().image();
    QPainter painter(this);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    // Until a picture of the new size arrives, the old one is shown at the scale of the next one.
    const bool old = image.size() != scene_.devicePixels();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, old);
    if (old) painter.fillRect(rect(), emptyRoom);
    if (image.isNull())
        paintOpening(painter);
    else
        painter.drawImage(old ? pictureIn(image.size(), QRectF(rect())) : QRectF(rect()), image);
    pictures_.resume();  // A viewport that was hidden may have to draw.
}

void Viewport::paintOpening(QPainter& painter)
{
    // Files are read and shaders are compiled. On a slow machine this takes up to half a minute the first time.
    painter.setCompositionMode(QPainter::CompositionMode_SourceOver);
    painter.setPen(QColor(0xc9, 0xc2, 0xb8));
    painter.drawText(rect(), Qt::AlignCenter, tr("Opening the hall …"));
}

void Viewport::resizeGL(int, int)
{
    scene_.change();
    notices_.place();
    emit looked();
}

void Viewport::cameraChanged(bool cut)
{
    history_.setCamera(visitor_.control().camera());
    notices_.sayHint({});
    scene_.changeCamera(cut);
    interaction_.lookAhead();
    const std::optional<LookedAt>& button = interaction_.buttonAhead();
    notices_.sayButton(button && button->whyDisabled.empty() ? translatedText(button->text) : QString());
    input_.lookAgain();
    emit looked();
}

void Viewport::noteArrival(const DrawnPicture& picture)
{
    const bool isThere =
        !picture.abandoned && !visitor_.control().moving() && pictures_.drawnSceneState() == scene_.number();
    if (isThere || !pictures_.failure().isEmpty()) notices_.sayDestination({});
}

void Viewport::showProblems(const std::vector<render::gl::ShaderProblem>& problems)
{
    notices_.sayShaderProblems(shaderProblemsText(problems));
}

void Viewport::setCovered(bool covered)
{
    if (std::exchange(covered_, covered) == covered) return;
    input_.setNaming(!covered);
    emit looked();
}

QString Viewport::accessibleText() const
{
    const CameraControl::Standpoint there = visitor_.control().standpoint();
    if (there.mode == CameraControl::Mode::orbit)
        return tr("You look at %1, from %2 m away.")
            .arg(text(scene_.museum().subject(visitor_.subject()).title()))
            .arg(numberLocale().toString(glm::distance(there.camera.eye, there.camera.target), 'f', 1));
    const std::optional<LookedAt>& button = interaction_.buttonAhead();
    if (button && !button->whyDisabled.empty())
        return tr("You walk through the hall. The button before you is disabled: %1")
            .arg(translatedText(button->whyDisabled));
    if (button) return tr("You walk through the hall. Before you: %1.").arg(QString::fromStdString(button->text));
    const std::optional<Pointed> ahead = pictures_.shown().image().isNull() ? std::nullopt : interaction_.ahead();
    return ahead ? tr("You walk through the hall and look at %1.").arg(QString::fromStdString(ahead->name))
                 : tr("You walk through the hall.");
}

}  // namespace vitrine::ui

#include "moc_viewport.cpp"
