#include "exhibits/framework/table/studied_parameters.h"

#include <algorithm>
#include <map>
#include <mutex>

namespace vitrine {
namespace {

struct Declared {
    std::mutex mutex;
    std::map<const Parameters*, std::vector<StudiedParameter>> rows;
};

/// Never destroyed: it must outlive static Parameters objects, which are destroyed after objects created later.
Declared& declared()
{
    static auto* all = new Declared;
    return *all;
}

}  // namespace

StudiedParameters::StudiedParameters(const Parameters& table, std::initializer_list<StudiedParameter> rows)
    : table_(table)
{
    const std::lock_guard lock(declared().mutex);
    std::vector<StudiedParameter>& all = declared().rows[&table];
    all.insert(all.end(), rows.begin(), rows.end());
}

StudiedParameters::~StudiedParameters()
{
    const std::lock_guard lock(declared().mutex);
    declared().rows.erase(&table_);
}

std::vector<StudiedParameter> StudiedParameters::allOf(const Parameters& table)
{
    const std::lock_guard lock(declared().mutex);
    const auto found = declared().rows.find(&table);
    return found == declared().rows.end() ? std::vector<StudiedParameter>() : found->second;
}

StudiedParameter StudiedParameters::of(const Parameters& table, std::string_view row)
{
    for (StudiedParameter& each : allOf(table))
        if (each.name == row) return std::move(each);
    return {.name = row};
}

}  // namespace vitrine
