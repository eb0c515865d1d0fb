#include "ui/viewport/museum_gallery.h"

#include <cassert>

namespace vitrine::ui {

std::span<const std::unique_ptr<Exhibit>> MuseumGallery::exhibits() const
{
    return museum_.exhibits();
}

Look MuseumGallery::initialLook() const
{
    return museum_.initialLook();
}

render::Camera MuseumGallery::bestView(std::size_t exhibit, const ParameterValues& values) const
{
    return museum_.bestView(exhibit, values);
}

glm::dvec3 MuseumGallery::walk(const glm::dvec3& from, const glm::dvec3& to) const
{
    return museum_.walk(from, to);
}

std::optional<LookedAt> MuseumGallery::lookedAt(const Look& look) const
{
    FrameRequest request;
    request.camera = look.camera;
    return museum_.lookedAt(museum_.prepare(look, request));
}

std::optional<Pointed> MuseumGallery::pick(const Look& look, const FrameRequest& request, glm::dvec2 ndc) const
{
    return museum_.pick(museum_.prepare(look, request), request, ndc);
}

std::vector<int> MuseumGallery::emptyPlaces() const
{
    return museum_.emptyPlaces();
}

double MuseumGallery::nextChange(const Look& look, const FrameRequest& request) const
{
    return museum_.nextChange(museum_.prepare(look, request), request);
}

std::vector<std::string> MuseumGallery::unreadableFiles(const Look& look) const
{
    FrameRequest request;
    request.camera = look.camera;
    return museum_.prepare(look, request).unreadableFiles();
}

void MuseumGallery::open()
{
    renderer_ = std::make_unique<render::gl::Renderer>();
    renderer_->timeSteps(timeSteps_);
}

void MuseumGallery::close()
{
    renderer_.reset();
}

render::FrameReport MuseumGallery::draw(const Look& look, const FrameRequest& request)
{
    assert(renderer_);
    return renderer_->draw(museum_.plan(museum_.prepare(look, request), request, renderer_->kept()));
}

void MuseumGallery::present(int width, int height)
{
    renderer_->present("frame", width, height);
}

render::Image MuseumGallery::shownPicture()
{
    render::Image picture = renderer_->read("frame");
    picture.channelNames = {"R", "G", "B", "A"};
    return picture;
}

std::vector<render::gl::Stored> MuseumGallery::stored() const
{
    return renderer_ ? renderer_->stored() : std::vector<render::gl::Stored>();
}

void MuseumGallery::timeSteps(bool on)
{
    timeSteps_ = on;
    if (renderer_) renderer_->timeSteps(on);
}

bool MuseumGallery::reloadChangedShaders()
{
    return renderer_ && renderer_->reloadChangedShaders();
}

std::vector<render::gl::ShaderProblem> MuseumGallery::problems() const
{
    return renderer_ ? renderer_->problems() : std::vector<render::gl::ShaderProblem>();
}

PictureJob MuseumGallery::makePicture(const Look& look, const PictureRequest& request)
{
    PictureJob job;
    job.renderer = renderer_->sibling();
    nextPicture(job, look, request);
    return job;
}

void MuseumGallery::nextPicture(PictureJob& job, const Look& look, const PictureRequest& request)
{
    job.maker = std::make_unique<PictureMaker>(museum_, *job.renderer, look, request);
}

StudyJob MuseumGallery::makeStudy(const StudyRequest& request)
{
    StudyJob job;
    job.painter = renderer_->sibling();
    job.study = std::make_unique<Study>(museum_, *job.painter, request);
    return job;
}

}  // namespace vitrine::ui
