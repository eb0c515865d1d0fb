#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

namespace vitrine {

class Parameters;

/// A row that a table had before: files that still have it are read without it.
struct GoneRow {
    std::string_view name;
    std::string_view became = {};  ///< A sentence: what shows the same now; empty: nothing has to be said.
};

/// The rows that a table had before, as a member of it:
///
///     GoneRows gone{*this, {{"wipe"}, {"compare", "Compare with other beams, in the Compare menu."}}};
///
/// They are looked up by the table's address, so that tables without any know nothing of them. Texts must be literals.
/// Any thread may make, ask and destroy.
class GoneRows {
public:
    GoneRows(const Parameters&, std::initializer_list<GoneRow>);
    ~GoneRows();
    GoneRows(const GoneRows&) = delete;
    GoneRows& operator=(const GoneRows&) = delete;

    /// Those of that table; none where it has had no others.
    [[nodiscard]] static std::vector<GoneRow> of(const Parameters&);

private:
    const Parameters& table_;
};

}  // namespace vitrine
