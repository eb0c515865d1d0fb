#include "exhibits/framework/table/condition.h"

#include <iterator>
#include <utility>

namespace vitrine {
namespace {

/// Parts of the same kind are merged into one list: (a and b) and c becomes a and b and c.
Condition combined(Condition::Test test, Condition a, Condition b)
{
    Condition both{test};
    for (Condition* one : {&a, &b}) {
        if (one->test != test)
            both.parts.push_back(std::move(*one));
        else
            both.parts.insert(both.parts.end(), std::make_move_iterator(one->parts.begin()),
                              std::make_move_iterator(one->parts.end()));
    }
    return both;
}

}  // namespace

Condition operator&&(Condition a, Condition b)
{
    return combined(Condition::Test::all, std::move(a), std::move(b));
}

Condition operator||(Condition a, Condition b)
{
    return combined(Condition::Test::any, std::move(a), std::move(b));
}

std::string_view toString(Condition::Test test)
{
    switch (test) {
    case Condition::Test::among: return "among";
    case Condition::Test::differs: return "differs";
    case Condition::Test::above: return "above";
    case Condition::Test::given: return "given";
    case Condition::Test::all: return "all";
    case Condition::Test::any: return "any";
    }
    return "";
}

std::vector<std::string_view> parametersOf(const Condition& condition)
{
    std::vector<std::string_view> names;
    if (!condition.row.empty()) names.push_back(condition.row);
    for (const Condition& part : condition.parts)
        for (const std::string_view name : parametersOf(part)) names.push_back(name);
    return names;
}

}  // namespace vitrine
