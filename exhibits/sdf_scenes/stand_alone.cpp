// SDF scenes without the program: the numbers of a scene as GLSL, computed from its parameters and the time.

#include "exhibits/framework/table/written_expression.h"
#include "exhibits/sdf_scenes/glsl_expression.h"
#include "exhibits/sdf_scenes/scene_glsl.h"
#include "exhibits/sdf_scenes/sdf_scenes.h"
#include "render/failure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vitrine::scenes {
namespace {

constexpr double boxesEnd = 1e6;  // Meters from the origin.

constexpr const char* sceneFunctions = R"(
// Rotation around z, then y, then x.
mat3 sceneTurn(vec3 angles)
{
    vec3 c = cos(angles), s = sin(angles);
    mat3 x = mat3(1.0, 0.0, 0.0, 0.0, c.x, s.x, 0.0, -s.x, c.x);
    mat3 y = mat3(c.y, 0.0, -s.y, 0.0, 1.0, 0.0, s.y, 0.0, c.y);
    mat3 z = mat3(c.z, s.z, 0.0, -s.z, c.z, 0.0, 0.0, 0.0, 1.0);
    return x * y * z;
}

float expressionPower(float x, float y)
{
    float power = pow(abs(x), y);
    return x < 0.0 && mod(floor(y + 0.5), 2.0) > 0.5 ? -power : power;
}

vec3 sceneDirection(vec3 d)
{
    return length(d) > 0.0 ? normalize(d) : vec3(0.0, 1.0, 0.0);
}
)";

/// Writes the words of a scene's program that depend on its parameters or on the time.
class SceneNumberWriter {
public:
    /// `moment`: seconds of the scene when the shader's time is 0. `present`: values of the scene's parameters.
    SceneNumberWriter(const ShownScene& shown, double moment, std::vector<double> present,
                      const std::vector<double>& numbers)
        : scene_(*shown.scene), program_(*shown.program), moment_(moment), present_(std::move(present)),
          numbers_(numbers), words_(program_.words(numbers)), isFolded_(program_.wordCount(), 1)
    {
    }

    StandAloneNumbers write()
    {
        StandAloneNumbers result;
        const std::vector<SceneParameter>& parameters = scene_.parameters();
        for (std::size_t i = 0; i < parameters.size(); ++i)
            result.inputs.push_back({parameters[i].name, parameters[i].name, parameters[i].unit, present_[i],
                                     parameters[i].low, parameters[i].high});
        for (std::uint32_t m = 0; m < scene_.materials.size(); ++m) writeMaterial(m, result);
        for (const ProgramNode& node : program_.nodes()) writeNode(node);
        if (anyNode_) {
            const std::vector<Interval> whole = wholeIntervals();
            const Samples samples = sampled(whole);
            writeRanges(samples.words);
            writeBoxes(samples.box, boundedIntervals(whole));
            result.assigned.insert({"stage.boxLow", "stage.boxHigh"});
        }
        const auto varies = [&](const Record& record) { return anyVaries(record.numbers, numbersOfRecord(record)); };
        if (varies(scene_.camera) || varies(scene_.environment) || varies(scene_.look) ||
            std::any_of(scene_.lights.begin(), scene_.lights.end(), varies))
            result.notes.push_back(message("Camera, lights and surroundings stay as they are now; shapes and materials "
                                           "follow the inputs."));
        result.functions = sceneFunctions;
        result.assignments = std::move(lines_);
        result.assigned.insert("sceneValues");
        result.sources = generatedSources(
            restingSceneGlsl(program_, words_, isFolded_, {"sdf_scenes/stage_block.glsl", "SceneStage stage"}));
        return result;
    }

private:
    /// Settings of a parameter, SI.
    struct Interval {
        double low = 0, high = 0;
    };
    /// Words of many settings, and the box around all solids of them.
    struct Samples {
        std::vector<std::vector<double>> words;
        render::Box box{glm::dvec3(1e9), glm::dvec3(-1e9)};
    };
    [[nodiscard]] bool varies(std::uint32_t number) const { return scene_.numbers[number].expression != noIndex; }
    [[nodiscard]] bool anyVaries(std::uint32_t first, std::size_t count) const
    {
        for (std::size_t i = 0; i < count && first != noIndex; ++i)
            if (varies(first + static_cast<std::uint32_t>(i))) return true;
        return false;
    }
    static std::size_t numbersOfRecord(const Record& record)
    {
        std::size_t count = 0;
        for (const Field& field : record.kind->fields) count += numbersOf(field.type);
        return count;
    }

    /// Returns a number of the scene as GLSL.
    [[nodiscard]] std::string number(std::uint32_t index) const
    {
        if (!varies(index)) return floatLiteral(numbers_[index]);
        const NumberExpression& expression = scene_.expressions[scene_.numbers[index].expression];
        const std::vector<SceneParameter>& parameters = scene_.files[expression.file].parameters;
        const WrittenNames names = [&](std::string_view name) -> std::optional<WrittenValue> {
            if (name == "t") return WrittenValue{"(TIME + " + floatLiteral(moment_) + ')', Unit::none};
            for (const SceneParameter& parameter : parameters)
                if (parameter.name == name)
                    return WrittenValue{expression.file == 0 ? '@' + parameter.name + '@'
                                                             : floatLiteral(parameter.initial),
                                        parameter.unit};
            return std::nullopt;
        };
        std::optional<std::string> text = writtenExpression(expression.text, expression.unit, names);
        if (!text)
            throw Failure(ErrorKind::check,
                          message("The expression “{1}” cannot be written as GLSL.", expression.text));
        if (expression.whole) text = "floor(" + *text + " + 0.5)";
        const bool isBounded = std::abs(expression.low) < 1e30 && std::abs(expression.high) < 1e30;
        return isBounded
                   ? "clamp(" + *text + ", " + floatLiteral(expression.low) + ", " + floatLiteral(expression.high) + ')'
                   : *text;
    }
    [[nodiscard]] std::string vector(std::uint32_t first) const
    {
        return "vec3(" + number(first) + ", " + number(first + 1) + ", " + number(first + 2) + ')';
    }
    static std::string wordName(std::uint32_t at)
    {
        return "sceneValues[" + std::to_string(at / 4) + "]." + "xyzw"[at % 4];
    }
    void set(std::uint32_t word, const std::string& value)
    {
        isFolded_[word] = 0;
        lines_ += "    " + wordName(word) + " = " + value + ";\n";
    }
    /// Sets the words of a vector or matrix that is computed once.
    void setFrom(std::uint32_t word, const char* type, const std::string& value, int count)
    {
        const std::string name = "value" + std::to_string(word);
        lines_ += "    " + std::string(type) + ' ' + name + " = " + value + ";\n";
        for (int i = 0; i < count; ++i)
            set(word + static_cast<std::uint32_t>(i),
                count == 9 ? name + '[' + std::to_string(i / 3) + "][" + std::to_string(i % 3) + ']'
                           : name + '[' + std::to_string(i) + ']');
    }

    void writeMaterial(std::uint32_t m, StandAloneNumbers& result)
    {
        const std::uint32_t word = program_.materialWord(m);
        const Record& material = scene_.materials[m];
        if (word == noIndex || !anyVaries(material.numbers, numbersOfRecord(material))) return;
        const bool isPhong = material.kind->name == "phong";
        for (std::uint32_t i = 0; i < 3; ++i) set(word + i, number(material.numbers + i));
        const std::size_t count = numbersOfRecord(material);
        const std::uint32_t to = word + (isPhong ? 3 : 8);
        for (std::uint32_t i = 3; i < count; ++i) {
            if (!varies(material.numbers + i)) continue;
            set(to + i - 3, number(material.numbers + i));
            result.notes.push_back(
                message("The material “{1}” follows its inputs in the look for which it is written.", material.name));
        }
        // A word is folded only together with its whole vector of four.
        for (std::uint32_t i = 0; i < wordsOfMaterial; ++i)
            if (isFolded_[word + i] != 0) set(word + i, floatLiteral(words_.words[word + i]));
    }
    void writeNode(const ProgramNode& node)
    {
        const Node& of = scene_.nodes[node.node];
        std::uint32_t at = 0;
        for (const Field& field : of.kind->fields) {
            const auto count = static_cast<std::uint32_t>(numbersOf(field.type));
            const bool isDirection = field.type == FieldType::direction;
            if (isDirection && anyVaries(of.numbers + at, 3)) {
                setFrom(node.numbers + at, "vec3", "sceneDirection(" + vector(of.numbers + at) + ')', 3);
                anyNode_ = true;
            }
            for (std::uint32_t i = at; i < at + count && !isDirection; ++i) {
                if (!varies(of.numbers + i)) continue;
                set(node.numbers + i, number(of.numbers + i));
                anyNode_ = true;
            }
            at += count;
        }
        for (std::uint32_t i = 0; i < 3 && node.translate != noIndex; ++i) {
            if (!varies(of.translate + i)) continue;
            set(node.translate + i, number(of.translate + i));
            anyNode_ = true;
        }
        if (node.rotate != noIndex && anyVaries(of.rotate, 3)) {
            setFrom(node.rotate, "mat3", "sceneTurn(" + vector(of.rotate) + ')', 9);
            anyNode_ = true;
        }
        if (node.scale == noIndex || !anyVaries(of.scale, 3)) return;
        anyNode_ = true;
        for (std::uint32_t i = 0; i < 3; ++i) set(node.scale + i, "1.0 / " + number(of.scale + i));
        set(node.scale + 3,
            "min(" + number(of.scale) + ", min(" + number(of.scale + 1) + ", " + number(of.scale + 2) + "))");
    }

    /// Sets what depends on the bounds of nodes to values that hold for all samples.
    void writeRanges(const std::vector<std::vector<double>>& samples)
    {
        for (const ProgramNode& node : program_.nodes()) {
            const NodeKind& kind = program_.kind(node);
            if (kind.form != Form::repeater) continue;
            const auto w = static_cast<std::uint32_t>(node.numbers + kind.numbers());
            for (std::uint32_t axis = 0; axis < 3; ++axis) keepCopies(node, axis, samples);
            keep(w + 6, most(w + 6, samples));
            for (const std::uint32_t first : {7U, 13U}) keepBox(w + first, samples);
        }
    }
    static double most(std::uint32_t word, const std::vector<std::vector<double>>& samples)
    {
        double value = samples[0][word];
        for (const auto& each : samples) value = std::max(value, each[word]);
        return value;
    }
    /// Sets where the copies along an axis begin and how many follow, so that they include those of each sample.
    void keepCopies(const ProgramNode& node, std::uint32_t axis, const std::vector<std::vector<double>>& samples)
    {
        const NodeKind& kind = program_.kind(node);
        const bool isAround = kind.name == "repeatAround";
        const auto high = static_cast<std::uint32_t>(node.numbers + kind.numbers()) + axis, times = high + 3;
        const double first = most(high, samples);
        double copies = most(times, samples), all = 0;
        for (const auto& each : samples) {
            const double spacing = isAround ? 2 * std::numbers::pi / each[node.numbers] : each[node.numbers + axis];
            const double count = each[node.numbers + (isAround ? 0 : axis + 3)];
            const bool repeats = isAround ? axis == 0 : spacing > 0;
            if (repeats) copies = std::max(copies, each[times] + std::ceil((first - each[high]) / spacing - 1e-9));
            all = std::max(all, !repeats ? 1 : count > 0.5 ? count : mostCopiesAsked);
        }
        keep(high, first);
        keep(times, std::min({copies, all, mostCopiesAsked}));
    }
    void keep(std::uint32_t word, double value) { words_.words[word] = value; }
    void keepBox(std::uint32_t word, const std::vector<std::vector<double>>& samples)
    {
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            double low = 1e9, high = -1e9;
            for (const auto& each : samples) {
                low = std::min(low, each[word + axis] - each[word + axis + 3]);
                high = std::max(high, each[word + axis] + each[word + axis + 3]);
            }
            keep(word + axis, 0.5 * (low + high));
            keep(word + axis + 3, 0.5 * std::max(high - low, 0.0));
        }
    }
    [[nodiscard]] std::vector<Interval> wholeIntervals() const;
    [[nodiscard]] std::vector<Interval> boundedIntervals(const std::vector<Interval>& whole) const;
    [[nodiscard]] Samples sampled(const std::vector<Interval>&) const;
    void writeBoxes(const render::Box& whole, const std::vector<Interval>& bounded);

    const Scene& scene_;
    const SceneProgram& program_;
    const double moment_;
    const std::vector<double> present_;
    const std::vector<double>& numbers_;
    SceneConstants words_;
    std::vector<char> isFolded_;
    std::string lines_;
    bool anyNode_ = false;
};

std::vector<SceneNumberWriter::Interval> SceneNumberWriter::wholeIntervals() const
{
    std::vector<Interval> whole;
    for (const SceneParameter& parameter : scene_.parameters()) {
        const double now = present_[whole.size()];
        whole.push_back({std::min(parameter.low, now), std::max(parameter.high, now)});
    }
    return whole;
}

/// Returns the words at the ends of all intervals, and for some settings in between, at several times.
SceneNumberWriter::Samples SceneNumberWriter::sampled(const std::vector<Interval>& intervals) const
{
    std::vector<std::vector<double>> settings{present_};
    for (std::size_t i = 0; i < intervals.size(); ++i)
        for (const double end : {intervals[i].low, intervals[i].high}) {
            settings.push_back(present_);
            settings.back()[i] = end;
        }
    // Further settings in between: a sequence without clumps (Roberts 2018), and corners.
    constexpr double golden = 0.6180339887498949;
    for (int k = 1; k <= 40; ++k) {
        settings.emplace_back();
        for (std::size_t i = 0; i < intervals.size(); ++i) {
            const double share = std::fmod(k * std::pow(golden, static_cast<double>(i + 1)), 1.0);
            const double at = k % 2 == 0 ? share : std::round(share);
            settings.back().push_back(intervals[i].low + at * (intervals[i].high - intervals[i].low));
        }
    }
    Samples samples;
    for (std::size_t k = 0; k < settings.size(); ++k)
        for (int time = 0; time < (scene_.animated() ? 4 : 1); ++time) {
            const double t = moment_ + time * 7.3 + static_cast<double>(k) * 0.9;
            SceneConstants made = program_.words(scene_.numbersAt(t, settings[k]));
            if (!made.extents.empty()) {
                const render::Box& box = made.extents.front().box;
                samples.box.low = glm::min(samples.box.low, glm::max(box.low, glm::dvec3(-boxesEnd)));
                samples.box.high = glm::max(samples.box.high, glm::min(box.high, glm::dvec3(boxesEnd)));
            }
            samples.words.push_back(std::move(made.words));
        }
    return samples;
}

/// Returns whether a box has an end on all sides on which the other one has.
bool isBoundedLike(const render::Box& box, const render::Box& other)
{
    bool isBounded = true;
    for (int axis = 0; axis < 3; ++axis) {
        isBounded = isBounded && (box.low[axis] > -boxesEnd || other.low[axis] <= -boxesEnd);
        isBounded = isBounded && (box.high[axis] < boxesEnd || other.high[axis] >= boxesEnd);
    }
    return isBounded;
}

/// Returns intervals around the present values in which the box has an end on all sides on which the present one has.
/// A box without end costs steps: rays that pass the solids go on, and reach the step limit.
std::vector<SceneNumberWriter::Interval> SceneNumberWriter::boundedIntervals(const std::vector<Interval>& whole) const
{
    std::vector<Interval> bounded;
    for (const double value : present_) bounded.push_back({value, value});
    const render::Box now = sampled(bounded).box;
    const auto isBounded = [&](const std::vector<Interval>& each) { return isBoundedLike(sampled(each).box, now); };
    if (isBounded(whole)) return whole;
    // All ends grow alike, each as far as it can.
    std::vector<char> isStuck(2 * whole.size(), 0);
    for (const double share : {0.0625, 0.125, 0.25, 0.5, 1.0})
        for (std::size_t end = 0; end < isStuck.size(); ++end) {
            if (isStuck[end] != 0) continue;
            const std::size_t i = end / 2;
            double& moved = end % 2 == 0 ? bounded[i].low : bounded[i].high;
            const double before = moved, last = end % 2 == 0 ? whole[i].low : whole[i].high;
            moved = share < 1 ? present_[i] + share * (last - present_[i]) : last;
            isStuck[end] = isBounded(bounded) ? 0 : 1;
            if (isStuck[end] != 0) moved = before;
        }
    return bounded;
}

std::string boxLine(const char* name, const glm::dvec3& corner, const glm::dvec3& boundedCorner)
{
    const auto vector = [](const glm::dvec3& v) {
        std::string text = "vec3(";
        for (int i = 0; i < 3; ++i) text += (i > 0 ? ", " : "") + floatLiteral(v[i]);
        return text + ')';
    };
    const std::string line = "    stage." + std::string(name) + " = ";
    return corner == boundedCorner ? line + vector(corner) + ";\n"
                                   : line + "boxIsBounded ? " + vector(boundedCorner) + " : " + vector(corner) + ";\n";
}

/// Sets the box around all solids: the whole one, or a bounded one while all parameters are in its intervals.
void SceneNumberWriter::writeBoxes(const render::Box& whole, const std::vector<Interval>& bounded)
{
    const std::vector<Interval> all = wholeIntervals();
    std::string condition;
    const auto add = [&](std::size_t i, const char* comparison, double end) {
        condition += (condition.empty() ? "" : " && ") + std::string("@") + scene_.parameters()[i].name + "@ " +
                     comparison + ' ' + floatLiteral(end);
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double margin = 1e-5 * (all[i].high - all[i].low);  // Inputs are rounded, in their own units.
        if (bounded[i].low > all[i].low) add(i, ">=", bounded[i].low - margin);
        if (bounded[i].high < all[i].high) add(i, "<=", bounded[i].high + margin);
    }
    const glm::dvec3 grow(1e-3);
    const render::Box tight = condition.empty() ? whole : sampled(bounded).box;
    if (!condition.empty()) lines_ += "    bool boxIsBounded = " + condition + ";\n";
    lines_ += boxLine("boxLow", whole.low - grow, tight.low - grow);
    lines_ += boxLine("boxHigh", whole.high + grow, tight.high + grow);
}

}  // namespace

ParameterValues SdfScenes::standAloneValues(const ParameterValues& values) const
{
    ParameterValues alone = values;
    alone.set(table_.evaluation, SceneEvaluation::shapes);
    alone.set(table_.split, false);
    return alone;
}

StandAloneNumbers SdfScenes::standAloneNumbers(const ParameterValues& values) const
{
    const ShownScene& scene = shown(values);
    const double moment = values[table_.moment];
    const std::vector<double> numbers = numbersAt(values, 0);
    if (isInBuffer(*scene.program))
        throw Failure(ErrorKind::check,
                      message("The scene has more numbers than a shader of your own can hold; export a part of it."));
    const auto& table = static_cast<const Table&>(values.table());
    std::vector<double> present;
    for (const SceneParameter& parameter : scene.scene->parameters()) present.push_back(parameter.initial);
    for (std::size_t i = 0; i < present.size() && i < table.ofScene.size(); ++i) present[i] = values[table.ofScene[i]];
    StandAloneNumbers result = SceneNumberWriter(scene, moment, present, numbers).write();
    for (std::size_t i = 0; i < result.inputs.size() && i < table.ofScene.size(); ++i)
        result.inputs[i].label = label(values.rows()[table.ofScene[i].row]);
    const SceneCamera camera = sceneCamera(*scene.scene, numbers, 0);
    const Portal portal = portalAt(values, 0, numbers);
    result.pivotDistance = glm::length(camera.target - camera.eye) / glm::length(glm::dvec3(portal.workFromExhibit[2]));
    return result;
}

}  // namespace vitrine::scenes
