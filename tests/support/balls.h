#pragma once

#include "exhibits/framework/scene/exhibit.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace vitrine::test {

/// Ball in a scene file: {"balls": [{"name": "red", "radius": 0.5}, ...]}.
struct Ball {
    std::string name;
    double radius = 0;
};

/// Table with the parameters of every scene, and two for each of its balls.
struct BallTable final : Parameters {
    explicit BallTable(std::vector<Ball> described) : scene(std::move(described))
    {
        std::vector<std::string> headings;
        std::vector<Element> elements;
        for (const Ball& ball : scene) headings.push_back("Ball " + ball.name);
        for (std::size_t i = 0; i < scene.size(); ++i) elements.push_back({scene[i].name, headings[i]});
        struct Rows {
            Real radius;
            Count rings;
        };
        for (const Rows& rows : groups("balls", elements, [&](std::size_t i) {
                 const Real radius = real("radius", scene[i].radius, meter, {0, 10}, "From its middle.");
                 return Rows{radius, count("rings", 8, {1, 64, logarithmic}, "More is rounder.", quality(64))};
             })) {
            radii.push_back(rows.radius);
            rings.push_back(rows.rings);
        }
    }

    const std::vector<Ball> scene;
    File file = this->Parameters::file("scene", "Balls, as JSON.", extensions("json"), addsParameters());
    Real spin = real("spin", 1, none, {0, 10}, "How fast all turn.");
    std::vector<Real> radii;  ///< Indices are those of the balls.
    std::vector<Count> rings;
};

/// Exhibit with parameters for the balls that its file describes.
class BallsExhibit : public Exhibit, public TableFromFiles {
public:
    [[nodiscard]] std::string_view name() const override { return "balls"; }
    [[nodiscard]] std::string_view title() const override { return "Balls"; }
    [[nodiscard]] std::string_view summary() const override { return "Balls of a file."; }
    [[nodiscard]] int place() const override { return 9; }
    [[nodiscard]] const BallTable& parameters() const override { return none_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {glm::dvec3(-1), glm::dvec3(1)}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override
    {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] DynamicParameters dynamicParameters(const ParameterValues& values,
                                                      render::AssetStore& assets) const override
    {
        const std::string file = values[none_.file];
        if (file.empty()) return {{std::shared_ptr<const Parameters>(), &none_}, {}};
        if (beforeReading) beforeReading();
        const render::Asset<BallTable> table = assets.get<BallTable>("balls.scene", file, &read);
        if (table.value) return {table.value, {}};
        return {nullptr, unreadableFile(none_.rows()[none_.file.row], title(), table.failure)};
    }

    std::function<void()> beforeReading;  ///< Called on the reading thread before a file is read.

private:
    static render::AssetStore::Made<BallTable> read(const std::string& path)
    {
        const render::JsonDocument document = render::readJson(path);
        std::vector<Ball> balls;
        for (const render::Json& ball : document.root().at("balls"))
            balls.push_back({ball.at("name").get<std::string>(), ball.at("radius").get<double>()});
        return {std::make_shared<const BallTable>(std::move(balls)), 1000};
    }

    const BallTable none_{{}};
};

inline void writeBalls(const std::filesystem::path& path, const std::vector<Ball>& balls)
{
    render::Json scene{{"balls", render::Json::array()}};
    for (const Ball& ball : balls) scene["balls"].push_back({{"name", ball.name}, {"radius", ball.radius}});
    std::ofstream(path) << scene.dump();
}

/// Sets a parameter by name. Returns whether it exists.
inline bool setParameter(ParameterValues& values, std::string_view name, const Value& value)
{
    const std::optional<std::size_t> row = values.table().find(name);
    if (row) values.setParameter(*row, value);
    return row.has_value();
}
inline std::optional<Value> parameterOf(const ParameterValues& values, std::string_view name)
{
    const std::optional<std::size_t> row = values.table().find(name);
    return row ? std::optional<Value>(values.row(*row)) : std::nullopt;
}

}  // namespace vitrine::test
