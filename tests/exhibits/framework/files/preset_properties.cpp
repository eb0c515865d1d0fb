#include "exhibits/framework/files/preset.h"
#include "exhibits/framework/table/value_text.h"
#include "tests/exhibits/framework/table/every_kind.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>  // After gtest, which it needs.

#include <cmath>

namespace {

using namespace vitrine;
using render::Json;
using test::everyKind;

/// Generates any legal value of a parameter.
rc::Gen<Value> legalValue(const ParameterInfo& parameter)
{
    return rc::gen::exec([&parameter]() -> Value {
        const auto fraction = [] { return *rc::gen::inRange<int>(0, 1'000'001) / 1e6; };
        const auto number = [] { return *rc::gen::arbitrary<double>(); };
        Value value = 0.0;
        if (parameter.kind == Kind::color)
            value = glm::dvec3(fraction(), fraction(), fraction());
        else if (parameter.kind == Kind::direction)
            value = glm::dvec3(fraction() - 0.5, fraction() - 0.5, 1.0);
        else if (parameter.isWritten())
            value = *rc::gen::string<std::string>();
        else if (*rc::gen::arbitrary<bool>())
            value = number();
        else
            value = parameter.range.low + fraction() * (parameter.range.high - parameter.range.low);
        const std::optional<Value> legal = nearestLegal(parameter, value);
        return legal ? *legal : parameter.initial;
    });
}

rc::Gen<ParameterValues> legalValues()
{
    return rc::gen::exec([]() {
        ParameterValues values = everyKind.initial();
        for (std::size_t i = 0; i < values.rows().size(); ++i) {
            if (values.rows()[i].isWritten())
                values.setParameter(i, std::string("picture ") + std::to_string(*rc::gen::inRange(0, 99)) + ".png");
            else if (*rc::gen::arbitrary<bool>())
                values.setParameter(i, *legalValue(values.rows()[i]));
        }
        return values;
    });
}

/// Generates any JSON of limited depth.
rc::Gen<Json> anyJson(int depth)
{
    return rc::gen::exec([depth]() -> Json {
        switch (*rc::gen::inRange(0, depth > 0 ? 7 : 5)) {
        case 0: return nullptr;
        case 1: return *rc::gen::arbitrary<bool>();
        case 2: return *rc::gen::arbitrary<std::int64_t>();
        case 3: {
            const double x = *rc::gen::arbitrary<double>();
            return std::isfinite(x) ? x : 0.0;
        }
        case 4: return "text " + std::to_string(*rc::gen::inRange(0, 999));
        case 5: {
            Json array = Json::array();
            for (int n = *rc::gen::inRange(0, 4); n > 0; --n) array.push_back(*anyJson(depth - 1));
            return array;
        }
        default: {
            Json object = Json::object();
            for (int n = *rc::gen::inRange(0, 4); n > 0; --n)
                object["k" + std::to_string(*rc::gen::inRange(0, 99))] = *anyJson(depth - 1);
            return object;
        }
        }
    });
}

RC_GTEST_PROP(PresetProperty, EveryLegalSetOfValuesReadsBackBitForBit, ())
{
    const Preset preset{"everything", "A", *legalValues(), std::nullopt, Json::object(), {}};
    const Preset back = parsePreset(presetText(preset), "a.json", "everything", everyKind);
    RC_ASSERT(back.values == preset.values);
    RC_ASSERT(back.notes.empty());
}

TEST(PresetProperty, ANumberIsRoundedOnce)
{
    // With a 64-bit mantissa in between, this value became the next double.
    const std::size_t tint = *everyKind.find("tint");
    const Value color = glm::dvec3(0, 0, 0.024421);
    EXPECT_EQ(parseValue(everyKind.rows()[tint], formatValue(everyKind.rows()[tint], color)), color);
}

RC_GTEST_PROP(PresetProperty, EveryValueReadsBackFromItsText, ())
{
    const ParameterValues values = *legalValues();
    for (std::size_t i = 0; i < values.rows().size(); ++i) {
        const std::optional<Value> back = parseValue(values.rows()[i], formatValue(values.rows()[i], values.row(i)));
        RC_ASSERT(back.has_value());
        RC_ASSERT(*back == values.row(i));
    }
}

RC_GTEST_PROP(PresetProperty, UnknownKeysSurviveLoadingEditingAndSaving, ())
{
    Json root = Json::parse(
        R"({"format": "vitrine-preset", "version": 1, "exhibit": "everything", "name": "A", "values": {"morph": 0.75}})");
    for (int n = *rc::gen::inRange(0, 5); n > 0; --n)
        root["values"]["unknown" + std::to_string(*rc::gen::inRange(0, 99))] = *anyJson(4);
    for (int n = *rc::gen::inRange(0, 5); n > 0; --n)
        root["unknown" + std::to_string(*rc::gen::inRange(0, 99))] = *anyJson(4);
    Preset preset = parsePreset(render::writeJson(root), "a.json", "everything", everyKind);
    preset.values.set(everyKind.exposure, 1.0);
    const Json back = Json::parse(presetText(preset));
    for (const auto& [key, value] : root["values"].items()) RC_ASSERT(back["values"][key].dump() == value.dump());
    for (const auto& [key, value] : root.items()) {
        if (key.starts_with("unknown")) RC_ASSERT(back[key].dump() == value.dump());
    }
}

}  // namespace
