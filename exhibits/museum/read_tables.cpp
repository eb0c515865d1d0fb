#include "exhibits/museum/read_tables.h"

namespace vitrine {

TabledLook readTables(std::span<const std::unique_ptr<Exhibit>> exhibits, render::AssetStore& assets, const Look& look)
{
    TabledLook read{look, {}, {}};
    for (std::size_t i = 0; i < exhibits.size(); ++i) {
        ParameterValues& values = read.look.values[i];
        if (values.tableFiles().empty()) continue;
        const CalledTable called = exhibits[i]->tableFor(values, assets);
        if (!called.why.empty()) read.unreadable.push_back(called.why);
        if (!called.table || called.table == values.sharedTable()) continue;
        values = values.under(called.table, read.notes);
        for (const auto& [name, json] : values.pending())
            read.notes.push_back(std::string(exhibits[i]->name()) + '.' + name + " is not known here; it is kept");
    }
    return read;
}

}  // namespace vitrine
