#include "exhibits/your_shader/guest_work.h"

#include "exhibits/your_shader/guest_glsl.h"
#include "exhibits/your_shader/your_shader_table.h"
#include "render/failure.h"
#include "render/glsl/lexer.h"
#include "render/hash.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace vitrine::guest {
namespace {

namespace fs = std::filesystem;

/// Words of a program. A declared variable that occurs once is not used.
class Words {
public:
    explicit Words(const PassProgram& program)
    {
        count(program.vertex);
        count(program.fragment);
    }
    [[nodiscard]] bool uses(const std::string& visitorsName) const
    {
        const auto found = used_.find(programName(visitorsName));
        return found != used_.end() && found->second;
    }

private:
    void count(const std::string& text)
    {
        const render::Tokens tokens(text);
        std::map<std::string_view, int> counts;
        for (std::size_t i = 0; i < tokens.size(); ++i) ++counts[tokens.text(i)];
        for (const auto& [word, times] : counts) used_[std::string(word)] |= times > 1;
    }

    std::map<std::string, bool> used_;
};

/// Returns the text without its `#version` line, which the shader loader writes.
std::string withoutVersion(const std::string& glsl)
{
    const std::size_t newline = glsl.find('\n');
    return glsl.starts_with("#version") && newline != std::string::npos ? glsl.substr(newline + 1) : glsl;
}

bool isTime(std::string_view name)
{
    static constexpr std::string_view names[] = {"TIME",       "TIMEDELTA", "DATE",   "FRAMEINDEX",   "iTime",
                                                 "iTimeDelta", "iFrame",    "iDate",  "iChannelTime", "u_time",
                                                 "u_delta",    "u_frame",   "u_date", "time"};
    return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool isMouse(std::string_view name)
{
    return name == "iMouse" || name == "u_mouse" || name == "mouse";
}

/// Makes a work of a shader and its programs.
class Maker {
public:
    Maker(const CheckedShader& checked, const fs::path& path) : checked_(checked), shader_(*checked.shader)
    {
        work_.shader = checked.shader;
        work_.path = path;
    }

    std::shared_ptr<const Work> make(std::vector<Finding>& errors)
    {
        for (const Pass& pass : shader_.passes) targetOf(pass);
        for (std::size_t i = 0; i < shader_.passes.size(); ++i) {
            const WorkPass made = passOf(i);
            if (!error_.sentence.empty()) {
                errors.push_back(error_);
                return nullptr;
            }
            work_.passes.push_back(made);
        }
        for (const Target& target : work_.targets) work_.isKept = work_.isKept || target.isKept;
        for (const SourceFile& file : shader_.files)
            if (file.name != work_.path.string()) work_.beside.push_back(file.name);
        render::Hash id;
        for (const WorkPass& pass : work_.passes) id.addValue(pass.sources->hash());
        work_.id = id.value();
        return std::make_shared<const Work>(std::move(work_));
    }

private:
    /// Returns the index of a pass's target, which is added if it is new.
    std::size_t targetOf(const Pass& pass)
    {
        const bool isPicture = pass.target.empty();
        const std::string name = !isPicture ? pass.target : shader_.inputNamed("backbuffer") ? "backbuffer" : "picture";
        const auto known = indexOf(name);
        if (known < work_.targets.size()) {
            work_.targets[known].isFloat |= pass.isFloat;
            work_.targets[known].isPersistent |= pass.isPersistent;
            return known;
        }
        work_.targets.push_back({.name = name,
                                 .isFloat = pass.isFloat,
                                 .isPersistent = pass.isPersistent,
                                 .isCube = pass.isCube,
                                 .width = pass.width,
                                 .height = pass.height});
        return known;
    }
    [[nodiscard]] std::size_t indexOf(const std::string& name) const
    {
        const auto found = std::find_if(work_.targets.begin(), work_.targets.end(),
                                        [&](const Target& target) { return target.name == name; });
        return static_cast<std::size_t>(found - work_.targets.begin());
    }

    WorkPass passOf(std::size_t i)
    {
        const Pass& pass = shader_.passes[i];
        const PassProgram& program = checked_.programs[i];
        const Words words(program);
        WorkPass made;
        made.sources = std::make_shared<const render::ShaderSources>(std::map<std::string, std::string>{
            {generatedVertex, withoutVersion(program.vertex)}, {generatedFragment, withoutVersion(program.fragment)}});
        made.target = targetOf(pass);
        int unit = 0;
        for (const PictureUse& use : picturesOf(shader_, pass)) {
            if (words.uses(use.name)) made.pictures.push_back(pictureOf(use, i, unit));
            ++unit;
        }
        for (const BuiltIn& builtIn : shader_.builtIns) {
            if (!words.uses(builtIn.name)) continue;
            work_.readsTime = work_.readsTime || isTime(builtIn.name);
            work_.readsMouse = work_.readsMouse || isMouse(builtIn.name);
        }
        for (const Input& input : shader_.inputs)
            work_.readsTime = work_.readsTime || (input.type == InputType::event && words.uses(input.name));
        return made;
    }

    PassPicture pictureOf(const PictureUse& use, std::size_t pass, int unit)
    {
        switch (use.source) {
        case PictureUse::Source::target: return readTarget(use.name, pass, unit);
        case PictureUse::Source::import: return readFile(shader_.imports[use.index].path, unit);
        case PictureUse::Source::channel: return readChannel(shader_.passes[pass].channels[use.index], pass, unit);
        case PictureUse::Source::input: break;
        }
        const Input& input = shader_.inputs[use.index];
        if (input.source == "buffer") return readTarget(input.name, pass, unit);
        if (input.glslType != "sampler2D") return {unit, builtIn(input.glslType, input.name), 0};
        if (input.type == InputType::image) return {unit, PassPicture::From::input, use.index};
        work_.readsTime = true;
        const bool isWaveform = input.type == InputType::audio;
        return {unit, isWaveform ? PassPicture::From::waveform : PassPicture::From::spectrum, use.index};
    }
    /// Returns the built-in cube map or volume. Shadertoy's volume of gray noise is known by the name of its file.
    static PassPicture::From builtIn(const std::string& glslType, const std::string& name)
    {
        if (glslType == "samplerCube") return PassPicture::From::environment;
        const bool isGray = name.find("gray") != std::string::npos ||
                            name.find("27012b4eadd0c3ce12498b867058e4f7") != std::string::npos;
        return isGray ? PassPicture::From::grayNoise : PassPicture::From::colorNoise;
    }
    PassPicture readChannel(const Channel& channel, std::size_t pass, int unit)
    {
        const std::string name = channel.source == "self" ? nameOfTarget(pass) : channel.source;
        const std::size_t target = indexOf(name);
        const bool isCube = channel.glslType == "samplerCube";
        if (target < work_.targets.size() && work_.targets[target].isCube == isCube &&
            (isCube || channel.kind == "buffer")) {
            work_.targets[target].isNearest |= channel.filter == "nearest";
            work_.targets[target].hasLevels |= channel.filter == "mipmap";
            work_.targets[target].repeats |= channel.wrap == "repeat" || channel.wrap == "Repeat";
            return readTarget(name, pass, unit);
        }
        if (channel.kind == "keyboard") {
            work_.readsKeys = work_.readsTime = true;
            return {unit, PassPicture::From::keyboard, 0};
        }
        if (channel.glslType != "sampler2D") return {unit, builtIn(channel.glslType, channel.source), 0};
        const bool isFile = channel.kind == "texture" && !channel.source.empty() && !channel.source.starts_with('/');
        if (!isFile) return {unit, PassPicture::From::nothing, 0};
        return readFile(channel.source, unit);
    }
    /// A picture of the shader's folder, or of a folder in it. Links do not lead out of it.
    PassPicture readFile(const std::string& name, int unit)
    {
        std::error_code error;
        const fs::path folder = fs::weakly_canonical(fs::absolute(work_.path).parent_path(), error);
        const fs::path file = fs::weakly_canonical(folder / name, error);
        const fs::path inFolder = file.lexically_relative(folder);
        if (error || inFolder.empty() || *inFolder.begin() == "..") {
            error_ = {.file = shader_.files.front().name,
                      .sentence = message("The picture “{1}” is not in the shader's folder; copy it there.", name)};
            return {};
        }
        work_.files.push_back(file);
        return {unit, PassPicture::From::file, work_.files.size() - 1};
    }
    [[nodiscard]] std::string nameOfTarget(std::size_t pass)
    {
        return work_.targets[targetOf(shader_.passes[pass])].name;
    }

    /// A target that an earlier pass drew is read as it is now, and a persistent one as the step before left it.
    PassPicture readTarget(const std::string& name, std::size_t pass, int unit)
    {
        const std::size_t target = indexOf(name);
        if (target == work_.targets.size()) return {unit, PassPicture::From::nothing, 0};
        work_.targets[target].isRead = true;
        bool isDrawn = false;
        for (std::size_t i = 0; i < pass; ++i) isDrawn = isDrawn || targetOf(shader_.passes[i]) == target;
        if (isDrawn && targetOf(shader_.passes[pass]) != target) return {unit, PassPicture::From::thisStep, target};
        // The passes of an ISF share one text, so that each seems to read every target. What no step keeps is black.
        if (!work_.targets[target].isPersistent) return {unit, PassPicture::From::nothing, 0};
        work_.targets[target].isKept = true;
        return {unit, PassPicture::From::stepBefore, target};
    }

    const CheckedShader& checked_;
    const Shader& shader_;
    Work work_;
    Finding error_;
};

std::shared_ptr<const WorkReading> readNow(const fs::path& path, const std::string& text,
                                           const std::vector<PictureSource>& sources)
{
    auto reading = std::make_shared<WorkReading>();
    const auto see = [&](const fs::path& file) { reading->files.emplace_back(file, render::fileState(file)); };
    if (text.empty()) see(path);
    see(fs::path(path).replace_extension(".vs"));
    try {
        // One compiler for all threads: it answers within milliseconds.
        static std::mutex mutex;
        static ShaderCompiler compiler;
        const std::lock_guard lock(mutex);
        CheckedShader checked = translate(text.empty() ? readShaderFile(path) : readShaderText(text, path), compiler);
        if (checked.shader)
            for (const SourceFile& file : checked.shader->files)
                if (file.name != path.string()) see(file.name);
        std::shared_ptr<const Work> work = checked.isGood() ? makeWork(checked, path, checked.errors) : nullptr;
        if (work) {
            for (const fs::path& file : work->files) see(file);
            reading->findings = checked.shader->notes;
            reading->table = std::make_shared<const YourShaderTable>(std::move(work), sources);
            return reading;
        }
        reading->findings = checked.errors;
        const Finding& first = checked.errors.front();
        reading->why = checked.fileRead
                           ? message("{1}:{2}:{3}: {4}", first.file, first.line, first.column, first.sentence)
                           : first.sentence;
    } catch (const Failure& failure) {
        reading->why = failure.message();
    }
    return reading;
}

/// Returns a hash of the states of the files that were read; 0 while they are unchanged.
std::uint64_t changesOf(const WorkReading& reading)
{
    render::Hash hash;
    bool same = true;
    for (const auto& [path, state] : reading.files) {
        const render::FileState now = render::fileState(path);
        same = same && now == state;
        render::addTo(hash.add(path.string()), now);
    }
    return same ? 0 : std::max<std::uint64_t>(hash.value(), 1);
}

}  // namespace

std::shared_ptr<const Work> makeWork(const CheckedShader& checked, const fs::path& path, std::vector<Finding>& errors)
{
    return Maker(checked, path).make(errors);
}

bool Work::readsPicture(std::size_t input) const
{
    return std::any_of(passes.begin(), passes.end(), [&](const WorkPass& pass) {
        return std::any_of(pass.pictures.begin(), pass.pictures.end(), [&](const PassPicture& picture) {
            return picture.from == PassPicture::From::input && picture.index == input;
        });
    });
}

std::shared_ptr<const WorkReading> readWork(const fs::path& path, render::AssetStore& assets, const std::string& text,
                                            const std::vector<PictureSource>& sources)
{
    using Made = render::AssetStore::Made<WorkReading>;
    const auto make = [&] { return Made{readNow(path, text, sources), (1U << 16U) + 2 * text.size()}; };
    // The first reading finds the files. If one of these changed, a further reading has their states in its key.
    std::string key = std::to_string(sources.size()) + '\n' + path.string() + '\n' + text;
    std::shared_ptr<const WorkReading> reading;
    for (int further = 0; further < 8; ++further) {
        const auto made = assets.made<WorkReading>("your_shader.work", key, make);
        if (!made.value) return std::make_shared<const WorkReading>(WorkReading{nullptr, made.failure, {}, {}});
        reading = made.value;
        const std::uint64_t changes = changesOf(*reading);
        if (changes == 0) break;
        key += '\n' + std::to_string(changes);
    }
    return reading;
}

}  // namespace vitrine::guest
