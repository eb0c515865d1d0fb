#include "exhibits/your_shader/your_shader_table.h"

#include "exhibits/your_shader/guest_work.h"
#include "render/image/picture_formats.h"
#include "render/image/srgb.h"
#include "render/video/sound_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace vitrine::guest {
namespace {

/// Returns a word whose first letters are small: "Steps" is "steps", "STEPS" too, and "HTMLName" is "htmlName".
std::string smallAtFront(std::string word)
{
    const auto isUpper = [&](std::size_t i) {
        return i < word.size() && std::isupper(static_cast<unsigned char>(word[i]));
    };
    const auto isLower = [&](std::size_t i) {
        return i < word.size() && std::islower(static_cast<unsigned char>(word[i]));
    };
    const bool hasSmall = std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::islower(c); });
    for (std::size_t i = 0; i < word.size() && (isUpper(i) || !hasSmall); ++i) {
        if (hasSmall && i > 0 && isLower(i + 1)) break;  // The capital begins the next word.
        word[i] = static_cast<char>(std::tolower(static_cast<unsigned char>(word[i])));
    }
    return word;
}

/// Returns the name without underscores: "line_width" is "lineWidth", and "MAX_STEPS" is "maxSteps".
std::string rowName(const std::string& name)
{
    std::string row;
    for (std::size_t at = 0; at < name.size();) {
        std::size_t end = at;
        while (end < name.size() && std::isalnum(static_cast<unsigned char>(name[end]))) ++end;
        std::string word = name.substr(at, end - at);
        const bool hasSmall = std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::islower(c); });
        if (row.empty() || !hasSmall) word = smallAtFront(std::move(word));
        if (!row.empty() && !word.empty())
            word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
        row += word;
        at = end + 1;
    }
    if (row.empty() || !std::isalpha(static_cast<unsigned char>(row.front()))) row.insert(0, "input");
    return row.substr(0, 48);
}

/// Returns an unused name. The endings are those of its components.
std::string freeName(const Parameters& table, std::string name, const std::vector<std::string>& endings)
{
    const auto isTaken = [&] {
        return std::any_of(endings.begin(), endings.end(),
                           [&](const std::string& ending) { return table.find(name + ending).has_value(); });
    };
    if (isTaken()) {
        name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
        name.insert(0, "own");
    }
    while (isTaken()) name += '2';
    return name;
}

std::vector<std::string> endingsOf(const Input& input)
{
    switch (input.type) {
    case InputType::point:
    case InputType::vector: {
        static const std::vector<std::string> axes{"X", "Y", "Z", "W"};
        return {axes.begin(),
                axes.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(input.low.size(), 1, 4))};
    }
    case InputType::color:
        return input.glslType == "vec4" ? std::vector<std::string>{"", "Alpha"} : std::vector<std::string>{""};
    case InputType::event: return {"At"};
    case InputType::image: return {"", "Source"};
    default: return {""};
    }
}

Unit unitOf(const std::string& text)
{
    if (text == "deg") return Unit::degree;
    if (text == "s") return Unit::second;
    if (text == "m") return Unit::meter;
    return text == "%" ? Unit::percent : Unit::none;
}

/// Returns a range that holds the initial value and is not empty.
Range rangeOf(double low, double high, Unit unit)
{
    if (!(high > low)) high = low + 1;
    return {stored(low, unit), stored(high, unit)};
}

/// Returns the labels, those that repeat with a number.
std::vector<std::string> labelsOf(const Input& input)
{
    std::vector<std::string> labels;
    std::set<std::string> seen;
    for (const InputChoice& choice : input.choices) {
        std::string label = choice.label.empty() ? std::to_string(choice.value) : choice.label;
        for (int number = 2; !seen.insert(label).second; ++number) label = choice.label + " " + std::to_string(number);
        labels.push_back(label);
    }
    return labels;
}

glm::dvec3 linearColor(const std::vector<double>& encoded)
{
    glm::dvec3 color(1);
    for (std::size_t i = 0; i < 3 && i < encoded.size(); ++i)
        color[static_cast<glm::length_t>(i)] = render::linearFromSrgb(std::clamp(encoded[i], 0.0, 1.0));
    return color;
}

}  // namespace

YourShaderTable::YourShaderTable(std::shared_ptr<const Work> of, std::vector<PictureSource> sources)
    : ofAllInputs_(countOf(*of->shader, sources)), work(std::move(of)), sources_(std::move(sources))
{
    addInputs(*work->shader);
}

YourShaderTable::YourShaderTable(const Shader& shader) : ofAllInputs_(countOf(shader, {}))
{
    addInputs(shader);
}

std::size_t YourShaderTable::countOf(const Shader& shader, const std::vector<PictureSource>& sources)
{
    YourShaderTable all;
    all.sources_ = sources;
    all.addInputs(shader);
    return std::accumulate(all.ofInputs.begin(), all.ofInputs.end(), std::size_t{0},
                           [](std::size_t sum, const auto& rows) { return sum + rows.size(); });
}

void YourShaderTable::addInputs(const Shader& shader)
{
    if (!shader.inputs.empty()) group(shader.title.empty() ? "Inputs" : shader.title);
    for (const Input& input : shader.inputs) ofInputs.push_back(addInput(input));
}

std::vector<std::size_t> YourShaderTable::addInput(const Input& input)
{
    const std::string name = freeName(*this, rowName(input.name), endingsOf(input));
    const std::string named = input.label.empty() ? input.name : input.label;
    const auto label = labeled(named);
    switch (input.type) {
    case InputType::toggle:
        return {toggle(name, !input.initial.empty() && input.initial[0] != 0, "Switch that the shader reads.", label,
                       nextOfInputs())
                    .row};
    case InputType::choice: {
        const auto isInitial = [&](const InputChoice& choice) { return choice.value == input.initial[0]; };
        const auto initial = std::find_if(input.choices.begin(), input.choices.end(), isInitial);
        const auto isExact = [&](const InputChoice& choice) { return choice.value == input.exact; };
        const auto exact = std::find_if(input.choices.begin(), input.choices.end(), isExact);
        const auto index = [&](auto found) { return static_cast<int>(found - input.choices.begin()); };
        const std::string_view help = "Choice that the shader reads.";
        if (exact == input.choices.end())
            return {choice(name, index(initial), labelsOf(input), help, label, nextOfInputs()).row};
        return {choice(name, index(initial), labelsOf(input), help, label, nextOfInputs(), quality(index(exact))).row};
    }
    case InputType::event:
        return {real(name + "At", -1, Unit::second, Range{-1, 1e6}.soft(-1, 60),
                     "Time at which the button of this event is pressed, for one step.", label, reads(-1, "never"),
                     nextOfInputs())
                    .row};
    case InputType::color: {
        std::vector<std::size_t> rows{
            color(name, linearColor(input.initial), "Color that the shader reads.", label, nextOfInputs()).row};
        if (input.glslType == "vec4")
            rows.push_back(real(name + "Alpha", std::clamp(input.initial.back(), 0.0, 1.0), Unit::none, {0, 1},
                                "Opacity of the color.", labeled(named + " alpha"), nextOfInputs())
                               .row);
        return rows;
    }
    case InputType::image:
        if (input.source == "buffer" || input.glslType != "sampler2D") return {};
        return addPicture(name, named);
    case InputType::audio:
    case InputType::spectrum:
        return {this->Parameters::file(name, "Sound that the shader reads, WAV or FLAC; empty: silence.",
                                       extensions(render::soundEndings), label, nextOfInputs())
                    .row};
    default: return addNumbers(input, name, named);
    }
}

std::vector<std::size_t> YourShaderTable::addPicture(const std::string& name, const std::string& label)
{
    const auto addFile = [&](std::optional<Condition> acts) {
        return this
            ->Parameters::file(name, "Picture that the shader reads; empty: a test picture.",
                               extensions(render::readEndings()), labeled(label), nextOfInputs(), acts)
            .row;
    };
    if (sources_.empty()) return {addFile(std::nullopt)};
    std::vector<std::string> names{"file"};
    for (const PictureSource& source : sources_) names.push_back(source.title);
    const std::string sourceName = name + "Source";
    const Choice<int> source =
        choice(sourceName, 0, names,
               "Source of the picture: a file; the hall at its first view, from your place, or out of this screen; or "
               "another exhibit by itself, with its present settings. This screen is black in pictures of the hall.",
               labeled(label + " source"), nextOfInputs());
    return {addFile(whenLater(sourceName, 0)), source.row};
}

std::string YourShaderTable::sourceOf(std::size_t input, const ParameterValues& values) const
{
    if (!work || work->shader->inputs[input].type != InputType::image || ofInputs[input].size() < 2) return {};
    const auto choice = static_cast<std::size_t>(std::get<double>(values.row(ofInputs[input][1])));
    return choice == 0 || choice > sources_.size() ? std::string() : sources_[choice - 1].name;
}

std::vector<std::size_t> YourShaderTable::addNumbers(const Input& input, const std::string& name,
                                                     std::string_view label)
{
    const std::vector<std::string> endings = endingsOf(input);
    const bool isWhole = input.glslType.starts_with('i') || input.glslType.starts_with('u');
    const Unit unit = isWhole ? Unit::none : unitOf(input.unit);
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < endings.size() && i < input.initial.size(); ++i) {
        const Range range = rangeOf(input.low[i], input.high[i], unit);
        const std::string shownAs = std::string(label) + (endings[i].empty() ? "" : " " + endings[i]);
        const std::string help = "Number that the shader reads.";
        std::optional<Quality> exact;
        if (input.exact && endings.size() == 1) exact = quality(stored(*input.exact, unit));
        if (isWhole) {
            const auto initial = static_cast<int>(std::lround(std::clamp(input.initial[i], -1e9, 1e9)));
            rows.push_back(
                exact ? count(name + endings[i], initial, range, help, labeled(shownAs), nextOfInputs(), *exact).row
                      : count(name + endings[i], initial, range, help, labeled(shownAs), nextOfInputs()).row);
        } else {
            const double initial = stored(input.initial[i], unit);
            rows.push_back(
                exact
                    ? real(name + endings[i], initial, unit, range, help, labeled(shownAs), nextOfInputs(), *exact).row
                    : real(name + endings[i], initial, unit, range, help, labeled(shownAs), nextOfInputs()).row);
        }
    }
    return rows;
}

}  // namespace vitrine::guest
