#include "api/character_settings.hpp"

#include <array>

#include "api/choices.hpp"
#include "api/read_nouns.hpp"

namespace tuftwave::server {
namespace {

constexpr Choices<Springs, 2> kSpringChoices{{{"keep", Springs::kKeep}, {"remove", Springs::kRemove}}};
constexpr std::size_t kLongestChainList = 1024, kLongestKindList = 64, kLongestClipName = 64;  // characters

constexpr std::array<QueryField, 28> kQueryFields{{{"amplitude", "/motion/wave/amplitude"},
                                                   {"spatial_period", "/motion/wave/spatial_period"},
                                                   {"lightness", "/motion/wave/lightness"},
                                                   {"tip_exponent", "/motion/wave/tip_exponent"},
                                                   {"period", "/motion/timing/period"},
                                                   {"fps", "/motion/timing/fps"},
                                                   {"hold", "/motion/timing/hold"},
                                                   {"short_holds", "/motion/timing/short_holds"},
                                                   {"sampling", "/motion/timing/sampling"},
                                                   {"mode", "/motion/mode"},
                                                   {"wind", "/motion/wind"},
                                                   {"up", "/motion/up"},
                                                   {"droop", "/motion/droop"},
                                                   {"one_sided", "/motion/one_sided"},
                                                   {"lift", "/motion/lift"},
                                                   {"phase_step", "/motion/phase/step"},
                                                   {"gust_wavelength", "/motion/phase/gust_wavelength"},
                                                   {"spread", "/motion/phase/spread"},
                                                   {"seed", "/motion/phase/seed"},
                                                   {"cycles", "/motion/phase/cycles"},
                                                   {"phases", "/phases", QueryValue::kNumbers},
                                                   {"formulas", "/formulas"},
                                                   {"repeat", "/repeat"},
                                                   {"interpolation", "/interpolation", QueryValue::kText},
                                                   {"chains", "/chains", QueryValue::kText},
                                                   {"kinds", "/kinds", QueryValue::kText},
                                                   {"springs", "/springs", QueryValue::kText},
                                                   {"clip_name", "/clip_name", QueryValue::kText}}};

}  // namespace

std::span<const QueryField> character_query() { return kQueryFields; }

std::variant<CharacterSettings, Problem> read_character_settings(const Request& request, const Limits& limits) {
    for (const auto& [name, value] : request.query) {
        if (value.empty())
            return fields_problem({{ProblemCode::kWrongType, "?" + name.substr(0, 64), "", "a value", {}, {}}});
    }
    const JsonDocument body = query_body(request, kQueryFields);
    CharacterSettings read;
    FieldProblems problems;
    const Place root;
    Fields fields(body.root(), root, problems);
    fields.member("motion", [&](const JsonValue motion, const Place& place) {
        read_motion(motion, place, problems, limits, read.motion);
    });
    read_formulas(fields, read.formulas);
    fields.text("chains", kLongestChainList, read.choice.chains);
    fields.text("kinds", kLongestKindList, read.choice.kinds);
    fields.numbers("phases", limits.chains, limits.phase, read.phases);
    fields.choice("springs", kSpringChoices, read.springs);
    fields.text("clip_name", kLongestClipName, read.clip_name);
    if (problems.empty()) return read;
    return as_query_problem(fields_problem(problems.take()), kQueryFields, request);
}

}  // namespace tuftwave::server
