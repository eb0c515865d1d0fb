#include "exhibits/framework/gone_rows.h"

#include <map>
#include <mutex>

namespace vitrine {
namespace {

struct Known {
    std::mutex mutex;
    std::map<const Parameters*, std::vector<GoneRow>> rows;
};

/// Outlives every table: those of the whole program's life are destroyed after what was made later.
Known& known()
{
    static auto* all = new Known;
    return *all;
}

}  // namespace

GoneRows::GoneRows(const Parameters& table, std::initializer_list<GoneRow> rows) : table_(table)
{
    const std::lock_guard lock(known().mutex);
    known().rows[&table] = rows;
}

GoneRows::~GoneRows()
{
    const std::lock_guard lock(known().mutex);
    known().rows.erase(&table_);
}

std::vector<GoneRow> GoneRows::of(const Parameters& table)
{
    const std::lock_guard lock(known().mutex);
    const auto found = known().rows.find(&table);
    return found == known().rows.end() ? std::vector<GoneRow>() : found->second;
}

}  // namespace vitrine
