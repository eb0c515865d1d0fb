#include "ui/editor/live_text.h"

#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/museum/museum.h"
#include "ui/kit/language.h"
#include "ui/model/history.h"
#include "ui/model/workbench.h"
#include "ui/viewport/viewport.h"

#include <QFileInfo>
#include <QStringDecoder>

#include <algorithm>
#include <utility>

namespace vitrine::ui {

QString editedText(const std::string& bytes)
{
    QStringDecoder utf8(QStringDecoder::Utf8);
    QString text = utf8(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    return utf8.hasError() ? QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size())) : text;
}

LiveText::LiveText(Workbench& window, QObject* parent) : QObject(parent), window_(window)
{
    timer_.setSingleShot(true);
    timer_.setTimerType(Qt::PreciseTimer);
    connect(&timer_, &QTimer::timeout, this, &LiveText::paused);
    connect(&window.viewport().scene(), &PresentScene::filesChanged, this, &LiveText::load);
}

LiveText::~LiveText()
{
    if (check_.valid()) check_.wait();
}

const ParameterValues& LiveText::values() const
{
    return window_.history().sceneState().values[subject_];
}

DocumentPlace LiveText::place() const
{
    return source_ ? source_->document(values()) : DocumentPlace{};
}

void LiveText::setSubject(std::size_t exhibit)
{
    flush();
    isTyped_ = false;
    checked_.reset();
    disconnect(watched_);
    subject_ = exhibit;
    source_ = capability<HasText>(window_.museum().subject(exhibit));
    findings_.clear();
    text_.clear();
    if (!source_) return;
    watched_ = window_.history().watch(exhibit, this, [this](std::optional<std::size_t> row) {
        // A slider of the shader changes no text.
        if (applying_ || (row && !values().rows()[*row].addsParameters)) return;
        load();
    });
    load();
    emit replaced();
}

void LiveText::load()
{
    if (!source_ || isTyped_) return;  // The typed text is newer.
    const QString now = editedText(source_->documentText(values()));
    if (now == text_) return;
    text_ = now;
    checked_.reset();
    emit replaced();
    check();
}

void LiveText::edit(const QString& text)
{
    if (!source_ || text == text_) return;
    text_ = text;
    isTyped_ = true;
    checked_.reset();
    sinceKey_.start();
    timer_.start(pause);
    check();
    emit checked();
}

void LiveText::flush()
{
    if (!source_ || !timer_.isActive()) return;
    timer_.stop();
    setDraft(text_.toStdString());  // As a text with errors until the check says otherwise.
    paused();
}

void LiveText::begin(const TextTemplate& from)
{
    if (!source_) return;
    flush();
    SceneState next = window_.history().sceneState();
    next.values[subject_].chooseFile(place().file, from.file);
    window_.history().change(tr("New shader: %1").arg(translatedText(from.title)), next);
}

void LiveText::check()
{
    if (!source_ || running_) return;  // When the present check ends, the newest text is checked.
    running_ = text_.toStdString();
    if (check_.valid()) check_.wait();
    emit checked();
    check_ = std::async(std::launch::async, [this, source = source_, values = values(), text = *running_,
                                             assets = window_.museum().assets()]() mutable {
        std::vector<TextFinding> findings = source->withText(values, text, assets).findings;
        QMetaObject::invokeMethod(
            this, [this, text, findings = std::move(findings)]() mutable { finishCheck(text, std::move(findings)); },
            Qt::QueuedConnection);
    });
}

void LiveText::finishCheck(const std::string& text, std::vector<TextFinding> findings)
{
    running_.reset();
    if (!source_) return;
    if (text_.toStdString() != text) return check();
    checked_ = Checked{text, std::move(findings)};
    if (!timer_.isActive()) paused();
}

void LiveText::paused()
{
    if (!checked_) return check();
    const bool hasErrors = std::any_of(checked_->findings.begin(), checked_->findings.end(),
                                       [](const TextFinding& each) { return each.isError; });
    if (hasErrors && isTyped_ && sinceKey_.elapsed() < errorPause)
        return timer_.start(errorPause - static_cast<int>(sinceKey_.elapsed()));
    take(*std::exchange(checked_, std::nullopt));
}

void LiveText::take(Checked result)
{
    const std::string text = std::move(result.text);
    findings_ = std::move(result.findings);
    const bool isDraft = !std::get<std::string>(values().row(*place().draft)).empty();
    if (isDraft || (isTyped_ && editedText(source_->documentText(values())) != text_)) apply(text);
    isTyped_ = false;
    emit checked();
}

void LiveText::setDraft(const std::string& text)
{
    SceneState state = window_.history().sceneState();
    state.values[subject_].setParameter(*place().draft, text);
    applying_ = true;
    window_.history().settle(state);
    applying_ = false;
}

void LiveText::apply(const std::string& text)
{
    render::AssetStore assets = window_.museum().assets();
    if (!source_->withText(values(), text, assets).isShown) return setDraft(text);
    beginDocument();
    SceneState next = window_.history().sceneState();
    next.values[subject_] = source_->withText(values(), text, assets).values;
    applying_ = true;
    window_.history().change(tr("Edit %1").arg(QFileInfo(QString::fromStdString(place().path)).fileName()), next,
                             newGesture());
    applying_ = false;
}

void LiveText::beginDocument()
{
    // Undo leads back to good texts only, and to the one that was edited, whatever happens to its file.
    setDraft({});
    if (!std::get<std::string>(values().row(place().document)).empty()) return;
    SceneState state = window_.history().sceneState();
    state.values[subject_].setParameter(place().document, source_->documentText(values()));
    applying_ = true;
    window_.history().settle(state);
    applying_ = false;
}

}  // namespace vitrine::ui

#include "moc_live_text.cpp"
