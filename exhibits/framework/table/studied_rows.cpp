#include "exhibits/framework/table/studied_rows.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace vitrine {
namespace {

struct Declared {
    std::mutex mutex;
    std::map<const Parameters*, std::vector<StudiedRow>> rows;
};

/// Never destroyed: it must outlive static Parameters objects, which are destroyed after objects created later.
Declared& declared()
{
    static auto* all = new Declared;
    return *all;
}

}  // namespace

StudiedRows::StudiedRows(const Parameters& table, std::initializer_list<StudiedRow> rows) : table_(table)
{
    const std::lock_guard lock(declared().mutex);
    std::vector<StudiedRow>& all = declared().rows[&table];
    all.insert(all.end(), rows.begin(), rows.end());
}

StudiedRows::~StudiedRows()
{
    const std::lock_guard lock(declared().mutex);
    declared().rows.erase(&table_);
}

std::vector<StudiedRow> StudiedRows::allOf(const Parameters& table)
{
    const std::lock_guard lock(declared().mutex);
    const auto found = declared().rows.find(&table);
    return found == declared().rows.end() ? std::vector<StudiedRow>() : found->second;
}

StudiedRow StudiedRows::of(const Parameters& table, std::string_view row)
{
    for (StudiedRow& each : allOf(table))
        if (each.name == row) return std::move(each);
    return {.name = row};
}

}  // namespace vitrine
