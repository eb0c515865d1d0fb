#include "exhibits/framework/table/parameters.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>

namespace vitrine {
namespace {

double clampNumber(const ParameterInfo& parameter, double x)
{
    if (parameter.wordFor(x)) return x;
    const double inside = std::clamp(x, parameter.range.low, parameter.range.high);
    return parameter.kind == Kind::real ? inside : std::round(inside);
}

bool isFinite(const glm::dvec3& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

std::string_view toString(Kind kind)
{
    switch (kind) {
    case Kind::real: return "real";
    case Kind::count: return "count";
    case Kind::toggle: return "toggle";
    case Kind::choice: return "choice";
    case Kind::color: return "color";
    case Kind::direction: return "direction";
    case Kind::file: return "file";
    case Kind::text: return "text";
    }
    return "";
}

std::string_view toString(Scale scale)
{
    return scale == Scale::linear ? "linear" : "logarithmic";
}

bool isParameterName(std::string_view name)
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !name.empty() && name.size() <= 64 && isLetter(name.front()) &&
           std::all_of(name.begin(), name.end(), [&](char c) { return isLetter(c) || (c >= '0' && c <= '9'); });
}

namespace {

/// Returns "Shell count" for "shellCount".
std::string spelledOut(std::string_view name)
{
    std::string text;
    for (const char c : name) {
        const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
        if (upper && !text.empty()) text += ' ';
        const int shownAs =
            text.empty() ? std::toupper(static_cast<unsigned char>(c)) : std::tolower(static_cast<unsigned char>(c));
        text += static_cast<char>(shownAs);
    }
    return text;
}

}  // namespace

std::string label(const ParameterInfo& parameter)
{
    return parameter.label.empty() ? spelledOut(parameter.name) : std::string(parameter.label);
}

std::string labelInGroup(const ParameterInfo& parameter)
{
    if (!parameter.array.empty() && parameter.label.empty()) return spelledOut(parameter.elementParameter);
    std::string text = label(parameter);
    const std::size_t end = text.find(' ');
    if (end == std::string::npos) return text;
    const std::string first = text.substr(0, end);
    // The word must be a whole word of the heading; the case of its first letter is ignored: "Ball" in "Coat of the
    // ball".
    const auto lower = [](unsigned char c) { return std::tolower(c); };
    for (std::size_t from = 0; from <= parameter.group.size();) {
        const std::size_t to = std::min(parameter.group.find(' ', from), parameter.group.size());
        const std::string_view word = parameter.group.substr(from, to - from);
        if (std::equal(word.begin(), word.end(), first.begin(), first.end(), [&](char a, char b) {
                return lower(static_cast<unsigned char>(a)) == lower(static_cast<unsigned char>(b));
            })) {
            text.erase(0, end + 1);
            text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
            return text;
        }
        from = to + 1;
    }
    return text;
}

std::vector<std::string> linesOf(std::string_view value)
{
    std::vector<std::string> lines;
    while (!value.empty()) {
        const std::size_t end = std::min(value.find('\n'), value.size());
        if (end > 0) lines.emplace_back(value.substr(0, end));
        value.remove_prefix(std::min(end + 1, value.size()));
    }
    return lines;
}

const Word* ParameterInfo::wordFor(double value) const
{
    const auto found = std::find_if(words.begin(), words.end(), [&](const Word& word) { return word.value == value; });
    return found == words.end() ? nullptr : &*found;
}

std::optional<Value> nearestLegal(const ParameterInfo& parameter, const Value& value)
{
    switch (parameter.kind) {
    case Kind::real:
    case Kind::count:
    case Kind::toggle:
    case Kind::choice: {
        const double* x = std::get_if<double>(&value);
        if (!x || std::isnan(*x)) return std::nullopt;
        return clampNumber(parameter, *x);
    }
    case Kind::color: {
        const glm::dvec3* v = std::get_if<glm::dvec3>(&value);
        if (!v || !isFinite(*v)) return std::nullopt;
        return glm::clamp(*v, 0.0, 1.0);
    }
    case Kind::direction: {
        const glm::dvec3* v = std::get_if<glm::dvec3>(&value);
        if (!v || !isFinite(*v)) return std::nullopt;
        const double length = glm::length(*v);
        if (!(length > 1e-12) || !std::isfinite(length)) return std::nullopt;
        // A direction that is already unit length keeps its bits, so that presets round-trip.
        return std::abs(length - 1) < 1e-12 ? *v : *v / length;
    }
    case Kind::file:
    case Kind::text: {
        const std::string* path = std::get_if<std::string>(&value);
        if (!path) return std::nullopt;
        return *path;
    }
    }
    return std::nullopt;
}

std::optional<std::size_t> Parameters::find(std::string_view name) const
{
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const ParameterInfo& r) { return r.name == name; });
    if (row == rows_.end()) return std::nullopt;
    return static_cast<std::size_t>(row - rows_.begin());
}

ParameterValues Parameters::initial() const
{
    return ParameterValues(*this);
}

Parameters::Group Parameters::group(std::string_view title)
{
    group_ = owned(title);
    return {group_};
}

void Parameters::beginElement(std::string_view array, std::size_t index, const Element& element)
{
    assert(array_.empty() || index > 0);  // No array within an array.
    group(element.heading);
    array_ = owned(array);
    element_ = index;
    elementName_ = owned(element.name);
}

void Parameters::endArray()
{
    group_ = array_ = elementName_ = {};
    element_ = 0;
}

std::string_view Parameters::owned(std::string_view text)
{
    const auto known = texts_.find(text);
    return known != texts_.end() ? *known : *texts_.emplace(text).first;
}

void Parameters::own(Condition& condition)
{
    condition.row = owned(condition.row);
    for (Condition& part : condition.parts) own(part);
}

std::uint16_t Parameters::appendParameter(ParameterInfo row)
{
    if (!array_.empty()) {
        row.array = array_;
        row.element = element_;
        row.elementParameter = owned(row.name);
        const auto inElement = [this](std::string_view name) {
            if (elementName_.empty()) return owned(name);
            const char first = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
            return owned(std::string(elementName_) + first + std::string(name.substr(1)));
        };
        row.name = inElement(row.name);
    }
    for (std::string_view* text :
         {&row.name, &row.group, &row.help, &row.label, &row.extensions, &row.assetFolder, &row.documentOf})
        *text = owned(*text);
    for (std::string_view& choice : row.choices) choice = owned(choice);
    for (Word& word : row.words) word.text = owned(word.text);
    for (std::string_view* text : {&row.given.option, &row.given.tuple}) *text = owned(*text);
    for (Implication& implied : row.given.implies) implied.parameter = owned(implied.parameter);
    if (row.actsWhen) own(*row.actsWhen);

    assert(isParameterName(row.name));
    assert(!find(row.name) && "two parameters share a name");
    assert(row.range.low <= row.range.softLow && row.range.softHigh <= row.range.high);
    assert(row.range.scale == Scale::linear || row.range.softLow > 0);
    assert(nearestLegal(row, row.initial).has_value());
    assert(row.words.empty() || row.isNumeric());
    assert(!row.several || row.isWritten());
    assert(row.given.tuple.empty() || row.isNumeric() || row.kind == Kind::file);
    rows_.push_back(std::move(row));
    return static_cast<std::uint16_t>(rows_.size() - 1);
}

std::string_view whyUnmoved(const ParameterInfo& parameter)
{
    if (parameter.isWritten()) return "A file cannot be animated, because each value would have to be read.";
    if (parameter.qualityReference)
        return "An accuracy parameter cannot be animated, because it sets the cost of the picture.";
    return {};
}

ParameterValues::ParameterValues(const Parameters& table)
    : ParameterValues(std::shared_ptr<const Parameters>(table.weak_from_this().lock(), &table))
{
}

ParameterValues::ParameterValues(std::shared_ptr<const Parameters> table) : table_(std::move(table))
{
    values_.reserve(rows().size());
    for (const ParameterInfo& parameter : rows()) values_.push_back(parameter.initial);
}

std::vector<std::string> ParameterValues::tableFiles() const
{
    std::vector<std::string> files;
    for (std::size_t i = 0; i < rows().size(); ++i)
        if (rows()[i].addsParameters) files.push_back(std::get<std::string>(values_[i]));
    return files;
}

bool ParameterValues::operator==(const ParameterValues& other) const
{
    if (values_ != other.values_ || pending_ != other.pending_) return false;
    if (motions_ != other.motions_ || pendingMotions_ != other.pendingMotions_) return false;
    return table_ == other.table_ ||
           std::equal(rows().begin(), rows().end(), other.rows().begin(), other.rows().end(),
                      [](const ParameterInfo& a, const ParameterInfo& b) { return a.name == b.name; });
}

bool ParameterValues::setParameter(std::size_t i, const Value& value)
{
    const std::optional<Value> legal = nearestLegal(rows()[i], value);
    if (!legal) return false;
    values_[i] = *legal;
    return *legal == value;
}

const Motion* ParameterValues::motion(std::size_t i) const
{
    if (motions_.empty()) return nullptr;
    const auto found = motions_.find(rows()[i].name);
    return found == motions_.end() ? nullptr : &found->second;
}

bool ParameterValues::setMotion(std::size_t i, std::optional<Motion> motion)
{
    const ParameterInfo& row = rows()[i];
    if (!motion) {
        motions_.erase(std::string(row.name));
        return true;
    }
    const std::optional<Value> from = nearestLegal(row, motion->from), to = nearestLegal(row, motion->to);
    if (!whyUnmoved(row).empty() || !from || !to) return false;
    motion->from = *from;
    motion->to = *to;
    motions_.insert_or_assign(std::string(row.name), std::move(*motion));
    return true;
}

bool ParameterValues::chooseFile(std::size_t i, const Value& value)
{
    if (value != values_[i])
        for (std::size_t r = 0; r < rows().size(); ++r)
            if (rows()[r].documentOf == rows()[i].name) resetParameter(r);
    return setParameter(i, value);
}

void ParameterValues::resetParameter(std::size_t i)
{
    values_[i] = rows()[i].initial;
}

bool ParameterValues::isInitial(std::size_t i) const
{
    return values_[i] == rows()[i].initial;
}

}  // namespace vitrine
