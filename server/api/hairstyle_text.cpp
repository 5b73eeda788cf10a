#include "api/hairstyle_text.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "api/choices.hpp"
#include "api/tuft_text.hpp"
#include "api/write_nouns.hpp"
#include "gltf/json_text.hpp"

namespace tuftwave::server {
namespace {

using gltf::JsonText;

// Bytes that are written at most: of a character, of a fill without its names, of all the rest.
constexpr std::size_t kCharacterBytes = 6, kFillBytes = 1'024, kOtherBytes = 4'096;
constexpr std::size_t kTuftsAtOnce = 128;  // for a worker; a usual head has fewer and waits for none

JsonText& write(JsonText& to, const double value) { return to.number(value); }

JsonText& write(JsonText& to, const int value) { return to.number(value); }

JsonText& write(JsonText& to, const bool value) { return to.raw(value ? "true" : "false"); }

/// As extras_text() does: what readers might not hold as a whole number has a point.
JsonText& write(JsonText& to, const std::int64_t value) {
    if (value > std::numeric_limits<int>::max()) return to.number(static_cast<double>(value));
    return to.number(static_cast<int>(value));
}

JsonText& write(JsonText& to, const std::uint64_t value) { return write(to, static_cast<std::int64_t>(value)); }

JsonText& write(JsonText& to, const Vec3& v) {
    return to.open('[').next().number(v.x).next().number(v.y).next().number(v.z).close(']');
}

/// @param word  needs no escapes
JsonText& write(JsonText& to, const std::string_view word) { return to.raw("\"").raw(word).raw("\""); }

JsonText& write(JsonText& to, const FrameRate& fps) {
    return to.raw(gltf::extras_text(nlohmann::json(frame_rate_json(fps))));
}

template <class Value>
void write(JsonText& to, const std::string_view key, const Value& value) {
    write(to.key(key), value);
}

template <class Value>
void write(JsonText& to, const std::string_view key, const std::optional<Value>& value) {
    if (value) write(to, key, *value);
}

template <class Enum, std::size_t count>
void write(JsonText& to, const std::string_view key, const Choices<Enum, count>& choices, const Enum value) {
    write(to, key, word_of(choices, value));
}

template <class Enum, std::size_t count>
void write(JsonText& to, const std::string_view key, const Choices<Enum, count>& choices,
           const std::optional<Enum>& value) {
    if (value) write(to, key, choices, *value);
}

void write_fill(JsonText& to, const HairFill& fill, const Hairstyle& hairstyle) {
    const FillSettings& settings = fill.settings;
    to.next().open('{');
    write(to, "arc", kArcs, settings.arc);
    to.key("density").open('{');
    write(to, "along", settings.density.along.value_or(0));
    write(to, "crown", settings.density.crown.value_or(0));
    write(to, "neck", settings.density.neck.value_or(0));
    to.close('}');
    write(to, "direction", kFillDirections, settings.direction);
    if (settings.formulas != hairstyle.formulas) write(to, "formulas", kFormulas, settings.formulas);
    to.key("from").text(hairstyle.tufts[fill.from].name);
    if (settings.jitter_seed) {
        to.key("jitter").open('{');
        write(to, "seed", *settings.jitter_seed);
        to.close('}');
    }
    write(to, "min_gap", settings.min_gap);
    to.key("name").text(settings.name);
    write(to, "resample", settings.resample);
    write(to, "spacing", kSpacings, settings.spacing);
    if (fill.to) to.key("to").text(hairstyle.tufts[*fill.to].name);
    write(to, "tufts_per_meter", settings.tufts_per_meter);
    to.close('}');
}

void write_scalp(JsonText& to, const ScalpEllipsoid& ellipsoid) {
    to.key("ellipsoid").open('{');
    write(to, "center", ellipsoid.center);
    write(to, "radii", ellipsoid.radii);
    to.close('}');
}

void write_scalp(JsonText& to, const ScalpMesh& mesh) {
    to.key("mesh").open('{').key("positions").open('[');
    for (const Vec3& v : mesh.positions) to.next().number(v.x).next().number(v.y).next().number(v.z);
    to.close(']').key("triangles").open('[');
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t vertex : triangle) to.next().number(std::size_t{vertex});
    }
    to.close(']').close('}');
}

void write_head(JsonText& to, const Head& head) {
    to.key("head").open('{');
    write(to, "center", head.center);
    write(to, "diameter_at_100", head.diameter_at_100);
    write(to, "front", head.front);
    write(to, "root_depth", head.root_depth);
    if (!std::holds_alternative<std::monostate>(head.scalp)) {
        to.key("scalp").open('{');
        if (const auto* ellipsoid = std::get_if<ScalpEllipsoid>(&head.scalp)) write_scalp(to, *ellipsoid);
        if (const auto* mesh = std::get_if<ScalpMesh>(&head.scalp)) write_scalp(to, *mesh);
        to.close('}');
    }
    write(to, "up", head.up);
    to.close('}');
}

void write_mesh(JsonText& to, const MeshDetail& detail, const gltf::Look& look) {
    to.key("mesh").open('{');
    write(to, "color", std::string_view(look.color));
    write(to, "layout", kLayouts, look.layout);
    write(to, "rings", detail.rings);
    write(to, "sides", detail.sides);
    if (!detail.skin) write(to, "skin", false);
    write(to, "tolerance", detail.tolerance);
    to.close('}');
}

void write_phasing(JsonText& to, const Phasing& phase) {
    to.key("phase").open('{');
    write(to, "cycles", phase.cycles);
    write(to, "gust_wavelength", phase.gust_wavelength);
    write(to, "seed", phase.seed);
    write(to, "spread", phase.spread);
    write(to, "step", kPhaseSteps, phase.step);
    to.close('}');
}

void write_timing(JsonText& to, const Timing& timing) {
    to.key("timing").open('{');
    write(to, "fps", timing.fps);
    write(to, "hold", timing.hold);
    write(to, "period", timing.period);
    write(to, "sampling", kSamplings, timing.sampling);
    write(to, "short_holds", kShortHolds, timing.short_holds);
    to.close('}');
}

void write_wave(JsonText& to, const Wave& wave) {
    to.key("wave").open('{');
    write(to, "amplitude", wave.amplitude);
    write(to, "lightness", wave.lightness);
    write(to, "spatial_period", wave.spatial_period);
    write(to, "tip_exponent", wave.tip_exponent);
    to.close('}');
}

void write_motion(JsonText& to, const Motion& motion) {
    to.key("motion").open('{');
    write(to, "droop", kDroops, motion.droop);
    write(to, "lift", motion.lift);
    write(to, "mode", kModes, motion.mode);
    write(to, "one_sided", motion.one_sided);
    write_phasing(to, motion.phase);
    write_timing(to, motion.timing);
    write(to, "up", motion.up);
    write_wave(to, motion.wave);
    write(to, "wind", motion.wind);
    to.close('}');
}

std::size_t most_bytes(const Hairstyle& hairstyle) {
    std::size_t bytes = kOtherBytes;
    if (const auto* mesh = std::get_if<ScalpMesh>(&hairstyle.head.scalp)) {
        JsonText counted;  // since room for a million of the longest numbers would be twice as much as they need
        write_scalp(counted, *mesh);
        bytes += counted.bytes();
    }
    for (const HairFill& fill : hairstyle.fills) {
        const std::size_t to = fill.to ? hairstyle.tufts[*fill.to].name.size() : 0;
        const std::size_t letters = hairstyle.tufts[fill.from].name.size() + to + fill.settings.name.size();
        bytes += kFillBytes + letters * kCharacterBytes;
    }
    return bytes;
}

/// All but the tufts, up to the comma before them.
void append_settings(std::string& out, const Hairstyle& hairstyle, const gltf::Look& look) {
    const std::size_t before = out.size();
    out.resize(before + most_bytes(hairstyle));
    JsonText to(out.data() + before);
    to.open('{');
    if (!hairstyle.fills.empty()) {
        to.key("fills").open('[');
        for (const HairFill& fill : hairstyle.fills) write_fill(to, fill, hairstyle);
        to.close(']');
    }
    if (hairstyle.formulas != Formulas::kCorrected) write(to, "formulas", kFormulas, hairstyle.formulas);
    write_head(to, hairstyle.head);
    write_mesh(to, hairstyle.mesh, look);
    if (hairstyle.motion) write_motion(to, *hairstyle.motion);
    to.next();
    out.resize(before + to.bytes());
}

/// Texts of some tufts each, made side by side, since there are up to a million digits in them.
std::vector<std::string> tuft_texts(const std::vector<Tuft>& tufts, const ForEach& for_each) {
    std::vector<std::string> texts((tufts.size() + kTuftsAtOnce - 1) / kTuftsAtOnce);
    for_each(texts.size(), [&](const std::size_t i) {
        const std::size_t begin = i * kTuftsAtOnce, end = std::min(tufts.size(), begin + kTuftsAtOnce);
        for (std::size_t tuft = begin; tuft < end; ++tuft) {
            if (tuft > 0) texts[i] += ',';
            append_tuft(texts[i], tufts[tuft]);
        }
    });
    return texts;
}

}  // namespace

void append_hairstyle(std::string& out, const Hairstyle& hairstyle, const gltf::Look& look, const ForEach& for_each) {
    append_settings(out, hairstyle, look);
    out += "\"tufts\":[";
    const std::vector<std::string> texts = tuft_texts(hairstyle.tufts, for_each);
    std::size_t bytes = out.size() + kOtherBytes;  // room for what comes behind, too
    for (const std::string& some : texts) bytes += some.size();
    out.reserve(bytes);
    for (const std::string& some : texts) out += some;
    out += "]}";
}

}  // namespace tuftwave::server
