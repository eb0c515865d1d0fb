#include "exhibits/pixel_art/pixel_passes.h"

#include "exhibits/framework/scene/scene_lighting.h"
#include "exhibits/framework/table/derive.h"
#include "exhibits/kit/blue_noise.h"
#include "exhibits/kit/exhibit_pass.h"
#include "exhibits/kit/surface_draw.h"
#include "render/hash.h"
#include "shaders/lib/bindings.glsl"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>

namespace vitrine::pixel_art {
namespace {

using render::Attachment;

constexpr int shadowSize = 1024;
constexpr double shadowHalf = 9;  ///< Meters from the center within which objects cast shadows.
constexpr const char* shadowImage = "pixel_art.shadow";
constexpr const char* colorImage = "pixel_art.color";
constexpr const char* storedDepthImage = "pixel_art.stored_depth";
constexpr const char* facetsImage = "pixel_art.facets";
constexpr const char* emissionImage = "pixel_art.emission";

std::vector<std::string> materialDefines(const std::vector<WorldPart>& parts)
{
    std::vector<std::string> defines{"BASE_COLOR_MAP", "VERTEX_COLOR", "EMISSIVE_MAP"};
    for (const WorldPart& part : parts)
        if (part.material) addMaterialDefines(*part.material, defines);
    return defines;
}

glm::dvec3 towardsSun(const PixelArtTable& t, const ParameterValues& values)
{
    const double a = values[t.azimuth] + values[t.sunAzimuth];
    const double e = values[t.sunElevation];
    return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

/// Images and keys of one picture, and the passes that fill them.
class Picture {
public:
    Picture(const PixelShot& shot, render::FramePlan& plan);

    PixelBlock planned();

private:
    /// Makes an image. With levels it is filtered between them; otherwise shaders read texels.
    render::ResourceId image(const char* name, render::Format format, int levels = 0);
    std::vector<render::Draw> opaqueDraws() const;
    /// Returns the draws into the shadow map. Translucent parts cast a shadow where they are at least half opaque.
    std::vector<render::Draw> shadowDraws() const;
    std::vector<render::Draw> translucentDraws() const;
    bool emits() const;
    /// Returns whether one of these views is shown in either half.
    bool anyView(std::initializer_list<PixelView>) const;
    void planShadow();
    void planWorld();
    void planDepth();
    void planNormals();
    void planTranslucent();
    void planLook();
    void planDiffusion();
    /// Returns a pass over the whole picture, with everything bound that its shader may read.
    render::Pass over(std::string name, std::string reason, const char* fragment) const;

    const PixelShot& shot_;
    const PixelArtTable& table_;
    const ParameterValues& values_;
    render::FramePlan& plan_;
    PixelEye eye_;
    render::View sunView_;
    std::uint64_t worldKey_ = 0, shadowKey_ = 0, key_ = 0;
    std::string depth_;
    bool shadowed_ = false;  ///< Whether the sun's shadow map is drawn.
    bool normals_ = true;    ///< Whether a view needs normals.
};

Picture::Picture(const PixelShot& shot, render::FramePlan& plan)
    : shot_(shot), table_(shot.table), values_(shot.values), plan_(plan),
      eye_(pixelView(shot.camera, shot.values[table_.snap]))
{
    const glm::dvec3 sun = towardsSun(table_, values_);
    render::Box box = boundsOf(shot_.parts);
    box.low = glm::clamp(box.low, glm::dvec3(-shadowHalf), glm::dvec3(shadowHalf));
    box.high = glm::clamp(box.high, glm::dvec3(-shadowHalf), glm::dvec3(shadowHalf));
    if (box.empty()) box = {glm::dvec3(-1), glm::dvec3(1)};
    sunView_ = lightView(box, sun, glm::ivec2(shadowSize), 6);
    PixelBlock& block = eye_.block;
    block.sun = glm::vec3(eye_.view.viewFromWorld * glm::dvec4(sun, 0));
    block.shadowFromView = shadowFromWorld(sunView_) * block.worldFromView;
    block.standardDepth = values_[table_.depthOrder] == DepthOrder::standard;
    const DepthBits bits = values_[table_.depthBits];
    block.depthLevels = bits == DepthBits::unorm16 ? 65535.0F : bits == DepthBits::unorm24 ? 16777215.0F : 0.0F;
    block.time = static_cast<float>(shot_.time);
    if (values_[table_.split])
        block.divider = static_cast<int>(std::floor(values_[table_.divider] * shot_.camera.size.x + 0.5));

    render::Hash parts;
    parts.addValue(shot_.partsId).addValue(static_cast<int>(values_[table_.world]));
    for (const WorldPart& part : shot_.parts) parts.addValue(part.worldFromModel);
    shadowKey_ = render::Hash(parts).addValue(sunView_.clipFromWorld).value();
    worldKey_ =
        render::Hash(parts).addValue(eye_.view.clipFromWorld).addValue(shot_.camera.size).addValue(shot_.time).value();
    render::Hash all = render::Hash(parts).addValue(worldKey_).addValue(shadowKey_);
    derive::addToKey(all, values_);
    const render::Bytes bytes = render::std140Bytes(block);
    all.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    all.addValue(shot_.keepsLit).addValue(shot_.seenSmaller);
    if (shot_.palette)
        for (const Rgb8& c : shot_.palette->colors) all.addValue(c);
    key_ = all.value();
}

render::ResourceId Picture::image(const char* name, render::Format format, int levels)
{
    return plan_.image({.name = name,
                        .format = format,
                        .size = shot_.camera.size,
                        .levels = std::max(levels, 1),
                        .persistent = true,
                        .nearest = levels == 0,
                        .ownPixels = levels == 0});
}

render::Draw drawOf(const WorldPart& part, const render::Material& material)
{
    render::Draw draw = surfaceDraw(part.mesh, part.worldFromModel, material);
    PixelObjectBlock object;
    object.surface = surfaceObject(part.worldFromModel, material);
    object.id = static_cast<float>(part.firstId);
    object.painted = part.material == nullptr;
    draw.object = render::std140Bytes(object);
    std::erase_if(draw.inputs, [](const render::SampledTexture& input) {
        return input.unit != UNIT_BASE_COLOR && input.unit != UNIT_EMISSIVE;
    });
    return draw;
}

std::vector<render::Draw> Picture::opaqueDraws() const
{
    std::vector<render::Draw> draws;
    for (const WorldPart& part : shot_.parts)
        if (!isTranslucent(part)) draws.push_back(drawOf(part, part.material ? *part.material : render::Material{}));
    return draws;
}

std::vector<render::Draw> Picture::shadowDraws() const
{
    std::vector<render::Draw> draws = opaqueDraws();
    for (const WorldPart& part : shot_.parts) {
        if (!isTranslucent(part)) continue;
        render::Material material = *part.material;
        material.alphaMode = render::AlphaMode::mask;
        material.alphaCutoff = 0.5F;
        draws.push_back(drawOf(part, material));
    }
    return draws;
}

bool Picture::anyView(std::initializer_list<PixelView> views) const
{
    const auto shows = [&](PixelView view) { return std::find(views.begin(), views.end(), view) != views.end(); };
    return shows(values_[table_.view]) || (values_[table_.split] && shows(values_[table_.rightView]));
}

std::vector<render::Draw> Picture::translucentDraws() const
{
    std::vector<TranslucentPart> parts;
    for (const WorldPart& part : shot_.parts)
        if (isTranslucent(part))
            parts.push_back({drawOf(part, *part.material), part.mesh->bounds.transformed(part.worldFromModel),
                             part.material->doubleSided});
    return farToNear(parts, eye_.view.eye);
}

bool Picture::emits() const
{
    return std::any_of(shot_.parts.begin(), shot_.parts.end(), [](const WorldPart& part) {
        return part.material && !isTranslucent(part) &&
               (part.material->unlit || part.material->emissive != glm::vec3(0));
    });
}

void Picture::planShadow()
{
    const glm::dvec3 sun = values_[table_.sunLight].value;
    // Lines of the adaptive edges are lighter in the sun.
    const bool lines = values_[table_.highlightStrength] > 0 && values_[table_.edges] == EdgeLook::adaptive;
    const std::string why = render::whyZero(
        {render::required(anyView({PixelView::finished}), "no shown view has shadows"),
         render::required(values_[table_.shadows], "shadows are off"),
         render::required(lines || std::max({sun.x, sun.y, sun.z}) > 0, "the light of the sun is black")});
    shadowed_ = why.empty();
    if (!shadowed_) return plan_.skip("pixel_art/sun", why);
    plan_.image({.name = shadowImage,
                 .format = render::Format::depth32f,
                 .size = glm::ivec2(shadowSize),
                 .persistent = true,
                 .comparison = true,
                 .ownPixels = true});
    render::Pass pass;
    pass.name = "pixel_art/sun";
    pass.reason = "finds the parts that the sun of the small world reaches";
    pass.phase = render::PassPhase::prepare;
    const bool masked = std::any_of(shot_.parts.begin(), shot_.parts.end(), [](const WorldPart& part) {
        return part.material && part.material->alphaMode != render::AlphaMode::opaque;
    });
    pass.shader = {.vertex = "pixel_art/shadow.vert", .fragment = masked ? "pixel_art/shadow.frag" : "kit/depth.frag"};
    if (masked) {
        pass.shader.defines = materialDefines(shot_.parts);
        std::erase(pass.shader.defines, "UNLIT");
        pass.shader.defines.emplace_back("MASKED");
    }
    pass.view = sunView_;
    pass.contentHash = shadowKey_;
    pass.depth = Attachment::cleared(shadowImage);
    pass.state.depthTest = render::DepthTest::nearer;
    pass.state.depthWrite = true;
    pass.state.depthClamp = true;
    pass.state.depthBias = {1.5F, 2};
    pass.draws = shadowDraws();
    plan_.add(std::move(pass));
}

void Picture::planWorld()
{
    image(colorImage, render::Format::rgba16f);
    image(pixelTruthImage, render::Format::rgba16f);
    image(pixelDrawnDepthImage, render::Format::depth32f);
    render::Pass pass;
    pass.name = "pixel_art/world";
    pass.reason = "the camera, time or world has changed";
    pass.phase = render::PassPhase::prepare;
    pass.shader = {
        .vertex = "pixel_art/world.vert", .fragment = "pixel_art/world.frag", .defines = materialDefines(shot_.parts)};
    pass.view = eye_.view;
    pass.contentHash = worldKey_;
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(eye_.block);
    pass.colors = {Attachment::cleared(colorImage), Attachment::cleared(pixelTruthImage)};
    pass.depth = Attachment::cleared(pixelDrawnDepthImage);
    pass.state.depthTest = render::DepthTest::nearer;
    pass.state.depthWrite = true;
    pass.draws = opaqueDraws();
    if (emits()) {
        pass.shader.defines.emplace_back("EMISSION");
        image(emissionImage, render::Format::rgba16f);
        pass.colors.push_back(Attachment::cleared(emissionImage));
    }
    plan_.add(std::move(pass));
}

void Picture::planTranslucent()
{
    if (!hasTranslucent(shot_.parts)) {
        plan_.skip("pixel_art/translucent", "nothing in the picture is translucent");
        return;
    }
    render::Pass pass =
        over("pixel_art/translucent", "parts of the model are translucent", "pixel_art/translucent.frag");
    pass.shader.vertex = "pixel_art/world.vert";
    for (std::string& define : materialDefines(shot_.parts)) pass.shader.defines.push_back(std::move(define));
    if (shadowed_) pass.shader.defines.emplace_back("SHADOWS");
    pass.view = eye_.view;
    for (const char* name : {pixelTranslucentImage, pixelTranslucentNormalImage}) {
        image(name, render::Format::rgba16f);
        pass.colors.push_back(Attachment::cleared(name));
    }
    image(pixelTranslucentDepthImage, render::Format::r32f);
    pass.colors.push_back(Attachment::cleared(pixelTranslucentDepthImage));
    pass.depth = Attachment::whole(pixelDrawnDepthImage);
    pass.state.depthTest = render::DepthTest::nearer;
    pass.state.blend = render::Blend::premultiplied;
    if (shadowed_) pass.inputs = {{UNIT_SHADOW_EXHIBITS, shadowImage}};
    pass.draws = translucentDraws();
    plan_.add(std::move(pass));
}

render::Pass Picture::over(std::string name, std::string reason, const char* fragment) const
{
    render::Pass pass = exhibitPass(std::move(name), std::move(reason), values_, "lib/fullscreen.vert", fragment);
    pass.phase = render::PassPhase::prepare;
    pass.contentHash = key_;
    pass.blocks[BLOCK_EXHIBIT] = render::std140Bytes(eye_.block);
    pass.draws = {render::Draw{}};
    if (shot_.camera.orthographic) pass.shader.defines.emplace_back("ORTHOGRAPHIC");
    if (values_[table_.depthOrder] == DepthOrder::standard) pass.shader.defines.emplace_back("STANDARD_DEPTH");
    return pass;
}

void Picture::planDepth()
{
    depth_ = pixelDrawnDepthImage;
    if (values_[table_.depthBits] == DepthBits::float32 && values_[table_.depthOrder] == DepthOrder::reversed) {
        plan_.skip("pixel_art/depth", "the depth is stored when it is drawn");
        return;
    }
    depth_ = image(storedDepthImage, render::Format::r32f);
    render::Pass pass = over("pixel_art/depth", "another kind of depth buffer is selected", "pixel_art/depth.frag");
    pass.colors = {Attachment::whole(storedDepthImage)};
    pass.inputs = {{UNIT_SOURCE, pixelDrawnDepthImage}};
    plan_.add(std::move(pass));
}

void Picture::planNormals()
{
    normals_ = shot_.keepsLit || anyView({PixelView::finished, PixelView::normals, PixelView::error, PixelView::edges});
    if (!normals_) {
        for (const char* name : {"pixel_art/normals", "pixel_art/smooth"}) plan_.skip(name, "only depth is shown");
        return;
    }
    const bool smooth = values_[table_.smoothing] > 0;
    const NormalsBy left = values_[table_.method];
    const NormalsBy right = values_[table_.split] ? values_[table_.rightMethod] : left;
    image(pixelSurfaceImage, render::Format::rgba32f);
    if (smooth) image(facetsImage, render::Format::rgba32f);
    render::Pass pass = over("pixel_art/normals", "one for every texel", "pixel_art/normals.frag");
    pass.shader.defines.push_back("LEFT_METHOD " + std::to_string(static_cast<int>(left)));
    pass.shader.defines.push_back("RIGHT_METHOD " + std::to_string(static_cast<int>(right)));
    pass.colors = {Attachment::whole(smooth ? facetsImage : pixelSurfaceImage)};
    pass.inputs = {{UNIT_EXHIBIT_A, depth_}, {UNIT_NORMAL, pixelTruthImage}};
    const std::int64_t lefts = eye_.block.divider, rights = shot_.camera.size.x - eye_.block.divider;
    pass.counts["depthFetches"] = shot_.camera.size.y * (lefts * fetchesOf(left) + rights * fetchesOf(right));
    plan_.add(std::move(pass));
    if (!smooth) {
        plan_.skip("pixel_art/smooth", "smoothing is 0");
        return;
    }
    render::Pass mean = over("pixel_art/smooth", "facets are averaged", "pixel_art/smooth.frag");
    mean.colors = {Attachment::whole(pixelSurfaceImage)};
    mean.inputs = {{UNIT_NORMAL, facetsImage}};
    plan_.add(std::move(mean));
}

void Picture::planLook()
{
    const bool diffused = shot_.palette && values_[table_.dither] == Dither::errorDiffusion;
    render::Pass pass = over("pixel_art/look", "light, lines and palette", "pixel_art/look.frag");
    std::vector<std::string>& defines = pass.shader.defines;
    const PixelView left = values_[table_.view];
    const PixelView right = values_[table_.split] ? values_[table_.rightView] : left;
    defines.push_back("LEFT_VIEW " + std::to_string(static_cast<int>(left)));
    defines.push_back("RIGHT_VIEW " + std::to_string(static_cast<int>(right)));
    if (values_[table_.outlineStrength] > 0 || values_[table_.highlightStrength] > 0) defines.emplace_back("LINES");
    if (values_[table_.edges] == EdgeLook::reference) defines.emplace_back("REFERENCE_EDGES");
    pass.inputs = {{UNIT_BASE_COLOR, colorImage},
                   {UNIT_NORMAL, normals_ ? pixelSurfaceImage : depth_},
                   {UNIT_ORM, pixelTruthImage}};
    if (!normals_) defines.emplace_back("DEPTH_ALONE");
    if (shadowed_) {
        defines.emplace_back("SHADOWS");
        pass.inputs.push_back({UNIT_SHADOW_EXHIBITS, std::string(shadowImage)});
    }
    if (emits()) {
        defines.emplace_back("EMISSION");
        pass.inputs.push_back({UNIT_SOURCE, emissionImage});
    }
    if (hasTranslucent(shot_.parts)) {
        defines.emplace_back("TRANSLUCENT");
        pass.inputs.push_back({UNIT_BACKDROP, pixelTranslucentImage});
    }
    const int all = 1 + static_cast<int>(std::floor(std::log2(std::max(shot_.camera.size.x, shot_.camera.size.y))));
    image(pixelShownImage, render::Format::rgba16f, shot_.seenSmaller ? all : 1);
    const auto writes = [&](const char* define, const char* name) {
        defines.push_back(define + (' ' + std::to_string(pass.colors.size())));
        pass.colors.push_back(Attachment::whole(name));
    };
    if (!diffused) {
        writes("SHOWN", pixelShownImage);
        if (shot_.seenSmaller) pass.mipmaps = {pixelShownImage};
    }
    if (diffused || shot_.keepsLit) {
        image(pixelLitImage, render::Format::rgba16f);
        writes("LIT", pixelLitImage);
    }
    if (shot_.palette && !diffused) {
        defines.emplace_back("PALETTE");
        if (values_[table_.dither] == Dither::ordered) defines.emplace_back("ORDERED");
        if (values_[table_.dither] == Dither::blueNoise) defines.emplace_back("BLUE_NOISE");
        pass.inputs.push_back({UNIT_EXHIBIT_B, shot_.palette->linear});
        pass.inputs.push_back({UNIT_EXHIBIT_C, shot_.palette->nearest});
        pass.inputs.push_back({UNIT_EMISSIVE, blueNoise()});
    }
    plan_.add(std::move(pass));
    if (diffused)
        planDiffusion();
    else
        plan_.skip("pixel_art/diffuse", "error diffusion is off", render::Work::compute);
}

void Picture::planDiffusion()
{
    render::Pass pass = over("pixel_art/diffuse", "diffuses the errors to neighbors", "");
    pass.shader.vertex = pass.shader.fragment = {};
    pass.shader.compute = "pixel_art/diffuse.comp";
    pass.work = render::Work::compute;
    pass.draws.clear();
    pass.inputs = {{UNIT_SOURCE, pixelLitImage},
                   {UNIT_EXHIBIT_B, shot_.palette->linear},
                   {UNIT_EXHIBIT_C, shot_.palette->nearest}};
    pass.storage = {Attachment::whole(pixelShownImage)};
    const std::string errors = plan_.buffer({"pixel_art.errors", std::int64_t{257} * shot_.camera.size.x * 16});
    pass.buffers = {{STORAGE_EXHIBIT_A, errors, render::Access::readWrite}};
    if (shot_.seenSmaller) pass.mipmaps = {pixelShownImage};
    plan_.add(std::move(pass));
}

PixelBlock Picture::planned()
{
    planShadow();
    planWorld();
    planDepth();
    planNormals();
    planTranslucent();
    planLook();
    return eye_.block;
}

}  // namespace

bool isTranslucent(const WorldPart& part)
{
    return part.material && part.material->alphaMode == render::AlphaMode::blend;
}

bool hasTranslucent(const std::vector<WorldPart>& parts)
{
    return std::any_of(parts.begin(), parts.end(), isTranslucent);
}

int fetchesOf(NormalsBy method)
{
    switch (method) {
    case NormalsBy::trueNormals: return 1;
    case NormalsBy::tap3: return 3;
    case NormalsBy::tap4: return 5;
    case NormalsBy::tap5: return 5;
    case NormalsBy::tap9: return 13;
    case NormalsBy::tap9Plus:
    case NormalsBy::parabola: return 9;
    case NormalsBy::vote: break;
    }
    return 17;
}

render::Image normalsOf(const render::Image& surfaces)
{
    render::Image normals = surfaces;
    for (std::size_t i = 0; i < normals.pixels.size(); i += 4) {
        const float* packed = surfaces.pixels.data() + i;
        const glm::vec2 across = glm::unpackHalf2x16(std::bit_cast<std::uint32_t>(packed[0]) ^ 0x40000000U);
        const std::array<float, 4> normal{across.x, across.y, packed[1], packed[3]};
        std::copy(normal.begin(), normal.end(), normals.pixels.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return normals;
}

PixelBlock planPixelPicture(const PixelShot& shot, render::FramePlan& plan)
{
    return Picture(shot, plan).planned();
}

}  // namespace vitrine::pixel_art
