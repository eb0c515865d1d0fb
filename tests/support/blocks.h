#pragma once

#include "exhibits/framework/files/table_change.h"
#include "exhibits/framework/scene/capabilities.h"
#include "exhibits/framework/scene/exhibit.h"
#include "exhibits/framework/scene/tree.h"
#include "render/failure.h"
#include "render/files/read_file.h"
#include "render/files/strict_json.h"

#include <limits>
#include <string>
#include <vector>

namespace vitrine::test {

/// Cube of a pile: {"blocks": [{"name": "red", "size": 0.2, "at": [0, 0, 0]}, ...]}.
struct Block {
    std::string name;
    double size = 0.2;
    glm::dvec3 at{0};
    bool hidden = false;
};

inline std::string textOfBlocks(const std::vector<Block>& blocks)
{
    render::Json all{{"blocks", render::Json::array()}};
    for (const Block& block : blocks)
        all["blocks"].push_back({{"name", block.name},
                                 {"size", block.size},
                                 {"at", {block.at.x, block.at.y, block.at.z}},
                                 {"hidden", block.hidden}});
    return all.dump();
}

struct BlockTable final : Parameters {
    explicit BlockTable(std::vector<Block> read) : blocks(std::move(read)) {}

    const std::vector<Block> blocks;
    File pile = file("pile", "Blocks, as JSON.", extensions("json"), addsParameters());
    File document = this->Parameters::document("document", pile, "The blocks as they were edited.");
};

/// Minimal exhibit with a tree: a root and cubes in it.
class BlocksExhibit final : public Exhibit, public TableFromFiles, public HasTree {
public:
    [[nodiscard]] std::string_view name() const override { return "blocks"; }
    [[nodiscard]] std::string_view title() const override { return "Blocks"; }
    [[nodiscard]] std::string_view summary() const override { return "Cubes of a file."; }
    [[nodiscard]] int place() const override { return 9; }
    [[nodiscard]] const BlockTable& parameters() const override { return none_; }
    [[nodiscard]] render::Box bounds(const ParameterValues&) const override { return {glm::dvec3(-1), glm::dvec3(1)}; }
    [[nodiscard]] render::Camera bestView(const ParameterValues&) const override { return {{0, 0, 4}, {0, 0, 0}, 0.8}; }
    [[nodiscard]] double nextChange(const ParameterValues&, double) const override
    {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] DynamicParameters dynamicParameters(const ParameterValues& values,
                                                      render::AssetStore& assets) const override
    {
        const std::string text = values[none_.document], file = values[none_.pile];
        if (text.empty() && file.empty()) return {{std::shared_ptr<const Parameters>(), &none_}, {}};
        const auto table = text.empty() ? assets.get<BlockTable>("blocks", file,
                                                                 [](const std::string& path) {
                                                                     return made(render::readFile(path, 1U << 20U));
                                                                 })
                                        : assets.made<BlockTable>("blocks.document", text, [&] { return made(text); });
        if (table.value) return {table.value, {}};
        return {nullptr, unreadableFile(none_.rows()[none_.pile.row], title(), table.failure)};
    }

    [[nodiscard]] Tree tree(const ParameterValues& values) const override
    {
        Tree tree{{{"pile", "", "pile", TreeNode::none, false, true, false}}, {{"cube", "A cube."}}};
        for (const Block& block : blocks(values))
            tree.nodes.push_back({block.name, block.name, "cube", 0, block.hidden});
        return tree;
    }
    [[nodiscard]] std::optional<TreeParameters> parametersOf(const ParameterValues& values,
                                                             std::string_view node) const override
    {
        const Block* block = find(values, node);
        if (!block) return std::nullopt;
        auto table = std::make_shared<MadeTable>();
        const Real size = table->real("size", 0.2, Unit::meter, Range{0.01, 1}, "Of an edge.");
        TreeParameters rows{ParameterValues(std::shared_ptr<const Parameters>(table))};
        rows.values.set(size, block->size);
        return rows;
    }
    [[nodiscard]] EditedTree edited(const ParameterValues& values, const TreeEdit& edit,
                                    render::AssetStore& assets) const override
    {
        std::vector<Block> all = blocks(values);
        std::string node = edit.node;
        if (edit.what == TreeEdit::What::add) {
            all.push_back({node = "block " + std::to_string(all.size())});
        } else {
            const std::size_t at = indexOf(values, edit.node);
            if (edit.what == TreeEdit::What::remove)
                all.erase(all.begin() + static_cast<std::ptrdiff_t>(at));
            else if (edit.what == TreeEdit::What::rename)
                all[at].name = node = edit.word;
            else
                throw Failure(ErrorKind::check, "Cubes know no such change.");
        }
        return {with(values, all, assets), node};
    }
    [[nodiscard]] ParameterValues withParameter(const ParameterValues& values, std::string_view node, std::size_t,
                                                const Value& value, render::AssetStore& assets) const override
    {
        std::vector<Block> all = blocks(values);
        all[indexOf(values, node)].size = std::get<double>(value);
        return with(values, all, assets);
    }
    [[nodiscard]] ParameterValues withPlace(const ParameterValues& values, std::string_view node, const TreePlace&,
                                            const TreePlace& to, render::AssetStore& assets) const override
    {
        std::vector<Block> all = blocks(values);
        all[indexOf(values, node)].at = to.translate;
        return with(values, all, assets);
    }
    [[nodiscard]] std::string pick(const ExhibitState& state, const render::Ray& ray) const override
    {
        std::string nearest;
        double distance = std::numeric_limits<double>::infinity();
        for (const Block& block : blocks(state.values))
            if (const double here = render::firstHit(ray, boxOf(block)); here < distance) {
                distance = here;
                nearest = block.name;
            }
        return nearest;
    }
    [[nodiscard]] std::optional<TreePlace> placeOf(const ExhibitState& state, std::string_view node) const override
    {
        const Block* block = find(state.values, node);
        if (!block) return std::nullopt;
        return TreePlace{glm::dmat4(1), block->at};
    }
    [[nodiscard]] std::shared_ptr<const TreeShape> shapeOf(const ExhibitState& state,
                                                           std::string_view node) const override
    {
        const Block* block = find(state.values, node);
        if (!block) return nullptr;
        return std::make_shared<const TreeShape>(
            TreeShape{boxOf(*block), [box = boxOf(*block)](const render::Ray& ray) {
                          return std::isfinite(render::firstHit(ray, box));
                      }});
    }
    [[nodiscard]] DocumentPlace document(const ParameterValues& values) const override
    {
        return {none_.pile.row, none_.document.row, values[none_.pile], !values[none_.pile].empty(), "json"};
    }
    [[nodiscard]] std::string documentText(const ParameterValues& values) const override
    {
        return textOfBlocks(blocks(values));
    }
    [[nodiscard]] bool isDocument(const std::string& text) const override { return text.starts_with("{\"blocks\""); }

private:
    static render::AssetStore::Made<BlockTable> made(const std::string& text)
    {
        std::vector<Block> blocks;
        const render::JsonDocument document = render::parseJson(text, "blocks", {});
        for (const render::Json& block : document.root().at("blocks"))
            blocks.push_back(
                {block.at("name").get<std::string>(),
                 block.at("size").get<double>(),
                 {block.at("at")[0].get<double>(), block.at("at")[1].get<double>(), block.at("at")[2].get<double>()},
                 block.at("hidden").get<bool>()});
        return {std::make_shared<const BlockTable>(std::move(blocks)), 1000};
    }
    [[nodiscard]] static const std::vector<Block>& blocks(const ParameterValues& values)
    {
        return static_cast<const BlockTable&>(values.table()).blocks;
    }
    [[nodiscard]] static const Block* find(const ParameterValues& values, std::string_view node)
    {
        for (const Block& block : blocks(values))
            if (block.name == node) return &block;
        return nullptr;
    }
    [[nodiscard]] static std::size_t indexOf(const ParameterValues& values, std::string_view node)
    {
        const Block* block = find(values, node);
        if (!block) throw Failure(ErrorKind::check, "There is no such cube.");
        return static_cast<std::size_t>(block - blocks(values).data());
    }
    [[nodiscard]] static render::Box boxOf(const Block& block)
    {
        return {block.at - glm::dvec3(block.size / 2), block.at + glm::dvec3(block.size / 2)};
    }
    [[nodiscard]] ParameterValues with(const ParameterValues& values, const std::vector<Block>& all,
                                       render::AssetStore& assets) const
    {
        ParameterValues next = values;
        next.set(none_.document, textOfBlocks(all));
        const DynamicParameters called = dynamicParameters(next, assets);
        if (!called.table) throw Failure(ErrorKind::check, called.why);
        std::vector<std::string> notes;
        return underTable(next, called.table, notes);
    }

    const BlockTable none_{{}};
};

}  // namespace vitrine::test
