#include "tests/exhibits/sdf_scenes/support.h"

#include "render/failure.h"
#include "render/files/number_text.h"

#include <cmath>

namespace vitrine::test {
namespace {

using scenes::Field;
using scenes::FieldType;
using scenes::Form;
using scenes::NodeKind;

std::string number(double x)
{
    return render::shortestNumber(x);
}

std::string vector(const glm::dvec3& v)
{
    return '[' + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ']';
}

/// Returns a number of moderate size within the field's range.
double randomNumber(const Field& field, Random& random)
{
    if (field.type == FieldType::count) return std::floor(random.number(field.low, std::min(field.high, 7.0)));
    if (field.unit == Unit::degree) {
        const double reach = std::min(field.high, 3.0) - std::max(field.low, -3.0);
        return shown(std::max(field.low, -3.0) + reach * random.number(0.05, 0.95), field.unit);
    }
    if (field.unit == Unit::meter && field.low >= 0) return random.number(0.15, 0.8);
    if (field.unit == Unit::meter) return random.number(-0.7, 0.7);
    if (field.name == "frequency") return random.number(0.5, 5);
    return random.number(std::max(field.low, -1.0), std::min(field.high, 1.0));
}

std::string randomField(const Field& field, Random& random)
{
    if (field.type == FieldType::choice)
        return '"' +
               std::string(
                   field.choices[static_cast<std::size_t>(random.below(static_cast<int>(field.choices.size())))]) +
               '"';
    if (field.type == FieldType::toggle) return random.below(2) == 0 ? "false" : "true";
    if (field.type == FieldType::direction) return vector(random.direction());
    if (field.type == FieldType::counts) return vector({random.below(4), random.below(4), random.below(4)});
    if (field.name == "spacing")
        return vector({random.below(2) * random.number(0.6, 3), random.below(2) * 2, random.below(2) * 1.5});
    if (numbersOf(field.type) == 3)
        return vector({randomNumber(field, random), randomNumber(field, random), randomNumber(field, random)});
    return number(randomNumber(field, random));
}

}  // namespace

std::string sceneText(const std::string& root, const std::string& head)
{
    return "{\"format\": \"vitrine-scene\", \"version\": 1,\n" + head + "\n\"root\": " + root + "\n}\n";
}

scenes::ReadScene readText(const std::string& text, const scenes::SceneLimits& limits)
{
    const auto noFile = [](const std::string& path) -> std::string {
        throw Failure(ErrorKind::file, "Cannot read " + path + ": there is no file.");
    };
    return scenes::readScene(text, "test.json", noFile, limits);
}

std::string findingsText(const scenes::ReadScene& read)
{
    std::string text;
    for (const scenes::Finding& finding : read.findings) text += finding.text().english() + '\n';
    return text;
}

std::shared_ptr<const scenes::Scene> sceneOf(const std::string& root, const std::string& head)
{
    const scenes::ReadScene read = readText(sceneText(root, head));
    EXPECT_TRUE(read.scene) << findingsText(read) << root;
    return read.scene;
}

scenes::SceneField fieldOf(const std::string& root, const std::string& head)
{
    return scenes::SceneField(sceneOf(root, head));
}

std::string randomNode(const NodeKind& kind, Random& random, const std::string& further)
{
    std::string text = "{\"kind\": \"" + std::string(kind.name) + '"';
    for (const Field& field : kind.fields)
        text += ", \"" + std::string(field.name) + "\": " + randomField(field, random);
    return text + further + '}';
}

std::string randomPlace(Random& random, bool evenScale)
{
    std::string text;
    if (random.below(2) == 0) text += ", \"translate\": " + vector(random.point(1));
    if (random.below(2) == 0) text += ", \"rotate\": " + vector(random.point(180));
    if (random.below(3) > 0) return text;
    const glm::dvec3 factors{random.number(0.5, 2), random.number(0.5, 2), random.number(0.5, 2)};
    return text + ", \"scale\": " + (evenScale ? number(factors.x) : vector(factors));
}

std::string randomTree(Random& random, int depth)
{
    const std::vector<NodeKind>& kinds = scenes::nodeKinds();
    while (true) {
        const NodeKind& kind = kinds[static_cast<std::size_t>(random.below(static_cast<int>(kinds.size())))];
        if (kind.form != Form::shape && depth == 0) continue;
        if (kind.form == Form::shape && depth > 1 && random.below(4) > 0) continue;
        std::string further = randomPlace(random, false);
        if (kind.form == Form::modifier || kind.form == Form::repeater)
            further += ", \"child\": " + randomTree(random, depth - 1);
        if (kind.form == Form::pair || kind.form == Form::operands) {
            const int children = kind.form == Form::pair ? 2 : 1 + random.below(3);
            further += ", \"children\": [";
            for (int i = 0; i < children; ++i) further += (i > 0 ? ", " : "") + randomTree(random, depth - 1);
            further += ']';
        }
        const std::string text = randomNode(kind, random, further);
        if (readText(sceneText(text)).scene) return text;  // Some numbers give no valid shape, or an infinite scene.
    }
}

glm::dvec3 gradientAt(const scenes::SceneField& field, const glm::dvec3& p)
{
    constexpr double h = 1e-6;
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = h;
        gradient[axis] = (field.distance(p + step) - field.distance(p - step)) / (2 * h);
    }
    return gradient;
}

}  // namespace vitrine::test
