#include "ui/record/film_maker.h"

#include "render/failure.h"
#include "ui/kit/time_left.h"
#include "ui/viewport/renderers.h"

namespace vitrine::ui {

struct FilmMaker::Work {
    FilmWish wish;
    std::unique_ptr<render::RenderBackend> backend;
    std::unique_ptr<Recording> recording;  ///< Goes before what it draws with.
    QElapsedTimer told;
};

FilmMaker::FilmMaker(const Museum& museum, Renderers& renderers, RenderThread& thread, QObject* parent)
    : QObject(parent), museum_(museum), renderers_(renderers), thread_(thread)
{
}

FilmMaker::~FilmMaker()
{
    stop();
}

void FilmMaker::start(FilmWish wish)
{
    stop();
    auto work = std::make_shared<Work>();
    work->wish = std::move(wish);
    running_ = true;
    elapsed_.start();
    task_ = thread_.start(
        [this, work, &museum = museum_, &renderers = renderers_](const RenderThread::Tell& tell) {
            if (!work->recording) {
                work->backend = renderers.makeBackend(false);
                if (!work->backend)
                    throw Failure(Blame::openGl, "No film can be recorded: there is no graphics context.");
                const FilmWish& wished = work->wish;
                work->recording = std::make_unique<Recording>(museum, *work->backend, wished.sceneState, wished.subject,
                                                              wished.request(), wished.path);
            }
            work->recording->step();
            if (!work->told.isValid() || work->told.elapsed() >= RenderThread::tellEvery) {
                work->told.start();
                tell([this, part = work->recording->progress()] { note(part); });
            }
            if (!work->recording->finished()) return true;
            work->recording.reset();
            work->backend.reset();
            return false;
        },
        [this](const QString& failure) { end(failure); });
}

void FilmMaker::stop()
{
    task_.cancel();
    running_ = false;
}

void FilmMaker::note(double part)
{
    emit progressed(part, secondsLeft(part, elapsed_));
}

void FilmMaker::end(const QString& failure)
{
    stop();
    if (failure.isEmpty())
        emit finished();
    else
        emit failed(failure);
}

}  // namespace vitrine::ui

#include "moc_film_maker.cpp"
